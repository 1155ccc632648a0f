"""Surfaces of the scans that are to be tied to each other."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..algorithms.errors import InputError
from .dependencies import FOR_CLOUDS, explain_missing, lacking
from .log import Log

if TYPE_CHECKING:
    from ..algorithms.progress import Progress
    from ..algorithms.registration.lists.point_list import PointList
    from ..algorithms.registration.settings import Settings
    from ..algorithms.registration.surfaces.patches import Surfaces


def with_clouds_alone(lists: "Sequence[PointList]", paths: Sequence[str]) -> "list[PointList]":
    """Return lists of targets, and empty ones for the clouds that have none; surfaces may place these.

    Parameters
    ----------
    lists : sequence of PointList
    paths : sequence of str
        Of the clouds; what is given twice counts once.
    """
    import numpy as np

    from ..algorithms.registration.lists.point_list import PointList
    from ..algorithms.registration.lists.scan_names import has_list, scan_name

    names = [points.name for points in lists]
    alone = [path for path in _each_once(paths) if not has_list(names, path)]
    by_name: dict[str, Path] = {}
    for path in alone:
        other = by_name.setdefault(scan_name(path), path)
        if other is not path:
            raise InputError(f"{other} and {path} have the same name; rename one of them.")
    return [*lists, *(PointList(scan_name(path), (), np.zeros((0, 3)), named=False) for path in alone)]


def surfaces_of_scans(
    paths: Sequence[str],
    lists: "Sequence[PointList]",
    settings: "Settings",
    log: Log,
    progress: "Progress",
) -> "dict[str, Surfaces]":
    """Return the surfaces of the clouds by the names of their lists.

    Parameters
    ----------
    paths : sequence of str
        Of the clouds; what is given twice counts once.
    lists : sequence of PointList
    settings : Settings
    log : Log
    progress : Progress

    Raises
    ------
    InputError
        If fewer than two scans have a cloud or one has two, if a file cannot be read, or if the scale of the
        scans may be any, because surfaces are searched and paired in metres.
    """
    if not paths:
        raise InputError("REFINE needs the clouds of the scans; choose them in SCANS.")
    if settings.free_scale:
        raise InputError(
            "REFINE needs scans in metres, but with MODEL and MATCHING as chosen, their scale may be any; "
            "choose a MODEL without scale, or leave REFINE out."
        )
    missing = lacking(FOR_CLOUDS)
    if missing:
        raise InputError(explain_missing(missing))
    from ..algorithms.clouds.cloud import open_scans, parts
    from ..algorithms.registration.surfaces.patches import read_surfaces

    clouds = _clouds_of([points.name for points in lists], paths, log)
    cloud = open_scans(list(clouds.values()))
    log.warn(cloud.warnings)
    found: dict[str, Surfaces] = {}
    for name, (source, part) in zip(clouds, parts(cloud.sources, progress)):
        part.update(0.0, f"Finding the surfaces of {source.path.name}")
        found[name] = read_surfaces(source, settings.surfaces, part)
        log.info(f"{name}: {len(found[name].exact)} plane cells.")
    return found


def _clouds_of(names: Sequence[str], paths: Sequence[str], log: Log) -> dict[str, Path]:
    """Return the cloud of each scan by its name, and say which cloud or scan has no partner."""
    from ..algorithms.registration.lists.scan_names import scan_of_cloud

    found: dict[str, Path] = {}
    for path in _each_once(paths):
        number = scan_of_cloud(names, path)
        if number is None:
            log.warn([f"{path.name} is not used to tie scans, because no list of targets has its name."])
        elif names[number] in found:
            raise InputError(
                f"{found[names[number]]} and {path} are both named after the list {names[number]}; choose "
                "one of them as its cloud."
            )
        else:
            found[names[number]] = path
    log.warn(
        f"{name} is not tied by surfaces, because no cloud has its name; its targets alone hold it."
        for name in names
        if name not in found
    )
    if len(found) < 2:
        raise InputError(
            "REFINE needs the clouds of at least two scans; choose them in SCANS, each named after its list."
        )
    return found


def _each_once(paths: Sequence[str]) -> list[Path]:
    return list({Path(path).resolve(): Path(path) for path in paths}.values())
