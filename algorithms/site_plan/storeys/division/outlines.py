"""Outlines without what says nothing: tiny edges, and corners that lie on a line."""

from collections.abc import Iterable

import numpy as np
from shapely.geometry import LinearRing, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from ....geometry.polygons import made_valid, polygons_of
from ..settings import WallSettings


def parts_of(geometry: BaseGeometry) -> list[BaseGeometry]:
    """Return the parts of a geometry that are not empty."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if not part.is_empty]


def united(geometries: Iterable[BaseGeometry]) -> BaseGeometry:
    """Return the union of the areas of geometries; lines and points in them are dropped."""
    polygons = [part for geometry in geometries for part in polygons_of(geometry)]
    # An older shapely crashes on collections in a union.
    return unary_union(polygons) if polygons else Polygon()


def tidy(outline: Polygon, settings: WallSettings = WallSettings()) -> Polygon:
    """Return an outline without edges shorter than `shortest_m` and corners within `straight_m` of a line."""
    rings = [_tidied(ring, settings) for ring in (outline.exterior, *outline.interiors)]
    rings = [ring for ring in rings if len(ring) >= 3]
    if not rings:
        return outline
    found = Polygon(rings[0], rings[1:])
    return found if found.is_valid else outline


def _tidied(ring: LinearRing, settings: WallSettings) -> np.ndarray:
    """Return the corners of a ring, the worst dropped one after the other."""
    corners = np.asarray(ring.coords)[:-1, :2]
    while len(corners) > 3:
        before, after = np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0)
        chord = after - before
        off = np.abs(chord[:, 0] * (corners - before)[:, 1] - chord[:, 1] * (corners - before)[:, 0])
        off /= np.maximum(np.hypot(*chord.T), 1e-12)
        edge = np.hypot(*(after - corners).T)
        short = (edge < settings.shortest_m) | (np.roll(edge, 1) < settings.shortest_m)
        off[~short & (off > settings.straight_m)] = np.inf
        worst = int(np.argmin(off))
        if not np.isfinite(off[worst]):
            break
        corners = np.delete(corners, worst, axis=0)
    return corners


def sound(outline: Polygon) -> Polygon:
    """Return an outline, or the largest part of one that crosses or touches itself."""
    return max(polygons_of(made_valid(outline)), key=lambda part: part.area, default=outline)
