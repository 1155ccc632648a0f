"""Sound polygons of rings that cross themselves or each other."""

from collections.abc import Sequence

import numpy as np
from shapely import wkb
from shapely.affinity import translate
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import polygonize, unary_union
from shapely.validation import make_valid

from .settings import BridgeSettings

LITTLE_ENDIAN, LINESTRING, MULTILINESTRING = 1, 2, 5
"""Codes of well-known binary."""


def polygons_between(
    rings: Sequence[np.ndarray],
    origin: tuple[float, float],
    within: Polygon,
    settings: BridgeSettings = BridgeSettings(),
) -> list[Polygon]:
    """Return the polygons of an outer ring and its holes, made valid, the largest first.

    The two faces of a thin wall may cross; the wall is then between them on either side of the crossing.
    Parts are joined where they are near each other.

    Parameters
    ----------
    rings : sequence of ndarray, shape (n, 2)
        Corners of the outer ring and of the holes, the first not repeated.
    origin : tuple of two float
        Where the coordinates of the rings begin, in world coordinates.
    within : Polygon
        What lies outside is cut off; world coordinates.
    settings : BridgeSettings
    """
    outer, *holes = (made_valid(Polygon(ring) if len(ring) >= 3 else Polygon()) for ring in rings)
    shape = outer.symmetric_difference(unary_union(holes)) if holes else outer
    whole = made_valid(translate(shape, *origin)).intersection(within)
    parts = _joined(whole, settings)
    return parts[:1] + [part for part in parts[1:] if part.length >= settings.shortest_m]


def faces_of(segments: np.ndarray) -> list[Polygon]:
    """Return the faces between segments, shape (k, 2, 2), which meet at their ends only."""
    if not len(segments):
        return []
    # As bytes (WKB), because shapely would make a Python object of each line.
    head = [("order", "u1"), ("kind", "<u4"), ("count", "<u4")]
    whole, lines = np.empty(1, head), np.empty(len(segments), [*head, ("ends", "<f8", 4)])
    for part, kind, count in ((whole, MULTILINESTRING, len(segments)), (lines, LINESTRING, 2)):
        part["order"], part["kind"], part["count"] = LITTLE_ENDIAN, kind, count
    lines["ends"] = segments.reshape(-1, 4)
    return list(polygonize([wkb.loads(whole.tobytes() + lines.tobytes())]))


def made_valid(geometry: BaseGeometry) -> BaseGeometry:
    """Return a geometry, repaired if it crosses or touches itself."""
    return geometry if geometry.is_valid else make_valid(geometry).buffer(0)


def _joined(geometry: BaseGeometry, settings: BridgeSettings) -> list[Polygon]:
    """Return the parts of a geometry, those near each other bridged to one, the largest first."""
    parts, found = sorted(polygons_of(geometry), key=lambda part: -part.area), []
    while parts:
        whole, left = parts.pop(0), []
        while parts:
            distances = [whole.distance(part) for part in parts]
            part, reach = parts.pop(int(np.argmin(distances))), min(distances) + settings.overlap_m
            if reach > settings.farthest_m:
                left = [part, *parts]
                break
            bridge = whole.buffer(reach).intersection(part.buffer(reach))
            whole = max(polygons_of(unary_union([whole, part, bridge])), key=lambda one: one.area)
        found.append(whole)
        parts = sorted(left, key=lambda part: -part.area)
    return sorted(found, key=lambda part: -part.area)


def polygons_of(geometry: BaseGeometry) -> list[Polygon]:
    """Return the polygons of a geometry that have an area and are valid."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 0 and part.is_valid]


def box_sides(polygon: Polygon) -> tuple[float, float]:
    """Return width and length of the smallest box around a polygon, turned as it may be."""
    corners = np.asarray(polygon.minimum_rotated_rectangle.exterior.coords)
    width, length = sorted(np.hypot(*np.diff(corners[:3], axis=0).T))
    return float(width), float(length)
