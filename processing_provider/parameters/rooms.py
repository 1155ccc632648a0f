"""What a site plan tells beyond its walls: axes, rooms and the report."""

from functools import partial
from typing import TYPE_CHECKING

from ..algorithm import Outcome
from ..log import Log
from .destinations import HtmlDestination, LineDestination, PolygonDestination
from .parameter import Number

if TYPE_CHECKING:
    from ...algorithms.site_plan.density.density_image import DensityImage
    from ...algorithms.site_plan.site_plan import SitePlan

DOOR_WIDTH = Number(
    "DOOR_WIDTH",
    "Widest door of a room",
    "Gaps in walls up to this width are bridged for ROOMS. Leaves of doors are up to 1.25 m wide, and "
    "corridors seldom narrower than 1.3 m. Raise it for gates and broken walls.",
    unit="m",
    default=1.3,
    minimum=0.1,
    maximum=20,
    advanced=True,
)

AXES = LineDestination(
    "AXES",
    "Axes",
    "Centrelines of the walls that meet at junctions, with thickness, azimuth or radius. GeoPackage or "
    "shapefile, by extension.",
    style="axes",
    optional=True,
    by_default=False,
)

ROOMS = PolygonDestination(
    "ROOMS",
    "Rooms",
    "Closed spaces between the faces of the walls, with area and perimeter. GeoPackage or shapefile, by "
    "extension.",
    style="rooms",
    optional=True,
    by_default=False,
)

REPORT = HtmlDestination(
    "REPORT",
    "Report",
    "HTML page that shows what each parameter did, and which to turn; see the results viewer.",
    optional=True,
    by_default=False,
)

ROOM_NUMBERS = (
    ("ROOM_COUNT", "Number of rooms, if ROOMS are made"),
    ("ROOM_AREA", "Area of the rooms (m²), if ROOMS are made"),
)


def further_outputs(plan: "SitePlan", image: "DensityImage", values: dict, log: Log) -> Outcome:
    """Make what is wanted of the axes, the rooms and the report."""
    from ...algorithms.site_plan.axes.axes import find_axes
    from ...algorithms.site_plan.output.room_layers import write_axes, write_rooms

    rooms = _find_rooms(plan, image, values, log) if values["ROOMS"] else ()
    writers, numbers = {}, {}
    if values["REPORT"]:
        from ...algorithms.site_plan.output.plan_report import write_report

        settings = _settings(values)
        writers["REPORT"] = partial(write_report, plan=plan, image=image, settings=settings, rooms=rooms)
    if values["AXES"]:
        axes = find_axes((wall.wall_id, wall.outline) for wall in plan.walls)
        log.info(f"Axes: {len(axes)}, {sum(axis.length for axis in axes):.1f} m long.")
        writers["AXES"] = partial(write_axes, axes=axes, crs=image.crs)
    if values["ROOMS"]:
        writers["ROOMS"] = partial(write_rooms, rooms=rooms, crs=image.crs)
        numbers = {"ROOM_COUNT": len(rooms), "ROOM_AREA": sum(room.area for room in rooms)}
    return Outcome(writers, numbers)


def _find_rooms(plan: "SitePlan", image: "DensityImage", values: dict, log: Log) -> tuple:
    """Find the rooms, and tell of them."""
    from ...algorithms.site_plan.rooms.rooms import find_rooms, with_floors

    rooms = find_rooms((wall.outline for wall in plan.walls), values["DOOR_WIDTH"])
    if not rooms:
        log.warn(["No room is closed: raise DOOR_WIDTH above the widest gap in its walls."])
    log.info(f"Rooms: {len(rooms)}, {sum(room.area for room in rooms):.2f} m².")
    return with_floors(rooms, image.ground, image.transform)


def _settings(values: dict) -> dict:
    """Return the parameters that only the run knows, as the report shows them."""
    return {
        "SPACING": f"{values['SPACING']:g} m",
        "NEIGHBOURHOOD": f"{values['NEIGHBOURHOOD']} pixels",
        "REFINE": "yes" if values["REFINE"] else "no",
        **{name: f"{values[name]:g} m" for name in ("ZMIN", "ZMAX") if values[name] is not None},
        **({"HEIGHTS": "above the local ground"} if values["HEIGHTS"] else {}),
        **({"DOOR_WIDTH": f"{values['DOOR_WIDTH']:g} m"} if values["ROOMS"] else {}),
    }
