"""Sound polygons of rings that cross themselves or each other."""

from collections.abc import Sequence
from typing import Optional

import numpy as np
from shapely.affinity import translate
from shapely.geometry import Polygon
from shapely.ops import unary_union
from shapely.validation import make_valid

BRIDGE = 0.002
"""Overlap (m) of the bridge between parts of a wall that its sides have come apart into."""

FARTHEST = 0.2
"""Parts farther from each other than this (m) are not joined, and only the largest is kept."""


def polygon_of(rings: Sequence, origin: tuple) -> Optional[Polygon]:
    """Return the polygon of an outer ring and its holes, made valid; None if there is none.

    The two faces of a thin wall may cross; the wall is then between them on either side of the crossing.

    Parameters
    ----------
    rings : sequence of ndarray, shape (n, 2)
        Corners of the outer ring and of the holes, the first not repeated.
    origin : tuple of two float
        Where the coordinates of the rings begin, in world coordinates.
    """
    outer, *holes = (_valid(Polygon(ring) if len(ring) >= 3 else Polygon()) for ring in rings)
    outline = translate(outer.symmetric_difference(unary_union(holes)) if holes else outer, *origin)
    if outline.geom_type == "Polygon" and outline.is_valid:
        return outline
    return joined(_valid(outline))


def _valid(geometry):
    return geometry if geometry.is_valid else make_valid(geometry).buffer(0)


def joined(geometry) -> Optional[Polygon]:
    """Return the parts of a geometry as one polygon, bridged where they are nearest."""
    whole, *parts = sorted(polygons_of(geometry), key=lambda part: -part.area) or [None]
    while parts:
        distances = [whole.distance(part) for part in parts]
        part, reach = parts.pop(int(np.argmin(distances))), min(distances) + BRIDGE
        if reach > FARTHEST:
            break
        bridge = whole.buffer(reach).intersection(part.buffer(reach))
        united = polygons_of(unary_union([whole, part, bridge]))
        whole = max(united, key=lambda one: one.area)
    return whole


def polygons_of(geometry) -> list:
    """Return the polygons of a geometry that have an area and are valid."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 0 and part.is_valid]
