"""Edges that were not seen, completed by the openings of the same row: facades repeat their windows."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Optional

import numpy as np
from shapely.geometry import Polygon

from .elevation import ARCH, EDGES, RECTANGLE, TRAPEZIUM
from .outlines.details import TracedDetail
from .outlines.regular_outlines import Outline
from .settings import CompletionSettings

Pair = tuple[TracedDetail, Outline]

LEFT, RIGHT, BOTTOM, TOP = EDGES
OPPOSITE = {LEFT: RIGHT, RIGHT: LEFT, BOTTOM: TOP, TOP: BOTTOM}
SIDES = {LEFT: 0, BOTTOM: 1, RIGHT: 2, TOP: 3}
"""Positions of the edges in the bounds of an outline."""


def complete_edges(pairs: Sequence[Pair], settings: CompletionSettings = CompletionSettings()) -> list[Pair]:
    """Return the details, with edges that were not seen where the others of their row have theirs.

    An opening of a row has the sill and the head of its neighbours, and their width. An edge is completed if
    enough neighbours agree, and if its seen edges agree with theirs. It has no deviation, because it was not
    measured.

    Parameters
    ----------
    pairs : sequence of (TracedDetail, Outline)
    settings : CompletionSettings
    """
    return [(item, _completed(item, outline, pairs, settings)) for item, outline in pairs]


def _completed(
    item: TracedDetail, outline: Outline, pairs: Sequence[Pair], settings: CompletionSettings
) -> Outline:
    if item.opening is None or outline.shape not in (RECTANGLE, TRAPEZIUM, ARCH):
        return outline
    others = [
        other.polygon.bounds
        for near, other in pairs
        if near is not item
        and near.opening is not None
        and (near.opening.use, near.opening.layer) == (item.opening.use, item.opening.layer)
        and other.shape == outline.shape
        and all(np.isfinite(std) for std in vars(other.edges).values())
    ]
    bounds = np.array(outline.polygon.bounds)
    found = outline
    for edge in (BOTTOM, LEFT, RIGHT, TOP):
        movable = edge == BOTTOM or outline.shape == RECTANGLE
        if _is_seen(outline, edge) or edge in item.opening.open_sides or not movable:
            continue
        position = _position(edge, bounds, outline, others, settings)
        if position is not None and abs(position - bounds[SIDES[edge]]) <= settings.farthest_m:
            polygon = _moved(found.polygon, edge, position)
            found = replace(found, polygon=polygon, completed=(*found.completed, edge))
    return found


def _is_seen(outline: Outline, edge: str) -> bool:
    return bool(np.isfinite(getattr(outline.edges, edge)))


def _position(
    edge: str,
    bounds: np.ndarray,
    outline: Outline,
    others: Sequence[tuple[float, float, float, float]],
    settings: CompletionSettings,
) -> Optional[float]:
    """Return where the openings of the row have an edge; None if too few are like this one."""
    own = SIDES[edge]
    level = edge in (BOTTOM, TOP)
    positions = []
    for other in others:
        if not other[1] < 0.5 * (bounds[1] + bounds[3]) < other[3]:
            continue
        # Levels are compared as they are, jambs by the width between them.
        shift = 0.0 if level else bounds[SIDES[OPPOSITE[edge]]] - other[SIDES[OPPOSITE[edge]]]
        compared = [side for side in (BOTTOM, TOP) if side != edge and _is_seen(outline, side)]
        agree = [abs(other[SIDES[side]] - bounds[SIDES[side]]) <= settings.alike_m for side in compared]
        wide = abs((other[2] - other[0]) - (bounds[2] - bounds[0])) <= settings.alike_m
        if level and _is_seen(outline, LEFT) and _is_seen(outline, RIGHT):
            agree.append(wide)
        seen = level or _is_seen(outline, OPPOSITE[edge])
        if seen and agree and all(agree):
            positions.append((abs(other[0] - bounds[0]), other[own] + shift))
    # A row may run on over a neighbour, whose windows differ.
    nearest = [position for _, position in sorted(positions)[: settings.fewest]]
    if len(nearest) < settings.fewest or np.ptp(nearest) > settings.alike_m:
        return None
    return float(np.median(nearest))


def _moved(polygon: Polygon, edge: str, position: float) -> Polygon:
    """Return an outline with the corners on an edge at another position."""
    corners = np.array(polygon.exterior.coords)[:, :2]
    axis, old = SIDES[edge] % 2, polygon.bounds[SIDES[edge]]
    corners[np.abs(corners[:, axis] - old) < 1e-9, axis] = position
    return Polygon(corners)
