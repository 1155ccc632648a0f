"""The algorithm `extractwalls`."""

from typing import Any

from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_WALLS
from ..log import Log
from ..parameters.files import RasterFile
from ..parameters.walls import (
    WALL_NUMBERS,
    WALL_PARAMETERS,
    WALLS,
    log_walls,
    plan_destination,
    wall_numbers,
    wall_parameters,
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
    needs = FOR_WALLS
    inputs = (
        RasterFile("INPUT", "Density image", "The output of 'Density image from laser scans'."),
        *WALL_PARAMETERS,
    )
    destinations = (plan_destination(optional=False), WALLS)
    numbers = WALL_NUMBERS

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Read the raster and extract the walls."""
        from ...algorithms.site_plan.density.density_raster import read_density
        from ...algorithms.site_plan.site_plan import extract_walls

        plan = extract_walls(read_density(values["INPUT"]), wall_parameters(values), log.progress)
        log.warn(plan.warnings)
        log_walls(plan, log)
        return Outcome(wall_writers(plan), wall_numbers(plan))
