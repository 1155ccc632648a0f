"""The layers of a site plan: the wall pixels, the walls, their axes, the rooms."""

from pathlib import Path

import numpy as np

from ...raster import write_raster
from ...vector import write_vector
from ..results import SitePlan, WallPlan

WALL_FIELDS = {
    "wall_id": "int",
    "kind": "str:10",
    "length": "float:12.3",
    "thickness": "float:12.3",
    "thick_sd": "float:12.3",
    "z_base": "float:12.3",
    "z_top": "float:12.3",
    "height": "float:12.3",
    "azimuth": "float:12.3",
    "radius": "float:12.3",
    "density": "float:12.3",
    "coverage": "float:12.3",
    "rms": "float:12.4",
    "votes": "int",
    "body": "int",
}
"""Fields of the walls layer; those that need the wall's faces (thickness, radius, ...) are null."""

AXIS_FIELDS = {
    "axis_id": "int",
    "wall_id": "int",
    "length": "float:12.3",
    "thickness": "float:12.3",
    "thick_sd": "float:12.3",
    "azimuth": "float:12.3",
    "radius": "float:12.3",
}
"""Fields of the axes layer; straight pieces have an azimuth, curved ones a radius."""

ROOM_FIELDS = {
    "room_id": "int",
    "area": "float:12.3",
    "perimeter": "float:12.3",
    "openings": "int",
    "z_floor": "float:12.3",
    "z_ceiling": "float:12.3",
    "seen": "float:12.3",
}
"""Fields of the rooms layer; those that are not known are null."""

LEFT_OUT_FIELDS = {"reason": "str:80", "length": "float:12.3", "area": "float:12.3"}
"""Fields of the layer of what was left out."""


def write_plan(path: Path, plan: WallPlan) -> None:
    """Write the wall pixels as a byte GeoTIFF: 1 wall, 0 none."""
    write_raster(path, {"wall": plan.image.walls.astype(np.uint8)}, plan.transform, plan.crs)


def write_walls(path: Path, plan: WallPlan) -> None:
    """Write the walls as polygons with the fields `WALL_FIELDS`."""
    features = (
        (wall.outline, {name: getattr(wall, name, None) for name in WALL_FIELDS}) for wall in plan.walls
    )
    write_vector(path, "Polygon", WALL_FIELDS, features, plan.crs)


def write_axes(path: Path, plan: SitePlan) -> None:
    """Write the axes as lines with the fields `AXIS_FIELDS`; without axes the layer is empty."""
    features = ((axis.line, {name: getattr(axis, name) for name in AXIS_FIELDS}) for axis in plan.axes or ())
    write_vector(path, "LineString", AXIS_FIELDS, features, plan.crs)


def write_rooms(path: Path, plan: SitePlan) -> None:
    """Write the rooms as polygons with the fields `ROOM_FIELDS`; without rooms the layer is empty."""
    features = (
        (room.outline, {name: getattr(room, name) for name in ROOM_FIELDS}) for room in plan.rooms or ()
    )
    write_vector(path, "Polygon", ROOM_FIELDS, features, plan.crs)


def write_limits(path: Path, plan: SitePlan) -> None:
    """Write where the scan ends without a wall as lines; without a storey the layer is empty."""
    limits = plan.storey.limits if plan.storey else ()
    features = ((line, {"length": line.length}) for line in limits)
    write_vector(path, "LineString", {"length": "float:12.3"}, features, plan.crs)


def write_left_out(path: Path, plan: SitePlan) -> None:
    """Write the surfaces that are not walls as lines with the fields `LEFT_OUT_FIELDS`."""
    left_out = plan.storey.left_out if plan.storey else ()
    features = (
        (item.line, {"reason": item.reason, "length": item.line.length, "area": item.area})
        for item in left_out
    )
    write_vector(path, "LineString", LEFT_OUT_FIELDS, features, plan.crs)
