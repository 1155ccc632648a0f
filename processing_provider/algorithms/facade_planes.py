"""The algorithm `facadeplanes`."""

from typing import Any

import numpy as np

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.clouds import CLOUDS, CRS, open_upright_site
from ..parameters.destinations import CloudDestination, PolygonDestination
from ..parameters.facade import DISTANCE, MAX_PLANES, MIN_POINTS


class FacadePlanesAlgorithm(Algorithm):
    """Find the planes of a facade."""

    key = "facadeplanes"
    title = "Planes of a facade"
    chapter = "Facade"
    summary = "Finds the main plane of a facade and the secondary planes on it."
    about = (
        "RANSAC finds the largest upright plane of the scan, the facade without street, trees and side "
        "walls, and then the planes on it: recessed doors and windows, cornices, bays. Each plane is fitted "
        "by total least squares. Every point belongs to the nearest plane within DISTANCE (Aitelkadi, "
        "Tahiri, Simonetto, Sebari and Boulaassal 2014)."
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
            "and true area, because GIS computes an area of 0 for an upright polygon.",
            style="facade_planes",
        ),
        CloudDestination(
            "SEGMENTS",
            "Points with the number of their plane",
            "The cloud with all its attributes and the attribute plane, 0 for points outside all planes. "
            "LAZ, LAS or text.",
            optional=True,
        ),
    )
    numbers = (("PLANE_COUNT", "Number of planes"),)

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Find the planes; the points are copied when the file is written."""
        from ...algorithms.clouds.writing.labelling import write_labelled
        from ...algorithms.facade.output.plane_layers import write_planes
        from ...algorithms.facade.planes.segmentation import find_planes
        from ...algorithms.facade.planes.settings import PlaneSettings
        from ...algorithms.facade.points import read_points

        cloud = open_upright_site(values, log)
        log.warn(cloud.warnings)
        points = read_points(cloud, log.progress.part(0.0, 0.4))
        log.warn(points.warnings)
        settings = PlaneSettings(min_points=values["MIN_POINTS"], max_planes=values["MAX_PLANES"])
        found = find_planes(points, values["DISTANCE"], settings, log.progress.part(0.4, 0.8))
        for number, plane in enumerate(found.planes, start=1):
            log.info(f"Plane {number}: {plane.points} points, rms {1000 * plane.rms:.1f} mm.")
        numbers = np.maximum(found.labels, 0).astype(np.uint16)
        return Outcome(
            {
                "PLANES": lambda path: write_planes(path, points, found, values["DISTANCE"], cloud.crs),
                "SEGMENTS": lambda path: write_labelled(
                    cloud, "plane", numbers, path, points.kept, log.progress.part(0.8, 1.0)
                ),
            },
            {"PLANE_COUNT": len(found.planes)},
        )
