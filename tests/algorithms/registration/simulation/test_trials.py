"""The table of a simulation."""

import csv

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.algorithms.registration.simulation.simulation import SUCCESS, WRONG, Simulation, Trial
from ichnograph.algorithms.registration.simulation.trials import FIELDS, write_trials
from ichnograph.tests.algorithms.registration.simulation.simulated import box_at, points


def trial(outcome, wrong=0, errors=(0.0012345678, 0.25, 1.5)):
    return Trial(("P1", "P3", "P6"), outcome, wrong, *errors, frozenset())


def rows_of(path, *trials):
    control = points(box_at((0, 0, 0)))
    write_trials(Simulation(control, Settings(), 3, 0.0, 1, None, trials, ()), path)
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_each_trial_is_a_row_with_its_points_in_one_field(tmp_path):
    rows = rows_of(tmp_path / "trials.csv", trial(SUCCESS), trial(WRONG, wrong=2))

    assert [tuple(row) for row in rows] == [FIELDS, FIELDS]
    assert rows[0] == {
        "trial": "1",
        "points": "P1;P3;P6",
        "outcome": SUCCESS,
        "success": "1",
        "wrong": "0",
        "shift_error": "0.001235",
        "rotation_error": "0.250000",
        "sigma0": "1.500000",
    }
    assert (rows[1]["trial"], rows[1]["success"], rows[1]["wrong"]) == ("2", "0", "2")


def test_a_refused_scan_has_no_errors(tmp_path):
    (row,) = rows_of(tmp_path / "trials.csv", trial("ambiguous", errors=(np.nan,) * 3))

    assert (row["outcome"], row["success"]) == ("ambiguous", "0")
    assert [row[name] for name in ("shift_error", "rotation_error", "sigma0")] == ["", "", ""]


def test_without_redundancy_only_sigma0_is_unknown(tmp_path):
    (row,) = rows_of(tmp_path / "trials.csv", trial(SUCCESS, errors=(0.5, 0.25, np.nan)))

    assert [row[name] for name in ("shift_error", "rotation_error", "sigma0")] == ["0.500000", "0.250000", ""]


def test_the_table_holds_what_was_simulated(found, tmp_path):
    write_trials(found, tmp_path / "trials.csv")
    table = np.genfromtxt(tmp_path / "trials.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")

    assert [tuple(text.split(";")) for text in table["points"]] == [trial.points for trial in found.trials]
    np.testing.assert_allclose(table["shift_error"], [trial.shift_error for trial in found.trials], atol=1e-6)


def test_a_table_that_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(InputError, match="folder does not exist"):
        rows_of(tmp_path / "nowhere" / "trials.csv", trial(SUCCESS))
