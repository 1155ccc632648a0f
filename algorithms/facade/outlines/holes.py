"""Holes in a wall: openings, recesses, or scan shadows, by what was seen through them."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import LineString, MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union
from skimage.measure import points_in_poly

from ..elevation import OPENING, RECESS
from ..settings import FacadeSettings
from .settings import HoleSettings


@dataclass(frozen=True)
class Hole:
    """An area without points of the wall.

    Attributes
    ----------
    polygon : Polygon
        Along the outermost points of the wall.
    kind : str or None
        `OPENING` or `RECESS`; None where nothing was seen behind the wall.
    depth : float
        Median w of what was seen there; nan where nothing was.
    """

    polygon: Polygon
    kind: Optional[str]
    depth: float


def find_gaps(wall: MultiPolygon, smallest: float, settings: HoleSettings = HoleSettings()) -> list[Polygon]:
    """Return the holes of a wall, and the gaps in its foot, that are not smaller than `smallest` (m2)."""
    holes = [Polygon(ring) for part in wall.geoms for ring in part.interiors]
    shells = unary_union([Polygon(part.exterior) for part in wall.geoms])
    holes += _gaps_in_the_foot(shells, float(np.sqrt(smallest)), settings.mouth)
    # Two shells can lie one in the other.
    return [hole for hole in holes if hole.area >= smallest and not _is_covered(hole, wall)]


def _is_covered(hole: Polygon, wall: MultiPolygon) -> bool:
    return bool(wall.intersection(hole).area > 0.5 * hole.area)


def _gaps_in_the_foot(shells: BaseGeometry, width: float, mouth: float) -> list[Polygon]:
    if shells.is_empty:
        return []
    hull = shells.convex_hull
    foot = _lower_chain(hull)
    # Gaps narrower than the smallest detail are roughness of the foot.
    gaps = hull.difference(shells).buffer(-0.25 * width).buffer(0.25 * width, join_style=2)
    parts = getattr(gaps, "geoms", [gaps])
    return [part for part in parts if not part.is_empty and _is_gate(part, foot, width, mouth)]


def _lower_chain(hull: Polygon) -> LineString:
    corners = np.array(hull.exterior.coords)[:-1]
    if hull.exterior.is_ccw is False:
        corners = corners[::-1]
    first, last = np.argmin(corners[:, 0]), np.argmax(corners[:, 0])
    rolled = np.roll(corners, -first, axis=0)
    return LineString(rolled[: (last - first) % len(corners) + 1])


def _is_gate(gap: Polygon, foot: LineString, width: float, largest: float) -> bool:
    mouth = gap.exterior.intersection(foot.buffer(0.3 * width)).length
    return bool(0 < mouth <= largest * gap.length)


def classify(
    polygon: Polygon, uvw: np.ndarray, spacing: float, settings: FacadeSettings = FacadeSettings()
) -> Hole:
    """Return a gap in a wall with the kind that the points behind it show.

    Parameters
    ----------
    polygon : Polygon
    uvw : ndarray of float64, shape (n, 3)
        Of points behind the wall, w < 0, around the polygon at least.
    spacing : float
        Of points of the wall (m).
    settings : FacadeSettings
    """
    inside = within(polygon, uvw[:, :2])
    seen = uvw[inside]
    seen = seen[seen[:, 2] < -settings.distance_m]
    near = seen[seen[:, 2] > -settings.planes.depth_m]
    limits = settings.outlines.holes
    cell = limits.cell_spacings * spacing
    whole = max(polygon.area / cell**2, 1.0)
    if _cells(near, cell) >= limits.filled * whole:
        return Hole(polygon, RECESS, float(np.median(near[:, 2])))
    if _has_jambs(polygon, seen, cell, limits):
        return Hole(polygon, OPENING, float(np.median(seen[:, 2])))
    return Hole(polygon, None, float("nan"))


def _has_jambs(polygon: Polygon, seen: np.ndarray, cell: float, settings: HoleSettings) -> bool:
    close = seen[seen[:, 2] > -settings.jamb_depth_m]
    close = close[~within(polygon.buffer(-cell), close[:, :2])]
    return _cells(close, cell) >= settings.jambs * polygon.length / cell


def _cells(points: np.ndarray, size: float) -> int:
    return len(np.unique((points[:, :2] // size).astype(np.int64), axis=0))


def within(polygon: Polygon, points: np.ndarray) -> np.ndarray:
    """Return which points, shape (n, 2), lie in a polygon."""
    if polygon.is_empty:
        return np.zeros(len(points), bool)
    left, bottom, right, top = polygon.bounds
    inside = ((points >= (left, bottom)) & (points <= (right, top))).all(axis=1)
    near = points[inside]
    held = np.zeros(len(near), bool)
    for part in getattr(polygon, "geoms", [polygon]):
        # A ring inverts the points within it: those in a hole are inverted twice.
        for ring in (part.exterior, *part.interiors):
            held ^= points_in_poly(near, np.array(ring.coords)[:, :2])
    inside[inside] = held
    return inside
