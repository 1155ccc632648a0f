"""What a site plan shows beyond its walls: axes, rooms and the report."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from ..log import Log
from .destinations import DrawingDestination, HtmlDestination, LineDestination, PolygonDestination, Writer
from .parameter import Flag, Number

if TYPE_CHECKING:
    from ...algorithms.site_plan.results import SitePlan
    from ...algorithms.site_plan.storeys.evidence.levels import Storey
    from ...algorithms.site_plan.storeys.storey_plan import StoreyPlan

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

STOREY = Flag(
    "STOREY",
    "Plan of the storey under a ceiling",
    "Where a ceiling was seen, walls and rooms come from the faces and the floor of the storey, also behind "
    "furniture and across glazing. No uses the density image everywhere. Needs REFINE.",
    default=True,
    advanced=True,
)

SECTION = Number(
    "SECTION",
    "Height of the cut above the floor",
    "Where a ceiling was seen, the plan shows what stands at this height above the floor. Faces are "
    "recognised over the full height of the storey.",
    unit="m",
    default=1.1,
    minimum=0.2,
    maximum=3,
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
    "Rooms between the faces of the walls, with area, perimeter, heights of floor and ceiling. GeoPackage or "
    "shapefile, by extension.",
    style="rooms",
    optional=True,
)

LIMITS = LineDestination(
    "LIMITS",
    "Limits of the scan",
    "Lines where a room ends without a wall, because the scan ends there. GeoPackage or shapefile, by "
    "extension.",
    style="limits",
    optional=True,
    by_default=False,
)

LEFT_OUT = LineDestination(
    "LEFT_OUT",
    "Surfaces left out",
    "Upright surfaces in rooms that are not walls, with the reason: furniture, curtains, door leaves. "
    "GeoPackage or shapefile, by extension.",
    style="left_out",
    optional=True,
    by_default=False,
)

REPORT = HtmlDestination(
    "REPORT",
    "Report of the site plan",
    "HTML page that shows what each parameter did, and which to change; see the results viewer.",
    optional=True,
)

DRAWING = DrawingDestination(
    "DRAWING",
    "Drawing",
    "DXF file in metres: walls, faces, axes, and rooms with names and areas, on layers; needs the package "
    "ezdxf.",
    optional=True,
)

ROOM_NUMBERS = (
    ("ROOM_COUNT", "Number of rooms, if ROOMS are made"),
    ("ROOM_AREA", "Area of the rooms (m²), if ROOMS are made"),
)


def log_rooms(plan: "SitePlan", log: Log) -> None:
    """Write to the log the storey, and which axes and rooms were found, if they were wanted."""
    if plan.storey and plan.storey.storey:
        log.info(_storey(plan.storey, plan.storey.storey))
    elif plan.settings.refine:
        log.info("No ceiling was seen: the walls are those of the density image.")
    if plan.axes is not None:
        log.info(f"Axes: {len(plan.axes)}, {plan.axes_length:.1f} m long.")
    if plan.rooms is not None:
        log.info(f"Rooms: {len(plan.rooms)}, {plan.room_area:.2f} m².")


def _storey(found: "StoreyPlan", heights: "Storey") -> str:
    """Return what the log says of the storey."""
    limits = sum(line.length for line in found.limits)
    left_out = sum(item.line.length for item in found.left_out)
    return (
        f"Storey: floor at {heights.floor:.2f} m, ceiling at {heights.ceiling:.2f} m; points "
        f"{100 * found.spacing_m:.1f} cm apart, noise {1000 * found.noise_m:.0f} mm. Borders of rooms "
        f"without a wall: {limits:.1f} m. Left out as furniture and the like: {left_out:.1f} m."
    )


def room_writers(plan: "SitePlan") -> dict[str, Writer]:
    """Return what writes AXES, ROOMS, LIMITS, LEFT_OUT, REPORT and DRAWING."""
    from ...algorithms.site_plan.output.layers import write_axes, write_left_out, write_limits, write_rooms
    from ...algorithms.site_plan.output.plan_drawing import write_plan_drawing

    writers = {
        "AXES": write_axes,
        "ROOMS": write_rooms,
        "LIMITS": write_limits,
        "LEFT_OUT": write_left_out,
        "REPORT": _write_report,
        "DRAWING": write_plan_drawing,
    }
    return {name: partial(write, plan=plan) for name, write in writers.items()}


def _write_report(path: Path, plan: "SitePlan") -> None:
    # Only a report needs the packages that it is made with.
    from ...algorithms.site_plan.output.plan_report import write_report

    write_report(path, plan)


def room_numbers(plan: "SitePlan") -> dict[str, float]:
    """Return the values of `ROOM_NUMBERS`."""
    return {} if plan.rooms is None else {"ROOM_COUNT": len(plan.rooms), "ROOM_AREA": plan.room_area}
