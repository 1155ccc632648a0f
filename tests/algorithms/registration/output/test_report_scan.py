"""What the report says about a single scan."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.settings import AdjustmentSettings, OutlierTestSettings
from ichnograph.algorithms.registration.output.report_scan import change_by_surfaces, scan_content, verdict
from ichnograph.algorithms.registration.results import GlobalTest, SurfaceChange
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.algorithms.reporting.numbers import MISSING
from ichnograph.tests.algorithms.registration.made_registrations import (
    CORNER,
    correspondence,
    refused,
    registration,
    rejected,
    scan,
)

SEEN = tuple(
    correspondence(f"T{row}", f"P{row}", CORNER + offset)
    for row, offset in enumerate([(5, 0, 0), (0, 7, 1), (-4, -3, 2)])
)
OFF = rejected("T9", "P9", CORNER + (3, 3, 3), (0.3, 0.0, 0.0))


def content(made, settings=Settings()):
    return scan_content(made, replace(registration(1), scans=(made,), settings=settings))


def doubtful(rows):
    """Return the targets and texts of the numbers that the reader should doubt."""
    return [(target, item.text) for target, items in rows for item in items if item.doubtful]


def test_how_the_scan_was_matched_is_said_in_sentences():
    appended = replace(SEEN[2], surveyed=False)
    made = scan("S01", (*SEEN[:2], appended, OFF), CORNER, round=2, unmatched=("T5", "T6"), targets=6)

    assert content(made)["matched"] == (
        "Registered in round 2 with 3 of 6 targets, of which 2 are surveyed points. "
        "Expected accidental matches of so many targets: 3e-07. "
        "Appended to the control points: T5, T6."
    )
    by_names = replace(made, chance=None, unmatched=())
    assert content(by_names)["matched"].endswith("surveyed points.")


def test_correlations_are_the_lower_half_of_the_matrix():
    values = np.eye(6)
    values[2, 0] = -0.25
    rows = content(scan("S01", SEEN, CORNER, correlations=values))["correlations"]

    assert [row[0] for row in rows] == ["shift y", "shift z", "rotation x", "rotation y", "rotation z"]
    assert rows[1] == ("shift z", "-0.25", "0.00", "", "", "")
    assert rows[0] == ("shift y", "0.00", "", "", "", "")


def test_parameters_have_the_decimals_of_their_unit():
    made = scan("S01", SEEN, CORNER)
    scale = replace(made.estimates[0], name="scale", value=1.0001, std=2e-5)
    rows = content(replace(made, estimates=(*made.estimates, scale), correlations=np.eye(7)))["parameters"]

    assert rows[0] == ("shift x", "1.5000", "0.0012", "m")
    assert rows[3] == ("rotation x", "1.500000", "0.001200", "\N{DEGREE SIGN}")
    assert rows[6] == ("scale", "1.00010000", "0.00002000", "")


def test_a_rejected_target_is_said_how_far_it_is_off_and_marked():
    found = content(scan("S01", (SEEN[0], OFF, *SEEN[1:]), CORNER))

    assert found["rejected"] == ["T9 = P9 was rejected: it is 0.300 m off, |w| 125.0."]
    assert found["rejected_rows"] == [1]


def test_residuals_are_millimetres_with_the_semi_axes_of_the_ellipsoid():
    (row, *_others) = content(scan("S01", SEEN, CORNER))["residuals"]

    # Of variances 9, 4 and 1 mm2, times 2.795.
    assert row == ("T0", "P0", "surveyed", "1.0", "-2.0", "0.5", "2.3", "8.4", "5.6", "2.8")


def test_numbers_beyond_their_limits_are_doubtful():
    weak = replace(
        SEEN[0],
        redundancy=np.array([0.09, 0.1, 0.5]),
        normalized=np.array([-3.30, 3.28, np.nan]),
        studentized=np.array([0.0, 0.0, 2.9]),
    )
    found = content(scan("S01", (weak, *SEEN[1:]), CORNER))

    assert doubtful(found["reliability"]) == [("T0", "0.09"), ("T0", "-3.30"), ("T0", "2.90")]
    assert found["critical_tau"] == "2.77"
    assert [item.text for item in found["reliability"][0][1]][5] == MISSING


def test_the_limits_are_those_of_the_registrations_settings():
    tests = OutlierTestSettings(significance=0.05, weak_redundancy=0.62)
    found = content(scan("S01", SEEN, CORNER), Settings(adjustment=AdjustmentSettings(tests=tests)))

    assert doubtful(found["reliability"]) == [(f"T{row}", "0.60") for row in range(3)]
    assert float(found["critical_tau"]) < 2.0


def test_a_scan_without_a_transformation_has_no_content():
    with pytest.raises(ValueError, match="S99 is not registered"):
        content(refused("S99"))


@pytest.mark.parametrize(
    ("probability", "words"),
    [(0.024, "larger than"), (0.026, "agree with"), (0.974, "agree with"), (0.976, "smaller")],
)
def test_the_global_test_has_a_limit_on_both_sides(probability, words):
    assert words in verdict(GlobalTest(10.0, 9.0, 1.05, probability))


def test_the_verdict_gives_its_numbers_or_says_that_there_are_none():
    said = verdict(GlobalTest(10.0, 9.0, 1.05, 0.5))

    assert said.endswith("(sigma0 1.05, redundancy 9.0, v'Pv 10.00, chi-square probability 0.500).")
    assert "nothing is redundant" in verdict(GlobalTest(0.0, 0.0, np.nan, np.nan))


def test_the_level_of_the_global_test_can_be_chosen():
    test = GlobalTest(10.0, 9.0, 1.05, 0.04)

    assert "agree with" in verdict(test)
    assert "larger than" in verdict(test, OutlierTestSettings(global_significance=0.1))


def test_what_surfaces_changed_is_said_also_if_the_targets_rule_it_out():
    used = change_by_surfaces(SurfaceChange(shift=0.0123, sigmas=1.4, std=0.02, used=True))
    refused = change_by_surfaces(SurfaceChange(shift=0.3, sigmas=9.0, std=0.02, used=False))

    assert used.startswith("Surfaces moved its targets by up to 12.3 mm, 1.40 standard deviations;")
    assert refused.startswith(
        "Surfaces would move its targets by up to 300.0 mm, 9.00 standard deviations, and are"
    )
