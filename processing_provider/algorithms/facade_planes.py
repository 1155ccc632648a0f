"""The algorithm `facadeplanes`."""

from functools import partial

import numpy as np

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.clouds import CLOUDS, CRS, open_site
from ..parameters.destinations import CloudDestination, PolygonDestination
from ..parameters.facade import DISTANCE, MAX_PLANES, MIN_POINTS


class FacadePlanesAlgorithm(Algorithm):
    """Find the planes of a facade."""

    key = "facadeplanes"
    title = "Planes of a facade"
    chapter = "Facade"
    summary = "Finds the main plane of a facade and the secondary planes on it."
    about = (
        "RANSAC finds the largest upright plane of the scan, which sets the facade apart from street, trees "
        "and side walls, and then the planes on it: recessed doors and windows, cornices, bays. Each is "
        "refitted by total least squares, and every point belongs to the nearest within DISTANCE "
        "(Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal 2014)."
    )
    words = (
        "facade",
        "plane",
        "ransac",
        "segmentation",
        "wall",
        "laser scan",
        "point cloud",
        "tls",
        "heritage",
    )
    inputs = (CLOUDS, DISTANCE, MIN_POINTS, MAX_PLANES, CRS)
    destinations = (
        PolygonDestination(
            "PLANES",
            "Planes",
            "Polygons in space with normal, distance from the origin, azimuth, tilt, rms, number of points "
            "and area, for the area of an upright polygon is 0 in a map.",
            style="facade_planes",
        ),
        CloudDestination(
            "SEGMENTS",
            "Points with the number of their plane",
            "The cloud with all its attributes and the attribute plane, 0 for points of none. LAZ, LAS or "
            "text.",
            optional=True,
        ),
    )
    numbers = (("PLANE_COUNT", "Number of planes"),)

    def compute(self, values: dict, log: Log) -> Outcome:
        """Find the planes; the points are copied when the file is written."""
        from ...algorithms.clouds.writing.labelling import write_labelled
        from ...algorithms.facade.output.plane_layers import write_planes
        from ...algorithms.facade.planes.segmentation import find_planes
        from ...algorithms.facade.planes.settings import PlaneSettings
        from ...algorithms.facade.points import read_points

        cloud = open_site(values)
        log.warn(cloud.warnings)
        points = read_points(cloud, log.progress.part(0.0, 0.4))
        settings = PlaneSettings(min_points=values["MIN_POINTS"], max_planes=values["MAX_PLANES"])
        found = find_planes(points, values["DISTANCE"], settings, log.progress.part(0.4, 0.8))
        for number, plane in enumerate(found.planes, start=1):
            log.info(f"Plane {number}: {plane.points} points, rms {1000 * plane.rms:.1f} mm.")
        numbers = np.maximum(found.labels, 0).astype(np.uint16)
        return Outcome(
            {
                "PLANES": lambda path: write_planes(path, points, found, values["DISTANCE"], cloud.crs),
                "SEGMENTS": partial(_write_segments, write_labelled, cloud, numbers, log),
            },
            {"PLANE_COUNT": len(found.planes)},
        )


def _write_segments(write, cloud, numbers, log: Log, path) -> None:
    write(cloud, "plane", numbers, path, log.progress.part(0.8, 1.0))
