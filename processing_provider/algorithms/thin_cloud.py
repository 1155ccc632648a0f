"""The algorithm `thincloud`."""

from typing import Any

from ...algorithms.clouds.formats import writable_formats
from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_CLOUDS
from ..log import Log
from ..parameters.clouds import CLOUDS, SCHEDULER, SPACING, open_site, sorter
from ..parameters.destinations import CloudDestination


class ThinCloudAlgorithm(Algorithm):
    """Thin clouds to a minimum distance between points."""

    key = "thincloud"
    title = "Thin laser scans"
    chapter = "Clouds"
    summary = "Leaves out points so that no two are closer than a minimum distance."
    about = (
        "Points are left out until no two are closer than the point spacing. The distance is exact, in "
        "space, and holds across files. Several files become one. LAS and LAZ files of one point format "
        "keep every attribute if the output is LAS or LAZ."
    )
    words = ("thin", "subsample", "decimate", "minimum distance", "point cloud", "tls", "lidar", "las", "laz")
    needs = FOR_CLOUDS
    inputs = (CLOUDS, SPACING, SCHEDULER)
    destinations = (CloudDestination("OUTPUT", "Thinned cloud", f"{writable_formats()}, by extension."),)
    numbers = (
        ("POINTS_IN", "Number of points in the clouds"),
        ("POINTS_OUT", "Number of points after thinning"),
    )

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Thin the clouds; the points are copied when the file is written."""
        from ...algorithms.clouds.thinning.thinning import thin_cloud
        from ...algorithms.clouds.writing.point_selection import write_cloud

        cloud = open_site(values)
        thinned = thin_cloud(cloud, values["SPACING"], log.progress.part(0.0, 0.7), sort=sorter(values))
        log.warn(thinned.warnings)
        log.info(f"Points: {thinned.points_in} read, {len(thinned.kept)} kept.")
        return Outcome(
            {"OUTPUT": lambda path: write_cloud(cloud, thinned.kept, path, log.progress.part(0.7, 1.0))},
            {"POINTS_IN": thinned.points_in, "POINTS_OUT": len(thinned.kept)},
        )
