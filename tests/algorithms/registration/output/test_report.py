"""The report: everything that was found, on one page."""

import re
from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.adjustment.settings import AdjustmentSettings, OutlierTestSettings
from ichnograph.algorithms.registration.output.report import write_report
from ichnograph.algorithms.registration.results import GlobalTest, ScaleTest, SharedSurfaces
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.algorithms.reporting.numbers import MISSING
from ichnograph.tests.algorithms.registration.made_registrations import (
    CORNER,
    correspondence,
    refused,
    registration,
    rejected,
    scan,
)
from scipy import stats


@pytest.fixture
def report(tmp_path):
    """Write a report, and return its text."""

    def report(result):
        write_report(result, tmp_path / "report.html")
        return (tmp_path / "report.html").read_text(encoding="utf-8")

    return report


def plain(text):
    """Return what a reader sees, without the drawings."""
    text = re.sub(r"<(style|svg).*?</\1>", " ", text, flags=re.DOTALL)
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", text))


def of_one_scan(*correspondences, **changes):
    changes = {"targets": len(correspondences), **changes}
    return replace(registration(1), scans=(scan("S01", correspondences, CORNER, **changes),))


THREE = tuple(
    correspondence(f"T{row}", f"P{row}", CORNER + offset, (0.001, 0.002, -0.002))
    for row, offset in enumerate([(5, 0, 0), (0, 7, 1), (-4, -3, 2)])
)


def test_the_page_stands_alone(report):
    text = report(registration(3))

    assert not re.search(r"(?i)https?:|<script|<link|src=|url\(|@import", text)
    targets = re.findall(r'href="#([^"]*)"', text)
    assert targets and all(f'id="{target}"' in text for target in targets)


def test_the_same_registration_makes_the_same_bytes(report):
    assert report(registration(3)) == report(registration(3))


def test_every_scan_is_summed_up_in_a_row(report):
    text = plain(report(registration(2, more=[refused("S99")])))

    assert "2 of 3 scans are registered" in text
    assert "S01 registered 7 6 0 1 1 0.87 0.690" in text
    assert "S02 registered 7 5 1 1 1 0.87 0.690" in text
    assert "12 ± 45" in text
    assert "3e-07" in text
    assert f"S99 ambiguous 8 {MISSING} {MISSING}" in text


def test_settings_and_the_tolerance_that_was_used_are_listed(report):
    text = plain(report(registration(1)))

    for part in (
        "by distances",
        "rigid, 6 parameters",
        "3 mm",
        "0, held fixed",
        "14.8 mm, derived",
        "EPSG:25833",
    ):
        assert part in text
    chosen = Settings(Matching.NAMES, Model.LEVELLED_SCALE, 0.002, 0.001, 0.01)
    text = plain(report(replace(registration(1), settings=chosen, tolerance=0.01, crs=None)))
    for part in ("by names", "levelled with a scale near 1, 5", "2 mm", "1 mm", "10.0 mm, chosen", "none"):
        assert part in text


def test_there_are_a_plan_of_all_and_a_plan_and_two_charts_of_each_scan(report):
    text = report(registration(3, more=[refused()]))

    assert text.count("<svg") == 1 + 3 * 3
    assert text.count("(figure 6)") == text.count("(figure 7)") == text.count("(figure 8)") == 3
    assert text.count("figure 6 of the paper") == 1


def test_residuals_are_in_millimetres_and_tests_beside_them(report):
    text = plain(report(of_one_scan(*THREE)))

    assert "T0 P0 surveyed 1.0 2.0 -2.0 3.0 8.4 5.6 2.8" in text
    assert "T0 0.60 0.70 0.65 0.42 0.83 -0.83 0.37 0.74 -0.74 16.0 15.0 15.5" in text


def test_a_rejected_target_is_marked_and_explained(report):
    text = report(of_one_scan(*THREE, rejected("T9", "P9", CORNER + (3, 3, 3), (0.3, 0.0, 0.0))))

    assert '<tr class="marked"><td class="w">T9</td>' in text
    assert "T9 = P9 was rejected: it is 0.300 m off, |w| 125.0." in text
    assert "Crosses: rejected targets." in text


def test_a_doubtful_number_is_marked(report):
    doubtful = replace(
        THREE[0],
        redundancy=np.array([0.05, 0.5, 0.5]),
        normalized=np.array([0.1, -3.4, 0.2]),
        studentized=np.array([0.1, 0.2, 9.9]),
    )
    text = report(of_one_scan(doubtful, *THREE[1:]))

    assert re.findall(r'<b class="red">(.*?)</b>', text) == ["0.05", "-3.40", "9.90"]


def test_a_refused_scan_teaches_with_its_reason_and_rivals(report):
    rivals = ({"T1": "P1", "T2": "P2"}, {"T1": "P2", "T2": "P1"})
    text = plain(report(registration(1, more=[refused("S99", rivals=rivals, warnings=("Look here.",))])))

    assert "S99: ambiguous Two solutions fit: measure another target. Look here." in text
    assert "T1 = P1, T2 = P2 T1 = P2, T2 = P1" in text


