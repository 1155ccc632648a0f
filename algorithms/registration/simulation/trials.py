"""The table of a simulation: a row for each trial."""

import csv
from pathlib import Path

import numpy as np

from ...files import atomic_output
from ...tables.spreadsheet import safe_cell
from .simulation import SUCCESS, Simulation

FIELDS = ("trial", "points", "outcome", "success", "wrong", "shift_error", "rotation_error", "sigma0")


def write_trials(simulation: Simulation, path: Path) -> None:
    """Write a row for each trial as csv; errors in metres and degrees, empty where there is no pose.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    with atomic_output(path) as temporary, temporary.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(FIELDS)
        for row, trial in enumerate(simulation.trials, start=1):
            errors = (trial.shift_error, trial.rotation_error, trial.sigma0)
            written = ("" if np.isnan(value) else f"{value:.6f}" for value in errors)
            success = int(trial.outcome == SUCCESS)
            rows.writerow(
                (row, safe_cell(";".join(trial.points)), trial.outcome, success, trial.wrong, *written)
            )
