"""The Delaunay triangulation of points in a plane: edges, spacings, areas and circumradii."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import Delaunay, QhullError

FEWEST = 4
"""Points that can be triangulated; fewer, or points on one line, have no triangles."""


@dataclass(frozen=True)
class Mesh:
    """A triangulation.

    Attributes
    ----------
    points : ndarray of float64, shape (n, 2)
    triangles : ndarray of int32, shape (m, 3)
        Rows of `points`, anticlockwise.
    """

    points: np.ndarray
    triangles: np.ndarray

    @cached_property
    def edges(self) -> np.ndarray:
        """Each edge once, shape (k, 2), the smaller row first."""
        return np.stack([self._keys // len(self.points), self._keys % len(self.points)], axis=1)

    @cached_property
    def sides(self) -> np.ndarray:
        """The three sides of each triangle, shape (m, 3), as rows of `edges`."""
        return np.searchsorted(self._keys, self._side_keys)

    @cached_property
    def _keys(self) -> np.ndarray:
        return np.unique(self._side_keys)

    @cached_property
    def _side_keys(self) -> np.ndarray:
        ends = np.sort(self.triangles[:, [[0, 1], [1, 2], [2, 0]]].astype(np.int64), axis=2)
        return ends[:, :, 0] * len(self.points) + ends[:, :, 1]

    @cached_property
    def lengths(self) -> np.ndarray:
        """Lengths of `edges`, shape (k,)."""
        first, second = self.points[self.edges[:, 0]], self.points[self.edges[:, 1]]
        return np.hypot(*(second - first).T)

    @cached_property
    def areas(self) -> np.ndarray:
        """Areas of the triangles, shape (m,)."""
        return triangle_areas(self.points[self.triangles])

    @cached_property
    def circumradii(self) -> np.ndarray:
        """Radii of the circles through the corners, shape (m,)."""
        a, b, c = (self.points[self.triangles[:, corner]] for corner in range(3))
        product = np.hypot(*(b - a).T) * np.hypot(*(c - b).T) * np.hypot(*(a - c).T)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.areas > 0, product / (4 * self.areas), np.inf)

    @cached_property
    def spacings(self) -> np.ndarray:
        """The third shortest edge at each point, shape (n,); inf at points with fewer edges.

        In a lattice that is the step across its lines, and at a border no edge leads across a gap.
        """
        ends = np.concatenate([self.edges[:, 0], self.edges[:, 1]])
        lengths = np.tile(self.lengths, 2)
        order = np.lexsort((lengths, ends))
        counts = np.bincount(ends, minlength=len(self.points))
        enough = counts >= 3
        spacings = np.full(len(self.points), np.inf)
        spacings[enough] = lengths[order][(np.cumsum(counts) - counts + 2)[enough]]
        return spacings

    def sides_of(self, kept: np.ndarray) -> np.ndarray:
        """Return whether each edge, shape (k,), is a side of the `kept` triangles, shape (m,)."""
        chosen = np.zeros(len(self.edges), bool)
        chosen[self.sides[kept]] = True
        return chosen

    def neighbours(self, chosen: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the neighbours of all points along the `chosen` edges, in compressed rows.

        Parameters
        ----------
        chosen : ndarray of bool, shape (k,)

        Returns
        -------
        starts : ndarray, shape (n + 1,)
        neighbours : ndarray
            Those of point i stand from starts[i] to starts[i + 1].
        """
        first, second = self.edges[chosen].T
        size = len(self.points)
        ones = np.ones(2 * len(first), np.int8)
        rows, columns = np.concatenate([first, second]), np.concatenate([second, first])
        matrix = coo_matrix((ones, (rows, columns)), shape=(size, size)).tocsr()
        return matrix.indptr, matrix.indices


def triangle_areas(corners: np.ndarray) -> np.ndarray:
    """Return the areas of triangles; corners of shape (m, 3, 2)."""
    a, b, c = np.moveaxis(corners, 1, 0)
    (x, y), (u, v) = (b - a).T, (c - a).T
    return 0.5 * np.abs(x * v - y * u)


def triangulate(points: np.ndarray) -> Mesh:
    """Return the Delaunay triangulation of points, shape (n, 2); without triangles if all lie on one line."""
    try:
        if len(points) >= FEWEST:
            # Near the origin, because qhull rounds all to the precision of the largest number.
            found = Delaunay(points - points.mean(axis=0)).simplices
            return Mesh(points, found)
    except QhullError:
        pass
    return Mesh(points, np.empty((0, 3), np.int32))
