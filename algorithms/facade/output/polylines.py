"""Outlines as polylines of lines and arcs with few vertices, as drawings have them."""

from collections.abc import Iterator
from typing import Optional

import numpy as np
from shapely.geometry import LinearRing

from .settings import DrawingSettings


def polyline(ring: LinearRing, spacing: float, settings: DrawingSettings = DrawingSettings()) -> np.ndarray:
    """Return the vertices of a closed polyline and the bulge of the edge after each.

    Vertices on a line are left out, and runs of vertices on a circle become arcs. A ring of many corners, as
    of a broken edge, is simplified within the scatter that the spacing of the points gives it.

    Parameters
    ----------
    ring : LinearRing
    spacing : float
        Of the points (m).
    settings : DrawingSettings

    Returns
    -------
    ndarray of float64, shape (n, 3)
        x, y and bulge: the tangent of a quarter of the angle of the arc, positive if it turns left; 0 for
        a line.
    """
    exact = _polyline(ring.simplify(settings.exact_m / 100, preserve_topology=False), settings)
    if len(exact) <= settings.most_vertices:
        return exact
    rough = ring.simplify(settings.ragged_spacings * spacing)
    return np.column_stack([np.array(rough.coords)[:-1, :2], np.zeros(len(rough.coords) - 1)])


def _polyline(ring: LinearRing, settings: DrawingSettings) -> np.ndarray:
    corners = np.array(ring.coords)[:-1, :2]
    corners = np.roll(corners, -_sharpest(corners), axis=0)
    return np.array(list(_edges(np.vstack([corners, corners[:1]]), settings)))


def _sharpest(corners: np.ndarray) -> int:
    """Return the vertex with the sharpest turn, where no arc can continue."""
    return int(np.argmax(np.abs(_turns(corners))))


def _turns(corners: np.ndarray) -> np.ndarray:
    """Return by how much a ring turns left at each vertex (radians)."""
    coming, going = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0) - corners
    cross = coming[:, 0] * going[:, 1] - coming[:, 1] * going[:, 0]
    return np.arctan2(cross, np.sum(coming * going, axis=1))


def _edges(path: np.ndarray, settings: DrawingSettings) -> Iterator[tuple[float, float, float]]:
    start = 0
    while start < len(path) - 1:
        stop, bulge = _longest_arc(path, start, settings)
        yield float(path[start, 0]), float(path[start, 1]), bulge
        start = stop


def _longest_arc(path: np.ndarray, start: int, settings: DrawingSettings) -> tuple[int, float]:
    """Return where the longest arc from a vertex ends, and its bulge; the next vertex and 0 for a line."""
    best = start + 1, 0.0
    for stop in range(start + settings.fewest_edges, len(path)):
        bulge = _bulge(path[start : stop + 1], settings)
        if bulge is not None:
            best = stop, bulge
        elif stop - best[0] > settings.patience:
            # The first edges of an arc can be as straight as a line.
            break
    return best


def _bulge(points: np.ndarray, settings: DrawingSettings) -> Optional[float]:
    """Return the bulge of the arc through points; None if they are not on an arc of half a circle or less."""
    first, middle, last = points[0], points[len(points) // 2], points[-1]
    length = float(np.linalg.norm(last - first))
    if length < settings.exact_m:
        return None
    along = (last - first) / length
    left = np.array([-along[1], along[0]])
    across, up = (middle - first) @ along - 0.5 * length, float((middle - first) @ left)
    if abs(up) < settings.exact_m:
        return None
    # The circle through three of the points; its centre is on the axis of the chord.
    height = (across**2 + up**2 - 0.25 * length**2) / (2 * up)
    radius = float(np.hypot(0.5 * length, height))
    away = np.linalg.norm(points - first - 0.5 * length * along - height * left, axis=1) - radius
    bulge = float(-2 * (height + np.sign(up) * radius) / length)
    edges = np.linalg.norm(np.diff(points, axis=0), axis=1)
    # Long edges are lines whose ends happen to lie on the circle.
    longest = 2 * np.sqrt(2 * radius * settings.sagitta_m)
    if np.abs(away).max() > settings.exact_m or edges.max() > min(
        longest, settings.uneven * np.median(edges)
    ):
        return None
    return bulge if abs(bulge) <= 1 + settings.exact_m else None
