"""The page and the table of a simulation."""

import csv

import pytest
from ichnograph.algorithms.registration.simulation.simulation import SUCCESS
from ichnograph.algorithms.registration.simulation.simulation_report import write_simulation_report
from ichnograph.algorithms.registration.simulation.trials import write_trials
from ichnograph.tests.algorithms.registration.simulation.simulated import FEW


def test_the_table_has_a_row_for_each_trial(found, box, tmp_path):
    write_trials(found, tmp_path / "found.csv")
    write_trials(box, tmp_path / "box.csv")

    with (tmp_path / "found.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["trial"] for row in rows] == [str(number) for number in range(1, FEW + 1)]
    assert [tuple(row["points"].split(";")) for row in rows] == [trial.points for trial in found.trials]
    assert {(row["outcome"], row["success"], row["wrong"]) for row in rows} == {(SUCCESS, "1", "0")}
    assert float(rows[0]["shift_error"]) == pytest.approx(found.trials[0].shift_error, abs=1e-6)
    with (tmp_path / "box.csv").open(encoding="utf-8", newline="") as file:
        refused = next(csv.DictReader(file))
    assert (refused["outcome"], refused["success"], refused["sigma0"]) == ("ambiguous", "0", "")


def test_the_report_names_failures_and_ambiguous_points(box, tmp_path):
    write_simulation_report(box, tmp_path / "box.html")

    page = (tmp_path / "box.html").read_text(encoding="utf-8")
    for words in ("In 0 of 5 trials (0.0%) all 8 targets", "ambiguous", "Points taken for each other", "P7"):
        assert words in page
    assert "Errors of the transformations" not in page


def test_the_report_of_a_good_layout_has_errors_and_no_failures(found, tmp_path):
    write_simulation_report(found, tmp_path / "found.html")

    page = (tmp_path / "found.html").read_text(encoding="utf-8")
    assert "(100.0%)" in page
    assert "No control points were taken for each other." in page
    assert "Errors of the transformations" in page
    assert "Failures" not in page
    assert "nan" not in page
