"""The algorithm `siteplan`."""

from functools import partial
from typing import TYPE_CHECKING, Any

from ...algorithms.errors import NothingFoundError
from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.clouds import (
    CLOUDS,
    CRS,
    PIXEL_SIZE,
    SCHEDULER,
    SPACING,
    neighbourhood,
    open_upright_site,
    sorter,
)
from ..parameters.density import (
    HEIGHT_PARAMETERS,
    POINT_NUMBERS,
    density_destination,
    height_range,
    log_density,
    point_numbers,
)
from ..parameters.parameter import Flag
from ..parameters.rooms import (
    AXES,
    DOOR_WIDTH,
    DRAWING,
    LEFT_OUT,
    LIMITS,
    REPORT,
    ROOM_NUMBERS,
    ROOMS,
    SECTION,
    STOREY,
    log_rooms,
    room_numbers,
    room_writers,
)
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

if TYPE_CHECKING:
    from ...algorithms.site_plan.results import SitePlan
    from ...algorithms.site_plan.settings import SitePlanSettings

REFINE = Flag(
    "REFINE",
    "Outlines on the wall faces",
    "Moves the outlines from the edges of pixels to the points of the faces, straight or curved, and "
    "measures thickness, radius and coverage. If off, outlines follow pixels, as in the paper.",
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
        "The clouds are thinned, a density image is computed, and the walls are extracted from it. Only "
        "the clouds are needed: defaults that depend on the data are derived and written to the log "
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
        SECTION,
        CRS,
        neighbourhood(advanced=True),
        *HEIGHT_PARAMETERS,
        DOOR_WIDTH,
        STOREY,
        SCHEDULER,
    )
    destinations = (
        density_destination(optional=True),
        plan_destination(optional=True),
        ROOMS,
        WALLS,
        AXES,
        LIMITS,
        LEFT_OUT,
        REPORT,
        DRAWING,
    )
    numbers = POINT_NUMBERS + WALL_NUMBERS + ROOM_NUMBERS

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Make the plan."""
        from ...algorithms.site_plan.density.density_raster import write_density
        from ...algorithms.site_plan.site_plan import make_site_plan

        try:
            cloud = open_upright_site(values, log)
            plan = make_site_plan(cloud, settings_of(values), log.progress, sorter(values))
        except NothingFoundError as error:
            log.warn(error.warnings)
            raise
        _log(plan, log)
        return Outcome(
            {
                "DENSITY": partial(write_density, image=plan.density),
                **wall_writers(plan),
                **room_writers(plan),
            },
            {**point_numbers(plan.density), **wall_numbers(plan), **room_numbers(plan)},
        )


def settings_of(values: dict[str, Any]) -> "SitePlanSettings":
    """Return what the user chose."""
    from ...algorithms.site_plan.rooms.settings import RoomSettings
    from ...algorithms.site_plan.settings import SitePlanSettings
    from ...algorithms.site_plan.storeys.settings import CutSettings, StoreySettings

    return SitePlanSettings(
        spacing_m=values["SPACING"],
        pixel_size_m=values["PIXEL_SIZE"],
        neighbourhood_px=values["NEIGHBOURHOOD"],
        height_range=height_range(values),
        wall_parameters=wall_parameters(values),
        refine=values["REFINE"],
        storey=values["STOREY"],
        with_axes=any(values[name] is not None for name in ("AXES", "DRAWING")),
        with_rooms=any(values[name] is not None for name in ("ROOMS", "DRAWING")),
        rooms=RoomSettings(door_width_m=values["DOOR_WIDTH"]),
        storeys=StoreySettings(cut=CutSettings(section_m=values["SECTION"])),
    )


def _log(plan: "SitePlan", log: Log) -> None:
    log.warn(plan.warnings)
    log_density(plan.density, log)
    log_walls(plan, log)
    if plan.foliage:
        log.info(f"Left out as foliage because their points lie on no face: {plan.foliage}.")
    if plan.settings.refine:
        log.info(f"Outlines on the faces: {plan.coverage:.0%} of their length has points on it.")
    log_rooms(plan, log)
