"""Lists of targets, ready for the registration of scans."""

from functools import partial
from pathlib import Path
from typing import Callable

import numpy as np

from ...errors import InputError
from ...files import atomic_output
from ..results import StationTargets, TargetSearch

DECIMALS = 5
"""Ten micrometres, finer than any centre."""

STD_DECIMALS = 7
"""A tenth of a micrometre, so that the rounding of small standard deviations does not change weights."""

CORRELATION_DECIMALS = 6
"""Standard deviations along and across the ray that differ by a hundred are still distinguished."""

COLUMNS = ("x", "y", "z", "sx", "sy", "sz", "rxy", "rxz", "ryz")
"""The first line of a list."""


def list_writers(search: TargetSearch) -> dict[str, Callable[[Path], None]]:
    """Return the writers of the lists by file name: one for each scan that has targets without doubt.

    Raises
    ------
    InputError
        If two scans have the same name.
    """
    writers: dict[str, Callable[[Path], None]] = {}
    taken = set()
    for station in search.stations:
        # Not every file system distinguishes capitals.
        if station.name.lower() in taken:
            raise InputError(
                f"Two scans are called {station.name}, so that their lists would be one file; rename a scan."
            )
        taken.add(station.name.lower())
        if station.sure:
            writers[f"{station.name}.txt"] = partial(write_list, station)
    return writers


def write_list(station: StationTargets, path: Path) -> None:
    """Write a line for each target without doubt, in the coordinates of the scan.

    The columns are x y z, their standard deviations sx sy sz, and the correlations rxy rxz ryz.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    lines = [" ".join(COLUMNS)]
    for target in station.sure:
        stds = np.sqrt(np.diag(target.covariance))
        lines.append(
            " ".join(
                [f"{value:.{DECIMALS}f}" for value in station.place(target)]
                + [f"{value:.{STD_DECIMALS}f}" for value in stds]
                + [f"{value:.{CORRELATION_DECIMALS}f}" for value in correlations_of(target.covariance)]
            )
        )
    text = "\n".join(lines) + "\n"
    with atomic_output(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def correlations_of(covariance: np.ndarray) -> np.ndarray:
    """Return the correlations between x and y, x and z, y and z.

    Parameters
    ----------
    covariance : ndarray of float64, shape (3, 3)
    """
    stds = np.sqrt(np.diag(covariance))
    return np.asarray((covariance / np.outer(stds, stds))[(0, 0, 1), (1, 2, 2)])
