"""The plan as a drawing: DXF in metres and in the coordinates of the site."""

from collections.abc import Iterator
from pathlib import Path

from shapely.geometry import LineString, Point
from shapely.ops import unary_union

from ...drawing import Drawing, write_drawing
from ..results import SitePlan
from ..rooms.rooms import Room

LAYERS = {
    "WALL": 1,
    "COLUMN": 30,
    "PARAPET": 32,
    "FACE": 8,
    "AXIS": 5,
    "ROOM": 3,
    "ROOM_NAME": 7,
    "ROOM_AREA": 7,
    "LIMIT": 6,
    "LEFT_OUT": 252,
}
"""Names of the layers, and their colours by number."""

TEXT_HEIGHT_M = 0.15
"""Height of the names of rooms: 3 mm at 1:50."""

FACE_REACH_M = 0.03
"""A surface is the face of a wall along the part of it that lies so near to an outline."""


def write_plan_drawing(path: Path, plan: SitePlan) -> None:
    """Write walls, faces, axes, rooms with names and areas, limits, and what was left out.

    Raises
    ------
    MissingPackageError
        If ezdxf is not installed.
    InputError
        If the file cannot be written.
    """
    with write_drawing(path, LAYERS) as drawing:
        for wall in plan.walls:
            kind = wall.kind.upper()
            drawing.polygon(wall.outline, kind if kind in LAYERS else "WALL")
        for face in faces(plan):
            drawing.line(face, "FACE")
        for axis in plan.axes or ():
            drawing.line(axis.line, "AXIS")
        for room in plan.rooms or ():
            _draw_room(drawing, room)
        if plan.storey:
            for limit in plan.storey.limits:
                drawing.line(limit, "LIMIT")
            for item in plan.storey.left_out:
                drawing.line(item.line, "LEFT_OUT")


def faces(plan: SitePlan) -> Iterator[LineString]:
    """Yield the seen surfaces along the outlines of the walls; without a storey they are not known."""
    if plan.storey is None or not plan.walls:
        return
    near = unary_union([wall.outline.boundary for wall in plan.walls]).buffer(FACE_REACH_M)
    for sheet in plan.storey.sheets:
        shared = LineString([sheet.start, sheet.stop]).intersection(near)
        for part in getattr(shared, "geoms", [shared]):
            # Where a surface crosses a wall, the shared part is as short as the reach is wide.
            if part.length > 2.5 * FACE_REACH_M:
                yield part


def _draw_room(drawing: Drawing, room: Room) -> None:
    drawing.polygon(room.outline, "ROOM")
    inside = room.outline.representative_point()
    below = Point(inside.x, inside.y - 1.5 * TEXT_HEIGHT_M)
    drawing.text(f"Room {room.room_id}", inside, TEXT_HEIGHT_M, "ROOM_NAME")
    drawing.text(f"{room.area:.2f} m²", below, TEXT_HEIGHT_M, "ROOM_AREA")
