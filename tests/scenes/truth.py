"""The true walls of a scene, and the part of their boundary that a scan has met."""

from collections.abc import Sequence

import numpy as np
from shapely.geometry import LineString, MultiLineString, MultiPolygon, Polygon
from shapely.ops import linemerge, unary_union

from .scanner import Bodies
from .things import Ground, Prism

LOWEST_WALL = 0.8
CUT = 1.1
"""Height above the ground at which plans are drawn (m)."""

FEWEST_HITS = 3
# Far above the rounding of coordinates, far below the noise of a scan.
SNAP = 1e-6


def dissolved(footprints: Sequence[Polygon]) -> MultiPolygon:
    """Return the union of `footprints`, closing the rounding gaps between those that touch."""
    grown = unary_union([footprint.buffer(SNAP, join_style=2) for footprint in footprints])
    union = grown.buffer(-SNAP, join_style=2)
    return MultiPolygon([part for part in getattr(union, "geoms", [union]) if not part.is_empty])


def is_wall(prism: Prism, ground: Ground) -> bool:
    """Whether `prism` is a wall high enough to be found."""
    return prism.material == "wall" and prism.rise(ground) >= LOWEST_WALL


def is_footing(prism: Prism, ground: Ground) -> bool:
    """Whether `prism` is a wall too low to be found."""
    return prism.material == "wall" and prism.rise(ground) < LOWEST_WALL


def is_cut(prism: Prism, ground: Ground) -> bool:
    """Whether `prism` is a wall where plans are cut."""
    middle = prism.footprint.representative_point()
    cut = ground.height(middle.x, middle.y) + CUT
    return prism.material == "wall" and prism.bottom < cut and prism.rise(ground) > CUT


def seen_boundary(
    truth: MultiPolygon, walls: np.ndarray, bodies: Bodies, hits: np.ndarray
) -> MultiLineString:
    """Return the part of the boundary of `truth` that rays have met.

    Parameters
    ----------
    truth : MultiPolygon
    walls : ndarray of bool, shape (prisms,)
        Which of `bodies` are part of `truth`.
    bodies : Bodies
    hits : ndarray, shape (pieces,)
        Numbers of rays that met each piece of an edge; `FEWEST_HITS` are needed.
    """
    lines = []
    for edge in np.flatnonzero(walls[bodies.edge_prism]):
        pieces = slice(bodies.first_piece[edge], bodies.first_piece[edge + 1])
        seen = np.concatenate([[False], hits[pieces] >= FEWEST_HITS, [False]])
        ends = np.flatnonzero(seen[1:] != seen[:-1]).reshape(-1, 2) / (len(seen) - 2)
        start, stop = bodies.edges[edge, :2], bodies.edges[edge, 2:]
        lines.extend(LineString(start + share[:, None] * (stop - start)) for share in ends)
    if not lines:
        return MultiLineString()
    # Rays can meet an edge between two walls of different heights, but it is inside the truth.
    on_boundary = unary_union(lines).intersection(truth.boundary.buffer(2 * SNAP))
    parts = [part for part in getattr(on_boundary, "geoms", [on_boundary]) if part.length > 1e-3]
    merged = linemerge(parts) if parts else MultiLineString()
    return MultiLineString(list(getattr(merged, "geoms", [merged])))
