"""Holes in a wall: what was seen through them tells openings and recesses from mere shadows."""

from dataclasses import dataclass

import numpy as np
from shapely.geometry import LineString, MultiPolygon, Polygon
from shapely.ops import unary_union
from skimage.measure import points_in_poly

from ..elevation import OPENING, RECESS

NEAR = 1.0
"""A surface that fills a hole lies at most this far behind the wall (m)."""

FILLED = 0.5
"""Share of a hole with a surface behind it, in a recess."""

JAMBS, JAMB_DEPTH = 0.1, 0.5
"""Share of the border of an opening with points close behind the wall (m). What is seen deep in a room may
lie behind a hidden place of the wall, for it was seen through a window beside it."""

CELLS = 3.0
"""Side of the cells in which that is counted, in spacings."""

MOUTH = 0.45
"""Largest share of the circumference of a hole that may be the foot of the wall, as in a gate."""


@dataclass(frozen=True)
class Hole:
    """A place without points of the wall.

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
    kind: str
    depth: float


def find_gaps(wall: MultiPolygon, smallest: float) -> list[Polygon]:
    """Return the holes of a wall, and the gaps in its foot, that are not smaller than `smallest` (m2)."""
    holes = [Polygon(ring) for part in wall.geoms for ring in part.interiors]
    shells = unary_union([Polygon(part.exterior) for part in wall.geoms])
    holes += _gaps_in_the_foot(shells, float(np.sqrt(smallest)))
    # Two shells can lie one in the other.
    return [hole for hole in holes if hole.area >= smallest and not _is_covered(hole, wall)]


def _is_covered(hole: Polygon, wall: MultiPolygon) -> bool:
    return wall.intersection(hole).area > 0.5 * hole.area


def _gaps_in_the_foot(shells, width: float) -> list[Polygon]:
    if shells.is_empty:
        return []
    hull = shells.convex_hull
    foot = _lower_chain(hull)
    # What is narrower than the smallest detail is roughness of the foot.
    gaps = hull.difference(shells).buffer(-0.25 * width).buffer(0.25 * width, join_style=2)
    parts = getattr(gaps, "geoms", [gaps])
    return [part for part in parts if not part.is_empty and _is_gate(part, foot, width)]


def _lower_chain(hull: Polygon) -> LineString:
    corners = np.array(hull.exterior.coords)[:-1]
    if hull.exterior.is_ccw is False:
        corners = corners[::-1]
    first, last = np.argmin(corners[:, 0]), np.argmax(corners[:, 0])
    rolled = np.roll(corners, -first, axis=0)
    return LineString(rolled[: (last - first) % len(corners) + 1])


def _is_gate(gap: Polygon, foot: LineString, width: float) -> bool:
    mouth = gap.exterior.intersection(foot.buffer(0.3 * width)).length
    return 0 < mouth <= MOUTH * gap.length


def classify(polygon: Polygon, uvw: np.ndarray, distance: float, spacing: float) -> Hole:
    """Tell what a gap in a wall is by the points behind it.

    Parameters
    ----------
    polygon : Polygon
    uvw : ndarray of float64, shape (n, 3)
        Of points behind the wall, w < 0, around the polygon at least.
    distance : float
        ds, of points of the wall (m).
    spacing : float
        Of points of the wall (m).
    """
    inside = within(polygon, uvw[:, :2])
    seen = uvw[inside]
    seen = seen[seen[:, 2] < -distance]
    near = seen[seen[:, 2] > -NEAR]
    cell = CELLS * spacing
    whole = max(polygon.area / cell**2, 1.0)
    if _cells(near, cell) >= FILLED * whole:
        return Hole(polygon, RECESS, float(np.median(near[:, 2])))
    if _has_jambs(polygon, seen, cell):
        return Hole(polygon, OPENING, float(np.median(seen[:, 2])))
    return Hole(polygon, None, float("nan"))


def _has_jambs(polygon: Polygon, seen: np.ndarray, cell: float) -> bool:
    close = seen[seen[:, 2] > -JAMB_DEPTH]
    close = close[~within(polygon.buffer(-cell), close[:, :2])]
    return _cells(close, cell) >= JAMBS * polygon.length / cell


def _cells(points: np.ndarray, size: float) -> int:
    return len(np.unique((points[:, :2] // size).astype(np.int64), axis=0))


def within(polygon: Polygon, points: np.ndarray) -> np.ndarray:
    """Tell which points, shape (n, 2), lie in a polygon."""
    if polygon.is_empty:
        return np.zeros(len(points), bool)
    left, bottom, right, top = polygon.bounds
    inside = ((points >= (left, bottom)) & (points <= (right, top))).all(axis=1)
    near = points[inside]
    held = np.zeros(len(near), bool)
    for part in getattr(polygon, "geoms", [polygon]):
        # The holes of a part turn what its shell has turned.
        for ring in (part.exterior, *part.interiors):
            held ^= points_in_poly(near, np.array(ring.coords)[:, :2])
    inside[inside] = held
    return inside
