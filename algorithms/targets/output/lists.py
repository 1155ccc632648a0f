"""Lists of targets, ready for the registration of scans."""

from functools import partial
from pathlib import Path
from typing import Callable

from ...errors import InputError
from ...files import atomic_output
from ..results import StationTargets, TargetSearch

DECIMALS = 5
"""Ten micrometres, finer than any centre."""


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
    """Write a line `x y z` for each target without doubt, in the coordinates of the scan.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    rows = (station.place(target) for target in station.sure)
    text = "".join(" ".join(f"{value:.{DECIMALS}f}" for value in row) + "\n" for row in rows)
    with atomic_output(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
