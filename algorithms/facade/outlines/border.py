"""The border between a detail and what surrounds it, as the mean of its two sides."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np
from scipy.ndimage import binary_dilation
from scipy.spatial import cKDTree
from shapely.geometry import Polygon

from ...geometry.polygons import faces_of
from ...geometry.triangulation import Mesh, triangulate
from .settings import BorderSettings

FRAME = 32
"""Corners of the polygon around all points, which makes a triangulation reach beyond every border."""


@dataclass(frozen=True)
class Lost:
    """Points that the side in front lacks because their laser spots are mixed.

    Attributes
    ----------
    points : ndarray of float64, shape (l, 2)
    area : float
        That each of them would represent (m2).
    """

    points: np.ndarray
    area: float

    def widths(self, asked: np.ndarray, radius: float) -> np.ndarray:
        """Return the width of the strip that they would cover near the points asked for, shape (k, 2)."""
        if not len(self.points):
            return np.zeros(len(asked))
        counts = cKDTree(self.points).query_ball_point(asked, radius, return_length=True)
        return counts * self.area / (2 * radius)


NOTHING_LOST = Lost(np.empty((0, 2)), 0.0)


@dataclass(frozen=True)
class Border:
    """A border as the points show it.

    Attributes
    ----------
    ring : Polygon
        The closed border.
    crossings : ndarray of float64, shape (k, 2)
        Where it crosses the edges between points of the two sides.
    gaps : ndarray of float64, shape (k,)
        Widths within which the border may lie at the crossings (m); the outermost points of a surface end
        up to one spacing before its edge.
    seen : ndarray of bool, shape (k,)
        Which crossings have points of the outer side near them; elsewhere something hides the border.
    jambs : ndarray of float64, shape (j, 3)
        Points of surfaces at right angles to the plane, which show the border directly.
    spacing : float
        Of the points along the border (m).
    bare : ndarray of bool, shape (k,), or None
        At which crossings nothing is seen behind the wall, so that a shadow may end there; None if at none.
    """

    ring: Polygon
    crossings: np.ndarray
    gaps: np.ndarray
    seen: np.ndarray
    jambs: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))
    spacing: float = 0.0
    bare: Optional[np.ndarray] = None

    @property
    def shown(self) -> np.ndarray:
        """Which crossings were seen, with something behind the wall beside them."""
        return self.seen if self.bare is None else self.seen & ~self.bare


def trace_border(
    inside: np.ndarray,
    outside: np.ndarray,
    filler: np.ndarray,
    step: float,
    band: float,
    lost: Lost = NOTHING_LOST,
    settings: BorderSettings = BorderSettings(),
    reach: float = np.inf,
) -> Border:
    """Trace the border between two sets of points in a plane.

    The last point of either side ends, on average, half a spacing before the border, so the middle
    between the two is unbiased. Where one side lies before the other it may hide a strip of it, so the
    border is half a spacing beyond the side in front.

    Parameters
    ----------
    inside, outside : ndarray of float64, shape (n, 3), (m, 3)
        u, v, w; w is minus infinity at positions that stand in for points far behind.
    filler : ndarray of float64, shape (f, 2)
        Positions within the detail that stand in for points far behind, where no pulse came back.
    step : float
        Points that differ by less in w are side by side (m).
    band : float
        Points further from the other side than about twice this do not matter (m).
    lost : Lost
        Points that the side in front lacks at its edge.
    settings : BorderSettings
    reach : float
        Where the sides are farther apart, the border was not seen (m).

    Returns
    -------
    Border
        Its ring is empty if the two sides do not meet.
    """
    inside, outside = _beside(inside, outside, filler, band)
    frame = _surrounding(np.concatenate([inside[:, :2], outside[:, :2], filler]))
    points = np.concatenate([outside[:, :2], frame, inside[:, :2], filler])
    behind = [np.full(len(added), -np.inf) for added in (frame, filler)]
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
        return Border(Polygon(), np.empty((0, 2)), np.empty(0), np.empty(0, bool))
    shares, gaps = _shares(mesh, within, w, (outer, inner), step, lost, settings)
    crossings = np.full((len(mesh.edges), 2), np.nan)
    crossings[mixed] = points[outer] + shares[:, None] * (points[inner] - points[outer])
    apart = np.hypot(*(points[outer] - points[inner]).T)
    spacings = mesh.spacings[np.isfinite(w)]
    spacing = float(np.median(spacings[np.isfinite(spacings)]))
    return Border(_ring(mesh, mixed, crossings), crossings[mixed], gaps, apart <= reach, spacing=spacing)


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
    """Return positions all around the points, so that every detail has something outside."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    angles = np.linspace(0, 2 * np.pi, FRAME, endpoint=False)
    return middle + (2 * half + half.max()) * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _shares(
    mesh: Mesh,
    within: np.ndarray,
    w: np.ndarray,
    ends: tuple[np.ndarray, np.ndarray],
    step: float,
    lost: Lost,
    settings: BorderSettings,
) -> tuple[np.ndarray, np.ndarray]:
    """Return at which share of its length from outer to inner point each edge crosses, and the gaps."""
    points, (outer, inner) = mesh.points, ends
    # Compared without subtraction: the difference of two infinities is not a number.
    behind, before = w[inner] < w[outer] - step, w[inner] > w[outer] + step
    shares, gaps = np.full(len(outer), 0.5), np.empty(len(outer))
    for front, near, far, side in ((~before, outer, inner, ~within), (before, inner, outer, within)):
        if not front.any():
            continue
        widths, steps = _widths(
            points, np.flatnonzero(side & np.isfinite(w)), near, far, settings.local_edges
        )
        hidden = front & (behind | before)
        missing = np.minimum(lost.widths(points[near], settings.lost_radius_m), settings.beam_m)
        own = np.minimum((0.5 * steps + missing) / widths, 0.5)
        shares[hidden] = (own if near is outer else 1 - own)[hidden]
        gaps[front] = np.where(hidden, steps, widths)[front]
    return shares, gaps


def _widths(
    points: np.ndarray, side: np.ndarray, near: np.ndarray, far: np.ndarray, local: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the width of the gap at each edge, and the spacing across the border of its near side.

    Without its outermost layer a side is further away: by the distance of one layer to the next, in the
    lattice of one scan as well as in the random order of several.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    side : ndarray of int, shape (s,)
        The points of the side.
    near, far : ndarray of int, shape (k,)
        The ends of the edges, on the side and beyond the gap.
    local : int
        Edges over which the spacing is averaged.
    """
    widths, _ = cKDTree(points[side]).query(points[far])
    widths = np.maximum(widths, 1e-12)
    rest = np.setdiff1d(side, near)
    if not len(rest):
        return widths, widths.copy()
    further, _ = cKDTree(points[rest]).query(points[far])
    _, around = cKDTree(points[far]).query(points[far], k=min(local, len(far)))
    return widths, np.mean((further - widths)[around.reshape(len(far), -1)], axis=1)


def _ring(mesh: Mesh, mixed: np.ndarray, crossings: np.ndarray) -> Polygon:
    """Join the crossings of each triangle to lines, and these to the largest ring."""
    crossed = mixed[mesh.sides]
    sides = mesh.sides[crossed.sum(axis=1) == 2]
    pairs = sides[mixed[sides]].reshape(-1, 2)
    rings = [Polygon(face.exterior) for face in faces_of(crossings[pairs])]
    return max(rings, key=lambda ring: ring.area, default=Polygon())
