"""The table of the trials."""

import csv

import pytest
from ichnograph.algorithms.registration.simulation.simulation import SUCCESS
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
