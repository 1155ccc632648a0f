"""Comparison of a plan with the true walls beyond its boundary: thickness, rooms, and false walls."""

from collections.abc import Iterator
from typing import Optional

import numpy as np
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

THICKEST = 1.2
"""Thicker sections are columns and corners, not walls (m)."""

SECTIONS = 0.25
"""Distance between the stations at which the thickness is measured (m)."""

NEAR = 0.01
"""A point this near to the seen boundary counts as seen (m)."""

OFF = 0.20
"""A face further than this from the true wall is not compared with it, and a wall is false (m)."""

DEPTH = 0.04
"""A point this far behind a face is inside every wall, however thin (m)."""

WIDEST_DOOR = 1.3
"""A gap in a wall up to this width does not open a room (m)."""

DOUBT, DOUBTFUL = 0.1, 0.05
"""Rooms are left out if their area changes by this share when doors are this much narrower or wider (m)."""

SMALLEST_ROOM = 1.5
"""Square metres."""

SEEN_SHARE = 0.95
"""Share of the boundary of a room that must have been seen for its area to be compared."""

CELL = 0.25
"""Rooms are looked through in cells so wide (m)."""


def thickness_errors(walls: BaseGeometry, truth: BaseGeometry, seen: BaseGeometry) -> np.ndarray:
    """Return the errors of the thickness of walls, at sections across true walls with both faces seen.

    Returns
    -------
    ndarray, shape (n,)
        In metres. Sections where the plan lacks a face are left out, because completeness counts them.
    """
    errors = []
    for place, inwards in _sections(truth):
        true = _interval(place, inwards, truth)
        if true is None or seen.distance(Point(place)) > NEAR:
            continue
        back = place + true[1] * inwards
        if true[1] > THICKEST or seen.distance(Point(back)) > NEAR:
            continue
        found = _interval(place, inwards, walls)
        if found and abs(found[0]) < OFF and abs(found[1] - true[1]) < OFF:
            errors.append(found[1] - found[0] - true[1])
    return np.array(errors)


def room_errors(walls: BaseGeometry, truth: BaseGeometry, seen: BaseGeometry) -> list[float]:
    """Return the error of the area of each true room seen all around, as a share of its area.

    A room that the plan lacks counts 1.
    """
    found = closed_spaces(walls, WIDEST_DOOR)
    others = [closed_spaces(truth, WIDEST_DOOR + change) for change in (-DOUBT, DOUBT)]
    errors = []
    for room in closed_spaces(truth, WIDEST_DOOR):
        faces = room.boundary.intersection(truth.boundary.buffer(NEAR))
        was_seen = faces.intersection(seen.buffer(NEAR)).length >= SEEN_SHARE * faces.length
        if was_seen and all(_difference(room, spaces) < DOUBTFUL for spaces in others):
            errors.append(_difference(room, found))
    return errors


def _difference(room: Polygon, spaces: list[Polygon]) -> float:
    """Return the error of the area of the space that matches a room; 1 without such a space."""
    same = max(spaces, key=lambda space: room.intersection(space).area, default=Polygon())
    if room.intersection(same).area <= 0.5 * max(room.area, same.area):
        return 1.0
    return abs(same.area - room.area) / room.area


def closed_spaces(walls: BaseGeometry, widest_door: float) -> list[Polygon]:
    """Return the spaces that walls enclose after gaps up to `widest_door` (m) are bridged.

    Corners are rounded, because GEOS loses rooms with sharp ones.
    """
    narrowed = walls.buffer(widest_door / 2)
    around = narrowed.envelope.buffer(1.0)
    free = around.difference(narrowed)
    # One by one, because rooms on both sides of a thin wall would meet in its doors.
    spaces = [
        part.buffer(widest_door / 2)
        for part in getattr(free, "geoms", [free])
        if not part.touches(around.boundary)
    ]
    return [space for space in spaces if space.area >= SMALLEST_ROOM]


def phantom_length(walls: BaseGeometry, truth: BaseGeometry) -> float:
    """Return the length of the longest piece of the plan further than `OFF` from all true walls."""
    phantoms = walls.difference(truth.buffer(OFF))
    lengths = [_extent(part) for part in getattr(phantoms, "geoms", [phantoms]) if not part.is_empty]
    return max(lengths, default=0.0)


def seen_share(room: Polygon, points: np.ndarray) -> float:
    """Return the share of the cells within a room that hold one of `points`, shape (n, 3), at any height."""
    inside = room.buffer(-CELL / 2)
    west, south, east, north = inside.bounds
    columns, rows = np.arange(west, east, CELL), np.arange(south, north, CELL)
    within = np.array([[inside.contains(Point(x, y)) for y in rows] for x in columns])
    edges = [np.append(middles, middles[-1] + CELL) - CELL / 2 for middles in (columns, rows)]
    counts = np.histogram2d(points[:, 0], points[:, 1], bins=edges)[0]
    return float((counts[within] > 0).mean())


def _extent(shape: BaseGeometry) -> float:
    """Return the longer side of the smallest rectangle around a shape."""
    rectangle = shape.minimum_rotated_rectangle
    corners = np.asarray(rectangle.exterior.coords if rectangle.geom_type == "Polygon" else rectangle.coords)
    return float(np.hypot(*np.diff(corners, axis=0).T).max())


def _sections(truth: BaseGeometry) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield points along the boundary, and the directions into the wall there."""
    for part in truth.geoms:
        polygon = orient(part)
        for ring in (polygon.exterior, *polygon.interiors):
            corners = np.asarray(ring.coords)
            for start, end in zip(corners, corners[1:]):
                length = np.hypot(*(end - start))
                # A corner may be listed twice.
                along = (end - start) / max(length, 1e-9)
                for way in np.arange(SECTIONS / 2, length, SECTIONS):
                    yield start + way * along, np.array([-along[1], along[0]])


def _interval(place: np.ndarray, inwards: np.ndarray, walls: BaseGeometry) -> Optional[tuple[float, float]]:
    """Return the limits of the wall along a line across it, in metres from `place`; None outside walls."""
    line = LineString([place - OFF * inwards, place + (THICKEST + OFF) * inwards])
    parts = line.intersection(walls)
    inner = Point(place + DEPTH * inwards)
    for part in getattr(parts, "geoms", [parts]):
        if part.length and part.distance(inner) < 1e-3:
            ends = (np.asarray(part.coords) - place) @ inwards
            return float(ends.min()), float(ends.max())
    return None
