"""Sound polygons of rings that cross themselves or each other."""

from collections.abc import Sequence

import numpy as np
from shapely.affinity import translate
from shapely.geometry import Polygon
from shapely.ops import unary_union
from shapely.validation import make_valid

BRIDGE = 0.002
"""Overlap (m) of the bridge between parts of a wall that its sides have come apart into."""

FARTHEST = 0.2
"""Parts farther from each other than this (m) are walls of their own."""

SHORTEST = 0.5
"""Unless their outline is shorter than this, metres."""


def polygons_between(rings: Sequence, origin: tuple, within: Polygon) -> list:
    """Return the polygons of an outer ring and its holes, made valid, the largest first; none of nothing.

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
    """
    outer, *holes = (_valid(Polygon(ring) if len(ring) >= 3 else Polygon()) for ring in rings)
    shape = outer.symmetric_difference(unary_union(holes)) if holes else outer
    first, *others = _joined(_valid(translate(shape, *origin)).intersection(within)) or [None]
    return [first, *(part for part in others if part.length >= SHORTEST)] if first else []


def _valid(geometry):
    return geometry if geometry.is_valid else make_valid(geometry).buffer(0)


def _joined(geometry) -> list:
    """Return the parts of a geometry, those near each other bridged to one, the largest first."""
    parts, found = sorted(polygons_of(geometry), key=lambda part: -part.area), []
    while parts:
        whole, left = parts.pop(0), []
        while parts:
            distances = [whole.distance(part) for part in parts]
            part, reach = parts.pop(int(np.argmin(distances))), min(distances) + BRIDGE
            if reach > FARTHEST:
                left = [part, *parts]
                break
            bridge = whole.buffer(reach).intersection(part.buffer(reach))
            whole = max(polygons_of(unary_union([whole, part, bridge])), key=lambda one: one.area)
        found.append(whole)
        parts = sorted(left, key=lambda part: -part.area)
    return sorted(found, key=lambda part: -part.area)


def polygons_of(geometry) -> list:
    """Return the polygons of a geometry that have an area and are valid."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 0 and part.is_valid]
