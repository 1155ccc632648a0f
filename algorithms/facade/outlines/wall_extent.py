"""The whole wall: the parts that were seen, those behind projections and shadows, without its holes."""

from collections.abc import Sequence
from dataclasses import dataclass

from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from ...geometry.polygons import made_valid
from ..elevation import COLOURED, PROJECTION
from .settings import WallSettings
from .surface import Surface


@dataclass(frozen=True)
class WholeWall:
    """A wall, in u and v.

    Attributes
    ----------
    face : BaseGeometry
        Without its openings and recesses.
    unseen : tuple of Polygon
        Areas that something hides, or from which no laser pulse came back.
    """

    face: BaseGeometry
    unseen: tuple[Polygon, ...]


def complete(
    wall: Surface,
    outlines: dict[str, list[Polygon]],
    deepest: float,
    smallest: float,
    settings: WallSettings = WallSettings(),
    parts: Sequence[Polygon] = (),
) -> WholeWall:
    """Return the whole wall.

    Parameters
    ----------
    wall : Surface
    outlines : dict of str to list of Polygon
        Of the details, by their kinds.
    deepest : float
        Of the projections (m).
    smallest : float
        Area of the smallest part (m2).
    settings : WallSettings
    parts : sequence of Polygon
        Of the facade, before or behind its main wall.
    """
    smooth = settings.smooth_spacings * wall.spacing
    before = unary_union([made_valid(outline) for outline in outlines.get(PROJECTION, [])])
    shells = [Polygon(part.exterior) for part in wall.outline.geoms if part.area >= smallest]
    others = [made_valid(part) for part in parts if part.area >= smallest]
    seen = unary_union([*(made_valid(part.simplify(smooth)) for part in shells), before, *others])
    holed = [
        made_valid(outline)
        for kind, own in outlines.items()
        if kind not in (COLOURED, PROJECTION)
        for outline in own
    ]
    hidden = [
        made_valid(Polygon(ring).simplify(smooth)) for part in wall.outline.geoms for ring in part.interiors
    ]
    hidden += _strips(seen, before, deepest, wall.spacing, settings)
    unseen = unary_union(hidden).difference(unary_union([before, *others, *holed]))
    # Slivers beside a projection are narrower than what was seen around them.
    unseen = unseen.buffer(-wall.spacing, join_style=2).buffer(wall.spacing, join_style=2)
    large = tuple(part for part in parts_of(unseen) if part.area >= smallest)
    edge = unary_union([seen, *large, *holed])
    edge = edge.buffer(settings.notch_spacings * wall.spacing, join_style=2)
    back = settings.smooth_spacings - settings.notch_spacings
    edge = made_valid(edge.buffer(back * wall.spacing, join_style=2))
    return WholeWall(edge.difference(unary_union(holed)), large)


def _strips(
    seen: BaseGeometry, before: BaseGeometry, deepest: float, spacing: float, settings: WallSettings
) -> list[Polygon]:
    """Return the gaps of a wall beside the projections that hide them."""
    if before.is_empty:
        return []
    width = min(settings.hidden * deepest, settings.hidden_m)
    closed = seen.buffer(0.5 * width, join_style=2).buffer(-0.5 * width, join_style=2)
    gaps = parts_of(closed.difference(seen))
    return [gap for gap in gaps if gap.distance(before) < settings.beside_spacings * spacing]


def parts_of(geometry: BaseGeometry) -> list[Polygon]:
    """Return the polygons of a geometry."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 0]
