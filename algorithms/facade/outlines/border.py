"""The border between a detail and what surrounds it, as the mean of its two sides."""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import binary_dilation
from scipy.spatial import cKDTree
from shapely.geometry import MultiLineString, Polygon
from shapely.ops import polygonize

from ...geometry.triangulation import Mesh, triangulate

LOCAL = 60
"""Edges whose gaps are averaged."""

ROUND = 0.1
"""Radius around a place within which lost points are counted (m)."""

FRAME = 32
"""Places around everything."""


@dataclass(frozen=True)
class Lost:
    """Points of the side in front that do not lie on it, for their laser spots are mixed.

    Attributes
    ----------
    places : ndarray of float64, shape (l, 2)
    area : float
        That each of them would stand for (m2).
    """

    places: np.ndarray
    area: float

    def widths(self, asked: np.ndarray) -> np.ndarray:
        """Return how wide a strip of the side they would cover at places, shape (k, 2)."""
        if not len(self.places):
            return np.zeros(len(asked))
        counts = cKDTree(self.places).query_ball_point(asked, ROUND, return_length=True)
        return counts * self.area / (2 * ROUND)


NOTHING_LOST = Lost(np.empty((0, 2)), 0.0)


@dataclass(frozen=True)
class Border:
    """Where a border was seen.

    Attributes
    ----------
    ring : Polygon
        The closed border.
    places : ndarray of float64, shape (k, 2)
        Of its crossings of the edges between the two sides.
    gaps : ndarray of float64, shape (k,)
        Between which the border may lie at each of them (m); the outermost points of a surface end up to
        one spacing before its edge.
    """

    ring: Polygon
    places: np.ndarray
    gaps: np.ndarray


def trace_border(
    inside: np.ndarray,
    outside: np.ndarray,
    filler: np.ndarray,
    step: float,
    band: float,
    lost: Lost = NOTHING_LOST,
) -> Border:
    """Trace the border between two sets of points in a plane.

    The last point of either side ends, on average, half a spacing before the border, so the middle
    between the two is unbiased. Where one side lies before the other it may hide a strip of it, so the
    border is half a spacing beyond the side in front.

    Parameters
    ----------
    inside, outside : ndarray of float64, shape (n, 3), (m, 3)
        u, v, w; w is minus infinity at places that stand in for points far behind.
    filler : ndarray of float64, shape (f, 2)
        Places within the detail that stand in for points far behind, where none came back.
    step : float
        What differs by less in w is side by side (m).
    band : float
        Points further from the other side than this, and than its double, do not matter (m).
    lost : Lost
        Points that the side in front lacks at its edge.

    Returns
    -------
    Border
        With an empty ring if there is none.
    """
    inside, outside = _beside(inside, outside, filler, band)
    frame = _surrounding(np.concatenate([inside[:, :2], outside[:, :2], filler]))
    points = np.concatenate([outside[:, :2], frame, inside[:, :2], filler])
    behind = [np.full(len(places), -np.inf) for places in (frame, filler)]
    w = np.concatenate([outside[:, 2], behind[0], inside[:, 2], behind[1]])
    within = np.arange(len(points)) >= len(outside) + len(frame)
    mesh = triangulate(points)
    first, second = mesh.edges.T
    mixed = within[first] != within[second]
    outer, inner = (
        np.where(within[first], second, first)[mixed],
        np.where(within[first], first, second)[mixed],
    )
    known = np.isfinite(w[outer]) | np.isfinite(w[inner])
    mixed[mixed], outer, inner = known, outer[known], inner[known]
    if not len(outer):
        return Border(Polygon(), np.empty((0, 2)), np.empty(0))
    shares, gaps = _shares(mesh, within, w, (outer, inner), step, lost)
    crossings = np.full((len(mesh.edges), 2), np.nan)
    crossings[mixed] = points[outer] + shares[:, None] * (points[inner] - points[outer])
    return Border(_ring(mesh, mixed, crossings), crossings[mixed], gaps)


def _beside(
    inside: np.ndarray, outside: np.ndarray, filler: np.ndarray, band: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the points of each side that are near the other."""
    sides = [np.concatenate([inside[:, :2], filler]), outside[:, :2]]
    if not all(map(len, sides)):
        return inside, outside
    corner = np.min([side.min(axis=0) for side in sides], axis=0) - 2 * band
    cells = [((side - corner) // band).astype(np.int64) for side in sides]
    shape = tuple(np.max([side.max(axis=0) for side in cells], axis=0) + 2)
    near = []
    for own, other in ((0, 1), (1, 0)):
        held = np.zeros(shape, bool)
        held[tuple(cells[other].T)] = True
        near.append(binary_dilation(held, np.ones((3, 3)))[tuple(cells[own].T)])
    return inside[near[0][: len(inside)]], outside[near[1]]


def _surrounding(points: np.ndarray) -> np.ndarray:
    """Return places all around the points, so that every detail has something outside."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    turns = np.linspace(0, 2 * np.pi, FRAME, endpoint=False)
    return middle + (2 * half + half.max()) * np.stack([np.cos(turns), np.sin(turns)], axis=1)


def _shares(
    mesh: Mesh, within: np.ndarray, w: np.ndarray, ends: tuple, step: float, lost: Lost
) -> tuple[np.ndarray, np.ndarray]:
    """Return where on its way from outer to inner point each edge crosses the border, and the gaps."""
    points, (outer, inner) = mesh.points, ends
    # Not the difference, which is not a number where both are infinitely far.
    behind, before = w[inner] < w[outer] - step, w[inner] > w[outer] + step
    shares, gaps = np.full(len(outer), 0.5), np.empty(len(outer))
    for front, near, far, side in ((~before, outer, inner, ~within), (before, inner, outer, within)):
        if not front.any():
            continue
        widths, steps = _widths(points, np.flatnonzero(side & np.isfinite(w)), near, far)
        hidden = front & (behind | before)
        own = np.minimum((0.5 * steps + lost.widths(points[near])) / widths, 0.5)
        shares[hidden] = (own if near is outer else 1 - own)[hidden]
        gaps[front] = np.where(hidden, steps, widths)[front]
    return shares, gaps


def _widths(
    points: np.ndarray, side: np.ndarray, near: np.ndarray, far: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the width of the gap at each edge, and the spacing across the border of the side it ends at.

    Taking the outermost layer off tells how far a layer is from the next, in the lattice of one scan
    as well as in the random order of several.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    side : ndarray of int, shape (s,)
        The points of the side.
    near, far : ndarray of int, shape (k,)
        The ends of the edges, on the side and beyond the gap.
    """
    widths, _ = cKDTree(points[side]).query(points[far])
    widths = np.maximum(widths, 1e-12)
    rest = np.setdiff1d(side, near)
    if not len(rest):
        return widths, widths.copy()
    further, _ = cKDTree(points[rest]).query(points[far])
    _, around = cKDTree(points[far]).query(points[far], k=min(LOCAL, len(far)))
    return widths, np.mean((further - widths)[around.reshape(len(far), -1)], axis=1)


def _ring(mesh: Mesh, mixed: np.ndarray, crossings: np.ndarray) -> Polygon:
    """Join the crossings of each triangle to lines, and these to the largest ring."""
    crossed = mixed[mesh.sides]
    sides = mesh.sides[crossed.sum(axis=1) == 2]
    pairs = sides[mixed[sides]].reshape(-1, 2)
    faces = list(polygonize(MultiLineString(list(crossings[pairs]))))
    rings = [Polygon(face.exterior) for face in faces]
    return max(rings, key=lambda ring: ring.area, default=Polygon())
