"""The whole wall: what was seen of it, with what hides parts of it, and without its holes."""

from dataclasses import dataclass

from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from ..elevation import COLOURED, PROJECTION
from .holes import Hole
from .surface import Surface

DEEP, DEEPEST = 2.0, 0.5
"""A projection hides a strip of the wall that is this many times wider than it is deep, but no wider (m)."""

NEAR = 3.0
"""A gap is beside a projection if it is nearer than this many spacings."""

SMOOTH, NOTCH = 0.5, 2.0
"""Outlines that only single points give are smoothed by so many spacings, and notches of less than twice
the second filled. The wall ends half a spacing beyond its outermost points."""


@dataclass(frozen=True)
class WholeWall:
    """A wall, in u and v.

    Attributes
    ----------
    face : BaseGeometry
        Without its openings and recesses.
    unseen : tuple of Polygon
        Places that something hides, or where nothing came back.
    """

    face: BaseGeometry
    unseen: tuple[Polygon, ...]


def complete(
    wall: Surface, holes: list[Hole], outlines: dict[str, list], deepest: float, smallest: float
) -> WholeWall:
    """Return the whole wall.

    Parameters
    ----------
    wall : Surface
    holes : list of Hole
    outlines : dict of str to list of Polygon
        Of the details, by their kinds.
    deepest : float
        Of the projections (m).
    smallest : float
        Area of the smallest part (m2).
    """
    smooth = SMOOTH * wall.spacing
    before = unary_union(outlines.get(PROJECTION, []))
    shells = [Polygon(part.exterior) for part in wall.outline.geoms if part.area >= smallest]
    seen = unary_union([part.simplify(smooth) for part in shells] + [before])
    hidden = [hole.polygon.simplify(smooth) for hole in holes if hole.kind is None]
    hidden += _strips(seen, before, min(DEEP * deepest, DEEPEST), wall.spacing)
    unseen = unary_union(hidden).difference(before)
    # Slivers beside a projection are narrower than what was seen around them.
    unseen = unseen.buffer(-wall.spacing, join_style=2).buffer(wall.spacing, join_style=2)
    unseen = tuple(part for part in parts_of(unseen) if part.area >= smallest)
    holed = [
        outline for kind, own in outlines.items() if kind not in (COLOURED, PROJECTION) for outline in own
    ]
    edge = unary_union([seen, *unseen, *holed]).buffer(NOTCH * wall.spacing, join_style=2)
    edge = edge.buffer((SMOOTH - NOTCH) * wall.spacing, join_style=2)
    return WholeWall(edge.difference(unary_union(holed)), unseen)


def _strips(seen: BaseGeometry, before: BaseGeometry, width: float, spacing: float) -> list[Polygon]:
    """Return the gaps of a wall beside the projections that hide them."""
    if before.is_empty:
        return []
    closed = seen.buffer(0.5 * width, join_style=2).buffer(-0.5 * width, join_style=2)
    gaps = parts_of(closed.difference(seen))
    return [gap for gap in gaps if gap.distance(before) < NEAR * spacing]


def parts_of(geometry: BaseGeometry) -> list[Polygon]:
    """Return the polygons of a geometry."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 0]
