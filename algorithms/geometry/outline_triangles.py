"""Triangles that fill the walls and the space around them, from which axes and rooms are read.

The corners are sampled from the outlines, so densely that every piece of an outline is the side of a
triangle. The triangles are Delaunay's: a side across a wall or a passage is nearly the shortest way across,
and its middle lies on the centreline.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import Delaunay
from shapely.affinity import translate
from shapely.geometry import LinearRing, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from ..parallel import apart
from ..progress import Progress
from .linked_parts import label_linked
from .settings import OutlineMeshSettings
from .triangulation import triangle_areas

SNAP = 1e-4
"""Corners nearer than this to each other, in metres, are one."""


@dataclass(frozen=True)
class OutlineMesh:
    """Triangles inside the walls and around them.

    Attributes
    ----------
    origin : ndarray, shape (2,)
        World coordinates of the point (0, 0).
    points : ndarray, shape (n, 2)
        Corners, relative to the origin.
    triangles : ndarray of int, shape (m, 3)
        Corners, anticlockwise.
    neighbours : ndarray of int, shape (m, 3)
        Triangle across the side opposite to each corner; -1 beyond the margin.
    outline : ndarray of bool, shape (m, 3)
        Whether that side is a piece of an outline.
    wall : ndarray of bool, shape (m,)
        Whether the triangle lies inside a wall.
    """

    origin: np.ndarray
    points: np.ndarray
    triangles: np.ndarray
    neighbours: np.ndarray
    outline: np.ndarray
    wall: np.ndarray

    def sides(self, inside: np.ndarray) -> "Sides":
        """Return the sides that two triangles share and no outline runs along, if both are `inside`."""
        first, corner = np.nonzero((self.neighbours > np.arange(len(self.wall))[:, None]) & ~self.outline)
        second = self.neighbours[first, corner]
        both = inside[first] & inside[second]
        first, second, corner = first[both], second[both], corner[both]
        ends = np.column_stack([self.triangles[first, (corner + k) % 3] for k in (1, 2)])
        return Sides(first, second, ends, self.lengths(ends))

    def outline_pieces(self) -> np.ndarray:
        """Return the corners at the ends of all pieces of outlines, shape (n, 2)."""
        return _all_sides(self.triangles)[(self.outline & self.wall[:, None]).ravel()]

    def lengths(self, ends: np.ndarray) -> np.ndarray:
        """Return the lengths of sides between corners, shape (n, 2), in metres."""
        return np.linalg.norm(np.diff(self.points[ends], axis=1)[:, 0], axis=1)

    def areas(self) -> np.ndarray:
        """Return the areas of all triangles in m2."""
        return triangle_areas(self.points[self.triangles])

    def widths(self) -> np.ndarray:
        """Return the diameter of the largest circle, clear of outlines, with its centre in each triangle."""
        corners = self.points[self.triangles]
        sides = np.sort(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2), axis=1)
        a, b, c = sides.T
        around = a * b * c / np.maximum(2 * self.areas(), 1e-12)
        # The centre of a blunt triangle's circle lies in a neighbour; its own is about its longest side.
        return np.where(c**2 < a**2 + b**2, around, c)


@dataclass(frozen=True)
class Sides:
    """Sides between triangles.

    Attributes
    ----------
    first, second : ndarray of int, shape (n,)
        The triangles.
    ends : ndarray of int, shape (n, 2)
        The corners.
    lengths : ndarray, shape (n,)
        Metres.
    """

    first: np.ndarray
    second: np.ndarray
    ends: np.ndarray
    lengths: np.ndarray


def triangulate_outlines(
    outlines: Iterable[Polygon],
    settings: OutlineMeshSettings = OutlineMeshSettings(),
    margin: float = 0.0,
    progress: Progress = Progress(),
) -> OutlineMesh:
    """Triangulate walls and the space around them.

    Parameters
    ----------
    outlines : iterable of Polygon
        Walls, in world coordinates; they may overlap and touch. At least one.
    settings : OutlineMeshSettings
    margin : float
        How far the space reaches beyond them at least, in metres.
    progress : Progress
        Asked whether to stop.
    """
    margin = max(margin, settings.margin_m)
    outlines = list(outlines)
    # Large coordinates would cost the triangles their digits.
    origin = np.round(outlines[0].bounds[:2])
    united = unary_union([translate(outline, *-origin).buffer(0) for outline in outlines])
    rings = [
        _sampled(ring, settings.spacing_m)
        for part in _polygons(united)
        for ring in (part.exterior, *part.interiors)
    ]
    frame = _sampled(united.envelope.buffer(margin, join_style=2).exterior, margin)
    points, pieces = _indexed(rings, frame)
    for _ in range(settings.rounds):
        delaunay = apart(Delaunay, points, progress=progress)
        missing = ~np.isin(_names(pieces), _names(_all_sides(delaunay.simplices)))
        missing &= np.linalg.norm(np.diff(points[pieces], axis=1)[:, 0], axis=1) >= settings.shortest_m
        if not missing.any():
            break
        points, pieces = _halved(points, pieces, missing)
    return _mesh(origin, points, delaunay, pieces)


def _polygons(geometry: BaseGeometry) -> list[Polygon]:
    return [orient(part) for part in getattr(geometry, "geoms", [geometry]) if part.area > 0]


def _sampled(ring: LinearRing, spacing: float) -> np.ndarray:
    """Return the corners of a ring and points between them, without the last one."""
    corners = np.round(np.asarray(ring.coords)[:, :2] / SNAP) * SNAP
    steps = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    counts = np.maximum(np.ceil(steps / spacing - 1e-6).astype(int), 1)
    start = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(len(start)) - np.repeat(np.cumsum(counts) - counts, counts)) / counts[start]
    return corners[start] + share[:, None] * np.diff(corners, axis=0)[start]


def _indexed(rings: Sequence[np.ndarray], frame: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the distinct points of all rings, and the pieces of the rings as pairs of them."""
    lengths = [len(ring) for ring in rings]
    starts = np.cumsum([0, *lengths[:-1]])
    first = np.arange(sum(lengths))
    second = np.concatenate([start + np.roll(np.arange(n), -1) for start, n in zip(starts, lengths)])
    keys = np.round(np.concatenate([*rings, frame]) / (SNAP / 100)).astype(np.int64)
    unique, number = np.unique(keys, axis=0, return_inverse=True)
    pieces = number.ravel()[np.column_stack([first, second])]
    return unique * (SNAP / 100), pieces[pieces[:, 0] != pieces[:, 1]]


