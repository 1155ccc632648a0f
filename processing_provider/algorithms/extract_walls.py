"""The algorithm `extractwalls`."""

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.files import RasterFile
from ..parameters.walls import (
    WALL_NUMBERS,
    WALL_PARAMETERS,
    WALLS,
    find_walls,
    plan_destination,
    wall_numbers,
    wall_writers,
)


class ExtractWallsAlgorithm(Algorithm):
    """Extract walls from a density image."""

    key = "extractwalls"
    title = "Walls from a density image"
    chapter = "Site plan"
    summary = "Extracts the walls from a density image, as raster and polygons."
    about = (
        "Pixels above several thresholds form regions. Large ones that are shaped like straight or curved "
        "walls are kept and combined, gaps are closed and outlines traced "
        "(Mueller, Kohoutek and Theiler 2012)."
    )
    words = ("walls", "site plan", "floor plan", "polygons", "density", "laser scan", "tls", "archaeology")
    inputs = (
        RasterFile("INPUT", "Density image", "The output of 'Density image from laser scans'."),
        *WALL_PARAMETERS,
    )
    destinations = (plan_destination(optional=False), WALLS)
    numbers = WALL_NUMBERS

    def compute(self, values: dict, log: Log) -> Outcome:
        """Read the raster and extract the walls."""
        from ...algorithms.site_plan.output.layers import read_density

        raster = read_density(values["INPUT"])
        if raster.crs is None:
            log.warn(["The raster has no coordinate reference system, so the results have none either."])
        plan = find_walls(raster.density, raster.heights, raster.transform, values, log, log.progress)
        return Outcome(wall_writers(plan, raster.transform, raster.crs), wall_numbers(plan))
