"""Regular outlines: jambs, sill and head, each fitted to the border on its own; or a circle."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import Polygon

from ...geometry.circles import arc_through
from ...geometry.polygons import made_valid, polygons_of
from ..elevation import ARCH, CIRCLE, FREE, RECTANGLE, TRAPEZIUM, Edges
from .border import Border
from .edges import Edge, border_deviation, edge_at_wall, fit_edge
from .heads import FLAT, SLOPED, Head, fit_head
from .settings import OutlineSettings
from .surface import within

NOTHING = float("nan")
CORNERS = 96
"""Of the polygon that represents a circle."""


@dataclass(frozen=True)
class Outline:
    """The outline of a detail.

    Attributes
    ----------
    shape : str
    head : str or None
        Of a rectangle, a trapezium or an arch; see `heads`.
    polygon : Polygon
    edges : Edges
    rms : float
        Of the crossings of the border against the outline (m).
    completed : tuple of str
        Edges that were not seen, and are where the openings of the same row have theirs.
    """

    shape: str
    head: Optional[str]
    polygon: Polygon
    edges: Edges
    rms: float
    completed: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Sides:
    left: Edge
    bottom: Edge
    right: Edge
    top: Edge
    head: Optional[Head] = None


def make_outline(
    border: Border,
    regularise: bool,
    settings: OutlineSettings = OutlineSettings(),
    region: Optional[Polygon] = None,
) -> Outline:
    """Return the outline of a detail: regular if wanted and if the border allows, else as it was seen.

    Parameters
    ----------
    border : Border
    regularise : bool
    settings : OutlineSettings
    region : Polygon, optional
        The hole of the wall, where it is known from what is seen in it. It limits the edges that were not
        measured.
    """
    ring = border.ring if region is None else region
    if not regularise or not border.seen.any():
        return _free(border, ring, settings)
    circle = _circle(border, ring, settings)
    if circle is not None:
        return circle
    sides = _fit(border, ring, settings)
    polygon = _polygon(sides)
    off = _off(border, polygon)
    shapes = settings.shapes
    reach = np.maximum(shapes.outlying_gaps * border.gaps, shapes.outlying_m)
    measured = sum(edge.measured for edge in (sides.left, sides.bottom, sides.right, sides.top))
    counted = border.seen
    if measured >= shapes.sides_of_shadowed:
        # A shadow beside an opening is a part of its hole, and shows nothing.
        beyond = (off > reach) & ~within(polygon, border.crossings)
        counted = border.seen & (border.shown | ~beyond)
    contradicted = float(np.mean(off[counted] > reach[counted]))
    alike = _iou(polygon, ring)
    agrees = contradicted <= shapes.contradicted or (
        contradicted <= shapes.most_contradicted and alike >= shapes.alike
    )
    if not agrees or measured < shapes.fewest_sides:
        return _free(border, ring, settings)
    near = border.seen & (off <= reach)
    edges = Edges(sides.left.std, sides.right.std, sides.bottom.std, sides.top.std)
    kind = FLAT if sides.head is None else sides.head.kind
    shape = {FLAT: RECTANGLE, SLOPED: TRAPEZIUM}.get(kind, ARCH)
    rms = float(np.sqrt(np.mean(off[near] ** 2))) if near.any() else NOTHING
    return Outline(shape, kind, polygon, edges, rms)


def _fit(border: Border, ring: Polygon, settings: OutlineSettings) -> _Sides:
    """Return the sides: the jambs and the sill first, then the head between them."""
    left, bottom, right, top = ring.bounds
    sides = _Sides(Edge(left, NOTHING), Edge(bottom, NOTHING), Edge(right, NOTHING), Edge(top, NOTHING))
    for _ in range(settings.shapes.rounds):
        low, high = sides.bottom.position, sides.top.position
        wide = settings.shapes.near * (sides.right.position - sides.left.position)
        tall = settings.shapes.near * (high - low)
        spans = (low, high), (sides.left.position, sides.right.position)
        sides = _Sides(
            _side(border, 0, sides.left.position, spans[0], wide, settings),
            _side(border, 1, low, spans[1], tall, settings),
            _side(border, 0, sides.right.position, spans[0], wide, settings),
            _side(border, 1, high, spans[1], tall, settings),
        )
    top, width = sides.top, sides.right.position - sides.left.position
    if top.measured and top.last - top.first >= settings.heads.flat_extent * width:
        return sides
    head = _head(border, sides, settings)
    if head is None or (head.kind == FLAT and top.measured and not head.sags):
        return sides
    crown = Edge(float(head.line[:, 1].max()), head.std)
    return _Sides(sides.left, sides.bottom, sides.right, crown, None if head.kind == FLAT else head)


def _side(
    border: Border,
    axis: int,
    start: float,
    span: tuple[float, float],
    reach: float,
    settings: OutlineSettings,
) -> Edge:
    """Return an edge across an axis: by its jamb where one was seen, otherwise by the points beside it."""
    crossings, gaps = border.crossings[border.seen], border.gaps[border.seen]
    near = np.abs(crossings[:, axis] - start) <= reach
    across, along = crossings[near, axis], crossings[near, 1 - axis]
    edge = fit_edge(across, along, gaps[near], span, start, settings, border.spacing)
    if not edge.measured or not len(border.jambs):
        return edge
    flush = _flush(gaps[near], border, settings)
    jamb = border.jambs[np.abs(border.jambs[:, axis] - edge.position) <= flush]
    none = np.zeros(len(jamb))
    direct = fit_edge(jamb[:, axis], jamb[:, 1 - axis], none, span, start, settings, border.spacing)
    if not direct.measured:
        return edge
    own = np.abs(jamb[:, axis] - direct.position) <= flush
    start_of_jamb = -float(np.percentile(jamb[own, 2], 90))
    # What begins deeper in the wall is a frame, which may be narrower or wider than the opening.
    if start_of_jamb > settings.jambs.start_m + border.spacing:
        return edge
    across, depths = border.jambs[:, axis], -border.jambs[:, 2]
    inside = (border.jambs[:, 1 - axis] > span[0]) & (border.jambs[:, 1 - axis] < span[1])
    return edge_at_wall(direct, across[inside], depths[inside], flush, settings)


def _flush(gaps: np.ndarray, border: Border, settings: OutlineSettings) -> float:
    """Return how far a jamb may lie from where the wall ends (m)."""
    edges, gap = settings.edges, float(np.median(gaps))
    flush = edges.flush_gaps * gap
    # The wall ends within a spacing of its edge, and its border is in the middle of that.
    return (min(flush, 0.5 * border.spacing) if border.spacing > 0 else flush) + settings.noise_m


def _head(border: Border, sides: _Sides, settings: OutlineSettings) -> Optional[Head]:
    left, right, bottom = sides.left.position, sides.right.position, sides.bottom.position
    points, gaps = border.crossings[border.seen], border.gaps[border.seen]
    middle = 0.5 * (bottom + max(sides.top.position, bottom))
    corner = settings.edges.corner_gaps * max(float(np.median(gaps)), border.spacing)
    between = (points[:, 0] > left + corner) & (points[:, 0] < right - corner) & (points[:, 1] > middle)
    head = fit_head(points[between], gaps[between], (left, right), settings, border.spacing)
    if head is None:
        return None
    flush = _flush(gaps, border, settings)
    jambs = border.jambs[:, :2]
    soffit = jambs[(jambs[:, 0] > left + corner) & (jambs[:, 0] < right - corner) & (jambs[:, 1] > middle)]
    soffit = soffit[head.off(soffit) <= flush] if len(soffit) else soffit
    direct = fit_head(soffit, np.zeros(len(soffit)), (left, right), settings)
    return direct if direct is not None and direct.kind == head.kind else head


def _polygon(sides: _Sides) -> Polygon:
    left, bottom, right, top = (edge.position for edge in (sides.left, sides.bottom, sides.right, sides.top))
    foot = [(left, bottom), (right, bottom)]
    head = [(right, top), (left, top)] if sides.head is None else sides.head.line.tolist()
    polygon = Polygon([*foot, *head])
    return polygon if polygon.is_valid else Polygon(polygon.convex_hull.exterior)


def _off(border: Border, polygon: Polygon) -> np.ndarray:
    """Return the distances of the crossings from an outline."""
    line = np.array(polygon.exterior.coords)
    return Head("", line, NOTHING).off(border.crossings)


def _iou(first: Polygon, second: Polygon) -> float:
    both = made_valid(first).intersection(made_valid(second)).area
    return float(both / max(first.area + second.area - both, 1e-12))


def _circle(border: Border, ring: Polygon, settings: OutlineSettings) -> Optional[Outline]:
    """Return the outline if it is a circle."""
    shapes = settings.shapes
    left, bottom, right, top = ring.bounds
    wide, tall = right - left, top - bottom
    points, gaps = border.crossings[border.seen], border.gaps[border.seen]
    if min(wide, tall) < shapes.round_box * max(wide, tall) or len(points) < settings.heads.fewest:
        return None
    arc = arc_through(points)
    if arc is None:
        return None
    for _ in range(shapes.rounds):
        if not 0.25 * wide < arc.radius < wide:
            return None
        near = arc.distances(points) <= np.maximum(shapes.outlying_gaps * gaps, shapes.outlying_m)
        if near.mean() < 1 - shapes.contradicted:
            return None
        arc = arc.fitted(points[near], np.ones(int(near.sum())))
    if arc is None:
        return None
    angles = np.linspace(0, 2 * np.pi, CORNERS, endpoint=False)
    u, v = arc.centre
    polygon = Polygon(np.stack([u + arc.radius * np.cos(angles), v + arc.radius * np.sin(angles)], axis=1))
    off = arc.distances(points)
    expected = np.hypot(gaps / np.sqrt(12), settings.noise_m)
    # A square deviates from its circle by a fifth of the radius.
    if float(np.median(off / expected)) > shapes.round_deviation or _iou(polygon, ring) < shapes.alike:
        return None
    signed = np.hypot(*(points[near] - arc.centre).T) - arc.radius
    std = border_deviation(signed, points[near], gaps[near], border.spacing, settings)
    return Outline(CIRCLE, None, polygon, Edges(std, std, std, std), float(np.sqrt(np.mean(off[near] ** 2))))


def _free(border: Border, ring: Polygon, settings: OutlineSettings) -> Outline:
    """Return the outline as it was seen, without the scatter of single points."""
    gap = float(np.median(border.gaps)) if len(border.gaps) else settings.noise_m
    if border.ring.is_empty or _iou(border.ring, ring) < settings.shapes.alike:
        polygon = ring.simplify(gap)
    else:
        polygon = border.ring.simplify(0.5 * gap)
    polygon = max(polygons_of(made_valid(polygon)), key=lambda part: part.area, default=ring)
    left, bottom, right, top = polygon.bounds
    sides = (
        (0, left, (bottom, top)),
        (0, right, (bottom, top)),
        (1, bottom, (left, right)),
        (1, top, (left, right)),
    )
    found = [_deviation_of_free(border, *side, settings) for side in sides]
    return Outline(FREE, None, polygon, Edges(*found), NOTHING)


def _deviation_of_free(
    border: Border, axis: int, position: float, span: tuple[float, float], settings: OutlineSettings
) -> float:
    """Return the standard deviation of an edge of a free outline; nan where only its corners were seen."""
    across, along = border.crossings[:, axis], border.crossings[:, 1 - axis]
    gap = float(np.median(border.gaps)) if len(border.gaps) else settings.noise_m
    reach = settings.edges.corner_gaps * gap
    corner = min(settings.edges.corner_gaps * max(gap, border.spacing), 0.25 * (span[1] - span[0]))
    # The feet of jambs, which end at a sill that was not seen, do not show it.
    near = border.shown & (np.abs(across - position) < reach)
    near &= (along > span[0] + corner) & (along < span[1] - corner)
    if near.sum() < settings.edges.fewest:
        return NOTHING
    away = across[near] - position
    return border_deviation(away, border.crossings[near], border.gaps[near], border.spacing, settings)
