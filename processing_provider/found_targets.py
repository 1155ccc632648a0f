"""Targets found in scans, said in the log and passed on to the registration."""

from typing import TYPE_CHECKING

from ..algorithms.errors import InputError, NothingFoundError
from .dependencies import FOR_CLOUDS, explain_missing, lacking
from .log import Log
from .parameters.point_lists import TargetFiles

if TYPE_CHECKING:
    from ..algorithms.progress import Progress
    from ..algorithms.registration.lists.point_list import PointList
    from ..algorithms.targets.results import StationTargets, TargetSearch
    from ..algorithms.targets.settings import TargetSettings


def lists_of(given: TargetFiles, by_names: bool, log: Log, progress: "Progress") -> "list[PointList]":
    """Return the given lists of targets, and those of the scans that have none.

    Parameters
    ----------
    given : TargetFiles
    by_names : bool
        Whether targets are matched by names, which found ones do not have.
    log : Log
    progress : Progress
    """
    if not given.clouds:
        return given.lists
    if by_names:
        raise InputError(
            f"Targets found in {given.clouds[0]} have no names; set MATCHING to distances, or choose a list."
        )
    missing = lacking(FOR_CLOUDS)
    if missing:
        raise InputError(explain_missing(missing))
    from ..algorithms.clouds.cloud import open_scans
    from ..algorithms.targets.search import find_targets
    from ..algorithms.targets.settings import TargetSettings

    settings = TargetSettings()
    log.info(f"Searching {len(given.clouds)} scans for targets, because they have no lists.")
    search = find_targets(open_scans(given.clouds), settings, progress)
    log_search(search, settings, log)
    found = [_list_of(station) for station in search.stations]
    if not given.lists and not any(station.sure for station in search.stations):
        raise NothingFoundError(
            "No target was found in the scans; the log says which tests failed, and how near. Pick the "
            "targets, or try 'Find targets in scans' with the size of the targets."
        )
    names = [points.name for points in given.lists]
    twice = next((points.name for points in found if points.name in names), None)
    if twice is not None:
        raise InputError(f"TARGETS has a list and a scan called {twice}; remove one of them.")
    return [*given.lists, *found]


def log_search(search: "TargetSearch", settings: "TargetSettings", log: Log) -> None:
    """Say what was found in each scan, what is doubtful, and why a scan has no targets."""
    from ..algorithms.targets.explanation import explanation

    log.warn(search.warnings)
    for station in search.stations:
        sure, doubtful = len(station.sure), len(station.targets) - len(station.sure)
        log.info(f"{station.name}: {sure} targets, {doubtful} doubtful.")
        for target in station.targets:
            if target.doubt:
                place = " ".join(f"{value:.3f}" for value in station.place(target))
                what = f"The {target.kind.value} target at {place} in {station.name}"
                log.warn([f"{what} is doubtful: {target.doubt}."])
        if not station.sure:
            log.warn(explanation(station, settings))


def _list_of(station: "StationTargets") -> "PointList":
    """Return the targets of a station without doubt as a list, as if it were written and read."""
    from ..algorithms.registration.lists.point_list import PointList

    return PointList(
        name=station.name,
        names=tuple(str(row) for row in range(1, len(station.sure) + 1)),
        xyz=station.places,
        named=False,
        covariances=station.covariances,
    )
