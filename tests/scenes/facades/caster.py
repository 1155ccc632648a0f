"""Rays from a scanner, and the objects that they meet: planar panels and spheres of leaves."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numba import njit
from shapely.geometry import Polygon

LEAF = -2
NOTHING = -1
CELLS = 48
"""Of the slopes of rays, in each direction."""

SLACK = 1e-6
"""Of the slopes of rays, far beyond rounding."""


@dataclass(frozen=True)
class Panel:
    """A planar polygon.

    Attributes
    ----------
    origin : ndarray, shape (3,)
        Of the polygon's coordinates, in u, v, w of the facade.
    axes : ndarray, shape (2, 3)
        Their directions, of length 1 and at right angles.
    outline : Polygon
    colour : tuple of 3 float
        0..255 in full light.
    reflectance : float
        For the laser, 0..1.
    returns : float
        Share of rays that return; the others pass through, as through glass.
    """

    origin: np.ndarray
    axes: np.ndarray
    outline: Polygon
    colour: tuple[float, float, float]
    reflectance: float
    returns: float = 1.0

    @cached_property
    def normal(self) -> np.ndarray:
        return np.cross(*self.axes)


@dataclass(frozen=True)
class Leaves:
    """A sphere through which rays pass until they meet a leaf.

    Attributes
    ----------
    centre : tuple of 3 float
    radius : float
    density : float
        Leaves that a ray meets per metre.
    """

    centre: tuple[float, float, float]
    radius: float
    density: float


@dataclass(frozen=True)
class Things:
    """Panels and leaves as arrays."""

    frames: np.ndarray
    boxes: np.ndarray
    starts: np.ndarray
    edges: np.ndarray
    returns: np.ndarray
    leaves: np.ndarray


def flatten(panels: tuple, leaves: tuple) -> Things:
    """Return panels and leaves as the arrays that `cast` takes."""
    rings = [_edges(panel.outline) for panel in panels]
    starts = np.cumsum([0] + [len(ring) for ring in rings])
    frames = np.array([[panel.origin, *panel.axes, panel.normal] for panel in panels])
    return Things(
        frames,
        np.array([panel.outline.bounds for panel in panels]),
        starts,
        np.concatenate(rings),
        np.array([panel.returns for panel in panels]),
        np.array([[*item.centre, item.radius, item.density] for item in leaves]).reshape(-1, 5),
    )


def _edges(outline: Polygon) -> np.ndarray:
    corners = [np.array(ring.coords) for ring in (outline.exterior, *outline.interiors)]
    return np.concatenate([np.hstack([ring[:-1], ring[1:]]) for ring in corners])


def cast(origin: np.ndarray, directions: np.ndarray, things: Things, seed: int) -> tuple:
    """Return the length of each ray, inf if it meets nothing, and the panel that it meets.

    Parameters
    ----------
    origin : ndarray, shape (3,)
    directions : ndarray, shape (n, 3)
        Of length 1.
    things : Things
    seed : int
    """
    windows = _windows(origin, things)
    corner, size, heads, listed = _cells(windows)
    return _cast(
        origin, directions, things.frames, things.boxes, windows, corner, size, heads, listed, things.starts,
        things.edges, things.returns, things.leaves, seed,
    )  # fmt: skip


def _windows(origin: np.ndarray, things: Things) -> np.ndarray:
    """Return the limits of u / -w and v / -w of rays that can meet each panel, shape (n, 4).

    They spare most rays the intersection with most panels. A panel that reaches beside the origin or behind
    it has no limits.
    """
    low, high = things.boxes[:, :2], things.boxes[:, 2:]
    ends = [(low, low), (low, high), (high, low), (high, high)]
    windows = np.tile([-np.inf, -np.inf, np.inf, np.inf], (len(low), 1))
    corners = np.array([
        things.frames[:, 0] + a[:, :1] * things.frames[:, 1] + b[:, 1:] * things.frames[:, 2] - origin
        for a, b in ends
    ])  # fmt: skip
    ahead = np.all(corners[..., 2] < -0.01, axis=0)
    slopes = corners[:, ahead, :2] / -corners[:, ahead, 2:]
    windows[ahead] = np.hstack([slopes.min(axis=0) - SLACK, slopes.max(axis=0) + SLACK])
    return windows


def _cells(windows: np.ndarray) -> tuple:
    """Return the panels that the rays of each cell of slopes can meet, in their order.

    Returns
    -------
    corner, size : ndarray, shape (2,)
        Of the cells.
    heads : ndarray, shape (CELLS**2 + 2,)
        Where the list of each cell starts; the last one is of rays that lead away.
    listed : ndarray
        The lists, one after the other.
    """
    limited = windows[np.isfinite(windows).all(axis=1)]
    corner, end = np.zeros(2), np.ones(2)
    if len(limited):
        corner, end = limited[:, :2].min(axis=0), limited[:, 2:].max(axis=0)
    size = (end - corner) / CELLS
    low = np.clip(np.floor((windows[:, :2] - corner) / size), 0, CELLS - 1)
    high = np.clip(np.floor((windows[:, 2:] - corner) / size), 0, CELLS - 1)
    cells = np.arange(CELLS)[:, None]
    across, up = ((cells >= low[:, axis]) & (cells <= high[:, axis]) for axis in (0, 1))
    cell, panel = np.nonzero((across[:, None] & up[None, :]).reshape(CELLS**2, -1))
    heads = np.searchsorted(cell, np.arange(CELLS**2 + 1))
    listed = np.concatenate([panel, np.arange(len(windows))])
    return corner, size, np.append(heads, len(listed)), listed


@njit(cache=True, nogil=True)
def _cast(
    origin,
    directions,
    frames,
    boxes,
    windows,
    corner,
    size,
    heads,
    listed,
    starts,
    edges,
    returns,
    leaves,
    seed,
):
    np.random.seed(seed)
    reach, met = np.full(len(directions), np.inf), np.full(len(directions), NOTHING)
    for ray in range(len(directions)):
        d = directions[ray]
        # Comparisons with nan are false, so rays that lead away are tried with every panel.
        rightward, upward, cell = np.nan, np.nan, CELLS * CELLS
        if d[2] < 0:
            rightward, upward = d[0] / -d[2], d[1] / -d[2]
            across = min(max((rightward - corner[0]) / size[0], 0.0), CELLS - 1.0)
            up = min(max((upward - corner[1]) / size[1], 0.0), CELLS - 1.0)
            cell = int(across) * CELLS + int(up)
        for panel in listed[heads[cell] : heads[cell + 1]]:
            window = windows[panel]
            if rightward < window[0] or upward < window[1] or rightward > window[2] or upward > window[3]:
                continue
            place, first, second, normal = frames[panel]
            slope = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2]
            if abs(slope) < 1e-12:
                continue
            t = 0.0
            for axis in range(3):
                t += (place[axis] - origin[axis]) * normal[axis]
            t /= slope
            if t <= 1e-6 or t >= reach[ray]:
                continue
            a, b = 0.0, 0.0
            for axis in range(3):
                offset = origin[axis] + t * d[axis] - place[axis]
                a += offset * first[axis]
                b += offset * second[axis]
            box = boxes[panel]
            if a < box[0] or b < box[1] or a > box[2] or b > box[3]:
                continue
            if not _holds(edges[starts[panel] : starts[panel + 1]], a, b):
                continue
            if returns[panel] < 1 and np.random.random() > returns[panel]:
                continue
            reach[ray], met[ray] = t, panel
        for item in range(len(leaves)):
            t = _leaf(origin, d, leaves[item])
            if t < reach[ray]:
                reach[ray], met[ray] = t, LEAF
    return reach, met


@njit(cache=True, nogil=True)
def _holds(edges, a, b):
    """Whether a polygon contains a point, by the number of its edges to one side."""
    inside = False
    for edge in range(len(edges)):
        x1, y1, x2, y2 = edges[edge]
        if (y1 > b) != (y2 > b) and a < x1 + (b - y1) / (y2 - y1) * (x2 - x1):
            inside = not inside
    return inside


@njit(cache=True, nogil=True)
def _leaf(origin, d, sphere):
    """Return the length of a ray up to a leaf; inf if it passes between them."""
    along, squared = 0.0, 0.0
    for axis in range(3):
        offset = sphere[axis] - origin[axis]
        along += offset * d[axis]
        squared += offset * offset
    half = sphere[3] ** 2 - (squared - along * along)
    if half <= 0 or along <= 0:
        return np.inf
    half = np.sqrt(half)
    t = along - half + np.random.exponential(1.0 / sphere[4])
    return t if t < along + half else np.inf
