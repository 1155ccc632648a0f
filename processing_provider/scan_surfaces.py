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
    from ..algorithms.registration.surfaces.patches import Surfaces
    from ..algorithms.registration.surfaces.settings import SurfaceSettings


def surfaces_of_scans(
    paths: Sequence[str],
    lists: "Sequence[PointList]",
    settings: "SurfaceSettings",
    log: Log,
    progress: "Progress",
) -> "dict[str, Surfaces]":
    """Return the surfaces of the clouds by the names of their lists.

    Parameters
    ----------
    paths : sequence of str
        Of the clouds; what is given twice counts once.
    lists : sequence of PointList
    settings : SurfaceSettings
    log : Log
    progress : Progress

    Raises
    ------
    InputError
        If there are no clouds, or a file cannot be read.
    """
    if not paths:
        raise InputError("REFINE needs the clouds of the scans; choose them in SCANS.")
    missing = lacking(FOR_CLOUDS)
    if missing:
        raise InputError(explain_missing(missing))
    from ..algorithms.clouds.cloud import open_scans, parts
    from ..algorithms.registration.lists.scan_names import scan_of_cloud
    from ..algorithms.registration.surfaces.patches import read_surfaces

    names = [points.name for points in lists]
    found: dict[str, Surfaces] = {}
    cloud = open_scans(list(dict.fromkeys(paths)))
    log.warn(cloud.warnings)
    for source, part in parts(cloud.sources, progress):
        number = scan_of_cloud(names, Path(source.path))
        if number is None:
            log.warn(
                [f"{source.path.name} is not used to tie scans, because no list of targets has its name."]
            )
            continue
        part.update(0.0, f"Finding the surfaces of {source.path.name}")
        found[names[number]] = read_surfaces(source, settings, part)
        log.info(f"{names[number]}: {len(found[names[number]])} plane cells.")
    return found
