"""The algorithm `findtargets`."""

from functools import partial
from typing import Any

from ...algorithms.errors import NothingFoundError
from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_CLOUDS, FOR_LAYERS
from ..found_targets import log_search
from ..log import Log
from ..parameters.clouds import CRS, open_site
from ..parameters.destinations import HtmlDestination, PointDestination
from ..parameters.folders import FolderDestination
from ..parameters.targets import KIND, SCANS, SIZE, STATION, settings_of


class FindTargetsAlgorithm(Algorithm):
    """Find black and white targets and spheres in scans."""

    key = "findtargets"
    title = "Find targets in scans"
    chapter = "Registration"
    summary = "Finds black and white targets and spheres in scans, and measures their centres."
    about = (
        "Each scan becomes the image that the scanner saw. The centre of a black and white target is the "
        "crossing of its two edges on the fitted plane, that of a sphere the centre of the fitted sphere "
        "without its far rim. Each centre has a standard deviation. Targets that are doubtful are in the "
        "layer and in the report, but not in the lists."
    )
    words = (
        "targets",
        "checkerboard",
        "black and white",
        "sphere",
        "registration",
        "intensity",
        "laser scan",
        "point cloud",
        "tls",
    )
    needs = (*FOR_LAYERS, *FOR_CLOUDS)
    inputs = (SCANS, KIND, SIZE, STATION, CRS)
    destinations = (
        FolderDestination(
            "OUTPUT_FOLDER",
            "Lists of targets",
            "Folder for one text file per scan with x y z of its targets, for TARGETS of 'Register scans to "
            "control points'.",
            listing="LISTS",
        ),
        PointDestination(
            "TARGETS_LAYER",
            "Targets",
            "Points with kind, size, standard deviation of the centre, number of points, angle of incidence "
            "and quality; doubtful ones too, with the reason. GeoPackage or shapefile, by extension.",
            style="targets",
            optional=True,
        ),
        HtmlDestination(
            "REPORT",
            "Report",
            "HTML page with a picture of each target as the scanner saw it, the fitted centre drawn in.",
            optional=True,
        ),
    )
    numbers = (("TARGET_COUNT", "Number of targets without doubt"),)

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Search the scans."""
        from ...algorithms.targets.output.layer import write_targets
        from ...algorithms.targets.output.lists import list_writers
        from ...algorithms.targets.search import find_targets

        settings = settings_of(values)
        search = find_targets(open_site(values), settings, log.progress)
        log_search(search, settings, log)
        if not any(station.targets for station in search.stations):
            raise NothingFoundError("No target was found; the log says which tests failed, and how near.")
        writers: dict[str, Any] = {
            "OUTPUT_FOLDER": list_writers(search),
            "TARGETS_LAYER": partial(write_targets, search),
        }
        if values["REPORT"]:
            from ...algorithms.targets.output.report import write_report

            writers["REPORT"] = partial(write_report, search, settings)
        return Outcome(writers, {"TARGET_COUNT": search.count})
