"""The search for targets in scans."""

from dataclasses import replace

from ..clouds.cloud import Cloud, parts
from ..clouds.source import Source
from ..errors import InputError
from ..progress import Progress
from .range_image.range_image import image_of
from .range_image.station import read_stations
from .results import StationTargets, TargetSearch
from .settings import TargetSettings, Wanted
from .station_search import search_station


def find_targets(
    cloud: Cloud, settings: TargetSettings = TargetSettings(), progress: Progress = Progress()
) -> TargetSearch:
    """Find black and white targets and spheres in scans.

    Parameters
    ----------
    cloud : Cloud
        Each file is a scan of one station, or holds scans with their stations.
    settings : TargetSettings
    progress : Progress

    Raises
    ------
    InputError
        If a file is damaged, is not seen from one station, or has no intensity for the targets wanted, or if
        two files have the same name.
    """
    _check_names(cloud)
    found: list[StationTargets] = []
    warnings = list(cloud.warnings)
    for source, part in parts(cloud.sources, progress):
        stations = _of_file(source, settings, part)
        if not source.has_intensity and settings.wanted is Wanted.BOTH:
            warnings.append(
                f"{source.path.name} has no intensity, so that only spheres can be found; export it with "
                "intensity to find black and white targets."
            )
        found += stations
    return TargetSearch(tuple(found), cloud.crs, tuple(warnings))


def _check_names(cloud: Cloud) -> None:
    """Refuse files whose lists would have the same name, before hours of search."""
    # Not every file system distinguishes capitals.
    names = [source.path.stem.lower() for source in cloud.sources]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice:
        raise InputError(
            f"Two scans are called {twice}, so that their lists would be one file; rename a scan."
        )


def _of_file(source: Source, settings: TargetSettings, progress: Progress) -> list[StationTargets]:
    if not source.has_intensity and settings.wanted is Wanted.CHECKERBOARDS:
        raise InputError(
            f"{source.path} has no intensity, without which no black and white target can be seen; export "
            "it with intensity, or set KIND to spheres."
        )
    name = source.path.stem
    found = []
    for station in read_stations(source, settings.station, progress.part(0.0, 0.5)):
        image = image_of(station, str(source.path), settings.range_image)
        # The image has its own copy of the points, and a search takes memory too.
        del station
        found.append(search_station(name, image, settings, progress.part(0.5, 1.0)))
    if len(found) > 1:
        found = [replace(item, name=f"{name}_{number}") for number, item in enumerate(found, start=1)]
    return found
