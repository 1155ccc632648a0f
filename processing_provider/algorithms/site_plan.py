"""The algorithm `siteplan`."""

from functools import partial

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.clouds import CLOUDS, CRS, PIXEL_SIZE, SPACING, neighbourhood
from ..parameters.density import (
    HEIGHT_PARAMETERS,
    POINT_NUMBERS,
    compute_density_and_keep,
    density_destination,
    point_numbers,
)
from ..parameters.parameter import Flag
from ..parameters.rooms import AXES, DOOR_WIDTH, REPORT, ROOM_NUMBERS, ROOMS, further_outputs
from ..parameters.walls import (
    WALL_NUMBERS,
    WALL_PARAMETERS,
    WALLS,
    find_walls,
    plan_destination,
    refine_outlines,
    wall_numbers,
    wall_writers,
)

REFINE = Flag(
    "REFINE",
    "Outlines on the wall faces",
    "Moves the outlines from the edges of pixels to where the points of the faces are, straight or curved, "
    "and measures thickness, radius and coverage. No gives the outlines of the paper.",
    default=True,
    advanced=False,
)


class SitePlanAlgorithm(Algorithm):
    """Extract the walls of a site from clouds, in one step."""

    key = "siteplan"
    title = "Site plan from laser scans"
    chapter = "Site plan"
    summary = "Turns terrestrial laser scans into a site plan: the walls as polygons."
    about = (
        "The clouds are thinned, a density image is computed, and the walls are extracted from it, with "
        "defaults that are derived from the data and told in the log. INPUT is all it needs "
        "(Mueller, Kohoutek and Theiler 2012)."
    )
    words = (
        "site plan",
        "floor plan",
        "ground plan",
        "walls",
        "laser scan",
        "point cloud",
        "tls",
        "lidar",
        "las",
        "laz",
        "archaeology",
        "building",
    )
    inputs = (
        CLOUDS,
        SPACING,
        PIXEL_SIZE,
        *WALL_PARAMETERS,
        REFINE,
        CRS,
        neighbourhood(advanced=True),
        *HEIGHT_PARAMETERS,
        DOOR_WIDTH,
    )
    destinations = (
        density_destination(optional=True),
        plan_destination(optional=True),
        ROOMS,
        WALLS,
        AXES,
        REPORT,
    )
    numbers = POINT_NUMBERS + WALL_NUMBERS + ROOM_NUMBERS

    def compute(self, values: dict, log: Log) -> Outcome:
        """Compute the density image and extract the walls."""
        from ...algorithms.site_plan.output.layers import write_density

        progress = log.progress
        with compute_density_and_keep(values, log, progress.part(0.0, 0.7)) as (image, points):
            plan = find_walls(
                image.density, image.heights, image.transform, values, log, progress.part(0.7, 0.85)
            )
            if values["REFINE"]:
                plan = refine_outlines(plan, points, image, log, progress.part(0.85, 1.0))
        writers = wall_writers(plan, image.transform, image.crs)
        writers["DENSITY"] = partial(write_density, image=image)
        further = further_outputs(plan, image, values, log)
        return Outcome(
            {**writers, **further.writers}, {**point_numbers(image), **wall_numbers(plan), **further.numbers}
        )
