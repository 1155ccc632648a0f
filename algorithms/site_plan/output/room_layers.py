"""The layers of axes and rooms."""

from pathlib import Path
from typing import Optional

from rasterio.crs import CRS

from ...vector import write_vector

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
}
"""Fields of the rooms layer."""


def write_axes(path: Path, axes: tuple, crs: Optional[CRS]) -> None:
    """Write axes as lines with the fields `AXIS_FIELDS`; none are an empty layer."""
    features = ((axis.line, {name: getattr(axis, name) for name in AXIS_FIELDS}) for axis in axes)
    write_vector(path, "LineString", AXIS_FIELDS, features, crs)


def write_rooms(path: Path, rooms: tuple, crs: Optional[CRS]) -> None:
    """Write rooms as polygons with the fields `ROOM_FIELDS`; none are an empty layer."""
    features = ((room.outline, {name: getattr(room, name) for name in ROOM_FIELDS}) for room in rooms)
    write_vector(path, "Polygon", ROOM_FIELDS, features, crs)