def _halved(points: np.ndarray, pieces: np.ndarray, which: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    middles = points[pieces[which]].mean(axis=1)
    new = len(points) + np.arange(len(middles))
    halves = np.column_stack([pieces[which, 0], new, new, pieces[which, 1]]).reshape(-1, 2)
    return np.concatenate([points, middles]), np.concatenate([pieces[~which], halves])


def _all_sides(triangles: np.ndarray) -> np.ndarray:
    """Return the sides opposite to the corners of each triangle, in its sense; shape (3 m, 2)."""
    return np.stack([triangles[:, [1, 2]], triangles[:, [2, 0]], triangles[:, [0, 1]]], axis=1).reshape(-1, 2)


def _names(sides: np.ndarray) -> np.ndarray:
    """Return a number for each side, whichever way it runs."""
    return _directed(np.sort(sides, axis=1))


def _directed(sides: np.ndarray) -> np.ndarray:
    return sides[:, 0].astype(np.int64) << 32 | sides[:, 1]


def _mesh(origin: np.ndarray, points: np.ndarray, delaunay: Delaunay, pieces: np.ndarray) -> OutlineMesh:
    """Return the mesh; inside walls are the triangles left of an outline, and all up to the next one."""
    triangles, neighbours = delaunay.simplices, delaunay.neighbors
    sides = _all_sides(triangles)
    on_left = np.isin(_directed(sides), _directed(pieces)).reshape(-1, 3)
    on_right = np.isin(_directed(sides), _directed(pieces[:, ::-1])).reshape(-1, 3)
    outline = on_left | on_right
    triangle, corner = np.nonzero(~outline & (neighbours >= 0))
    part = label_linked(triangle, neighbours[triangle, corner], len(triangles))
    votes = on_left.sum(axis=1) - on_right.sum(axis=1)
    wall = np.bincount(part, weights=votes)[part] > 0
    return OutlineMesh(origin, points, triangles, neighbours, outline, wall)
