"""The elevation as layers: in the plane of the drawing, and in space."""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np
from rasterio.crs import CRS
from shapely.geometry import LinearRing, MultiPolygon, Polygon

from ...vector import write_vector
from ..elevation import Detail, Elevation, Frame

Shape = Union[Polygon, MultiPolygon]

CHORD = np.radians(2.0)
"""Lines in space follow a round wall by pieces of this angle (radians)."""

SIDES_RADIUS = 0.5
"""Stands in for the radius where a wall has sides, so that corners are passed within 2 cm (m)."""

WALL, UNSEEN = "wall", "unseen"
"""Kinds of features besides those of the details."""

ELEVATION_CRS = CRS.from_wkt('LOCAL_CS["Facade elevation",UNIT["metre",1],AXIS["u",EAST],AXIS["v",NORTH]]')
"""u to the right, v up, in metres; it has no position on the earth."""

FRAME_FIELDS = dict.fromkeys(("x0", "y0", "z0", "azimuth", "tilt"), "float:24.15")
"""The frame, in every feature: it converts u, v to coordinates of the site."""

FIELDS = {
    "id": "int",
    "kind": "str:16",
    "use": "str:10",
    "shape": "str:10",
    "head": "str:10",
    "width": "float:12.4",
    "height": "float:12.4",
    "sill": "float:12.4",
    "area": "float:14.5",
    "w_std": "float:12.5",
    "h_std": "float:12.5",
    "std_left": "float:12.5",
    "std_right": "float:12.5",
    "std_bottom": "float:12.5",
    "std_top": "float:12.5",
    "measured": "str:24",
    "completed": "str:24",
    "radius": "float:12.4",
    "open_side": "str:24",
    "wall_depth": "float:12.4",
    "depth": "float:12.4",
    "rms": "float:12.5",
    "points": "int",
    "red": "int",
    "green": "int",
    "blue": "int",
    "intensity": "float:12.1",
    **FRAME_FIELDS,
}
"""Fields of both layers, null where a value is not known."""


LEFT_OUT_FIELDS = {"kind": "str:16", "reason": "str:80", "area": "float:12.3"}
"""Fields of the layer of what was left out."""


def write_elevation(path: Path, elevation: Elevation) -> None:
    """Write wall, details and unseen areas as polygons in u, v."""
    features = [(_multi(shape), values) for shape, values in _features(elevation)]
    write_vector(path, "MultiPolygon", FIELDS, features, ELEVATION_CRS)


def write_left_out(path: Path, elevation: Elevation) -> None:
    """Write what is left out as polygons in u, v, with the fields `LEFT_OUT_FIELDS`."""
    features = (
        (_multi(item.shape), {"kind": item.kind, "reason": item.reason, "area": item.area})
        for item in elevation.left_out
    )
    write_vector(path, "MultiPolygon", LEFT_OUT_FIELDS, features, ELEVATION_CRS)


def write_details(path: Path, elevation: Elevation, crs: Optional[CRS]) -> None:
    """Write the same polygons in space, in the plane of the wall, with their areas in that plane."""
    features = [(_on_wall(_multi(shape), elevation), values) for shape, values in _features(elevation)]
    write_vector(path, "3D MultiPolygon", FIELDS, features, crs)


def in_space(shape: MultiPolygon, frame: Frame) -> MultiPolygon:
    """Return polygons in u, v as polygons in x, y, z."""
    return MultiPolygon(
        [
            Polygon(_lifted(part.exterior, frame), [_lifted(ring, frame) for ring in part.interiors])
            for part in shape.geoms
        ]
    )


def _on_wall(shape: MultiPolygon, elevation: Elevation) -> MultiPolygon:
    """Return polygons in u, v as polygons on the wall, which may turn."""
    if elevation.curve is None:
        return in_space(shape, elevation.frame)
    step = CHORD * (elevation.radius or SIDES_RADIUS)
    parts = []
    for part in shape.geoms:
        rings = [_denser(ring, step) for ring in (part.exterior, *part.interiors)]
        outer, *holes = (elevation.world(np.column_stack([uv, np.zeros(len(uv))])) for uv in rings)
        parts.append(Polygon(outer, holes))
    return MultiPolygon(parts)


def _denser(ring: LinearRing, step: float) -> np.ndarray:
    """Return the corners of a ring, with further ones on its edges, which follow a wall that turns."""
    corners = np.array(ring.coords)[:, :2]
    pieces = np.maximum(np.ceil(np.abs(np.diff(corners[:, 0])) / step).astype(int), 1)
    edges = [
        start + np.arange(count)[:, None] / count * (stop - start)
        for start, stop, count in zip(corners[:-1], corners[1:], pieces)
    ]
    return np.concatenate([*edges, corners[-1:]])


def frame_values(frame: Frame) -> dict[str, float]:
    """Return the frame by the names of its fields."""
    x, y, z = (float(value) for value in frame.origin)
    return {"x0": x, "y0": y, "z0": z, "azimuth": frame.azimuth, "tilt": frame.tilt}


def known(value: Optional[float]) -> Optional[float]:
    """Return a value, or None if it is not a number."""
    return None if value is None or math.isnan(value) else value


def _features(elevation: Elevation) -> Iterator[tuple[Shape, dict[str, Any]]]:
    """Yield shapes and values: the wall, unseen areas, details."""
    frame = {**frame_values(elevation.frame), "radius": elevation.radius}
    nothing: dict[str, Any] = dict.fromkeys(FIELDS)
    if not elevation.wall.is_empty:
        yield elevation.wall, {**nothing, **_size(elevation.wall, WALL), **frame}
    for area in elevation.unseen:
        yield area, {**nothing, **_size(area, UNSEEN), **frame}
    for detail in elevation.details:
        yield detail.outline, {**nothing, **_values(detail), **frame}


def _size(shape: Shape, kind: str) -> dict[str, Any]:
    left, bottom, right, top = shape.bounds
    return {"kind": kind, "width": right - left, "height": top - bottom, "sill": bottom, "area": shape.area}


def _values(detail: Detail) -> dict[str, Any]:
    edges = detail.edges
    red, green, blue = (None, None, None) if detail.colour is None else map(round, detail.colour)
    return {
        **_size(detail.outline, detail.kind),
        "id": detail.number,
        "use": detail.use,
        "shape": detail.shape,
        "head": detail.head,
        "measured": " ".join(detail.measured),
        "completed": " ".join(detail.completed),
        "open_side": " ".join(detail.open_sides),
        "wall_depth": detail.layer,
        "w_std": known(detail.width_std),
        "h_std": known(detail.height_std),
        "std_left": known(edges.left),
        "std_right": known(edges.right),
        "std_bottom": known(edges.bottom),
        "std_top": known(edges.top),
        "depth": known(detail.depth),
        "rms": known(detail.rms),
        "points": detail.points,
        "red": red,
        "green": green,
        "blue": blue,
        "intensity": detail.intensity,
    }


def _multi(shape: Shape) -> MultiPolygon:
    return shape if isinstance(shape, MultiPolygon) else MultiPolygon([shape])


def _lifted(ring: LinearRing, frame: Frame) -> np.ndarray:
    uv = np.array(ring.coords)[:, :2]
    return frame.world(np.column_stack([uv, np.zeros(len(uv))]))