def test_of_very_many_rivals_the_rest_is_counted(report):
    rivals = tuple({"T1": f"P{number}"} for number in range(48))

    assert "and 36 more" in plain(report(registration(1, more=[refused("S99", rivals=rivals)])))


def test_parameters_have_standard_deviations_and_correlations(report):
    text = plain(report(registration(1)))

    assert "shift x 1.5000 0.0012 m" in text
    assert "rotation z 1.500000 0.001200 °" in text
    assert "rotation z 0.00 0.00 0.00 0.00 0.00" in text


def test_warnings_and_the_advice_about_the_scale_are_shown(report):
    advice = ScaleTest(120.0, 20.0, True, "The scale differs from 1.")
    result = of_one_scan(*THREE, scale_test=advice, warnings=("T7 is weak.",))
    text = plain(report(replace(result, warnings=("Two points are one.",))))

    for part in ("The scale differs from 1.", "120 ± 20", "T7 is weak.", "Two points are one."):
        assert part in text


def test_what_is_not_known_is_a_dash(report):
    unknown = GlobalTest(0.0, 0.0, float("nan"), float("nan"))
    result = of_one_scan(*THREE, test=unknown, scale_test=None, chance=None)
    text = plain(report(replace(result, test=unknown)))

    assert "S01 registered 3 3 0 0 1 _ _ 3.0 _ _".replace("_", MISSING) in text
    assert "nan" not in text
    assert text.count("nothing is redundant") == 2


def test_the_legend_names_the_critical_values(report):
    text = plain(report(registration(1)))

    for part in ("3.29", "4.13", "2.448", "2.795", "80 %"):
        assert part in text


def test_the_limits_are_those_that_the_registration_was_run_with(report):
    tests = OutlierTestSettings(significance=0.01, power=0.9, global_significance=0.2, weak_redundancy=0.62)
    settings = Settings(adjustment=AdjustmentSettings(tests=tests))
    doubtful = replace(THREE[0], normalized=np.array([2.7, 0.1, 0.1]))
    text = report(replace(of_one_scan(doubtful, *THREE[1:]), settings=settings))

    for part in (f"suspected beyond {stats.norm.isf(0.005):.2f}", "power of 90 %", "level of 20 %"):
        assert part in plain(text)
    # Each of the three has a redundancy number of 0.60.
    assert re.findall(r'<b class="red">(.*?)</b>', text) == ["0.60", "2.70", "0.60", "0.60"]


def test_appended_points_are_listed_with_their_precision_and_drawn_with_ellipses(report):
    text = report(registration(2))

    assert "S02:T9 S02" in plain(text)
    # Only ellipses are curves in that colour without a filling.
    assert len(re.findall(r'<path d="[^"]*C[^"]*" style="fill: none; stroke: #8a6bb0', text)) == 2
    assert "ellipses drawn" in text


def test_names_are_escaped_everywhere(report):
    evil = '<img src=x>&"'
    items = [replace(item, target=f"{evil}{row}", control=f"{evil}{row}") for row, item in enumerate(THREE)]
    result = of_one_scan(*items, warnings=(evil,), unmatched=(evil,))
    result = replace(result, scans=(replace(result.scans[0], name=evil), refused(evil + "2", reason=evil)))

    assert "<img" not in report(result)


def test_a_scan_whose_origin_is_no_station_does_not_spoil_the_plan(report):
    far = np.eye(4)
    far[:3, 3] = (7e6, 7e6, 0)
    text = report(of_one_scan(*THREE, matrix=far))

    assert re.search(r">(\d+) m</text>", text).group(1) in ("1", "2", "5")


def test_scans_in_one_place_and_without_residuals_can_be_drawn(report):
    same = [replace(item, position=CORNER, residual=np.zeros(3)) for item in THREE]

    assert "<svg" in report(replace(of_one_scan(*same), points=()))


def test_a_large_registration_stays_readable_and_small(report):
    text = report(registration(50, targets=20))

    assert len(text) < 2_500_000
    assert text.count("<svg") == 1 + 3 * 50


def test_a_report_that_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(InputError, match="folder does not exist"):
        write_report(registration(1), tmp_path / "nowhere" / "report.html")


def test_the_surfaces_that_scans_share_are_a_table(report):
    shared = SharedSurfaces(("S01", "S02"), 0.25, 80, 0.0012, np.zeros((0, 3)))
    sliding = SharedSurfaces(("S02", "S03"), 0.5, 40, 0.002, np.array([[1.0, 0.0, 0.0]]))
    made = replace(registration(3), surfaces=(shared, sliding))
    text = plain(report(made))

    assert "S01 S02 80 25 1.20 no" in text
    assert "S02 S03 40 50 2.00 yes" in text
    assert "Surfaces that tie" not in plain(report(registration(3)))
