"""The Delaunay triangulation of points in a plane: edges, spacings, areas and circumradii."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import Delaunay, QhullError

from ..kernels import kernel
from ..parallel import apart
from ..progress import Progress

Links = tuple[np.ndarray, np.ndarray]
"""The neighbours of points, in compressed rows: where those of each point begin, and the neighbours."""

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
    def _numbered(self) -> tuple[np.ndarray, np.ndarray]:
        return _number_sides(self.triangles, len(self.points))

    @property
    def edges(self) -> np.ndarray:
        """Each edge once, shape (k, 2), the smaller row first; ordered by these rows."""
        return self._numbered[0]

    @property
    def sides(self) -> np.ndarray:
        """The three sides of each triangle, shape (m, 3), as rows of `edges`."""
        return self._numbered[1]

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
        return _third_shortest(self.edges, self.lengths, len(self.points))

    def sides_of(self, kept: np.ndarray) -> np.ndarray:
        """Return whether each edge, shape (k,), is a side of the `kept` triangles, shape (m,)."""
        chosen = np.zeros(len(self.edges), bool)
        chosen[self.sides[kept]] = True
        return chosen

    def neighbours(self, chosen: np.ndarray) -> Links:
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
        return _in_rows(self.edges[chosen], len(self.points))

    def pieces(self, chosen: np.ndarray) -> np.ndarray:
        """Return the number, from 0 in the order of their first points, of the connected piece of each point.

        Parameters
        ----------
        chosen : ndarray of bool, shape (k,)
            The edges that connect.
        """
        return _connected(self.edges, chosen, len(self.points))


@kernel
def _number_sides(triangles: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the edges of triangles by their ends, and the three of each triangle; `size` points."""
    starts = np.zeros(size + 1, np.int64)
    for row in range(len(triangles)):
        for corner in range(3):
            starts[min(triangles[row, corner], triangles[row, (corner + 1) % 3]) + 1] += 1
    starts = np.cumsum(starts)
    filled = starts[:-1].copy()
    ends, slots = np.empty(3 * len(triangles), np.int64), np.empty(3 * len(triangles), np.int64)
    for row in range(len(triangles)):
        for corner in range(3):
            one, other = triangles[row, corner], triangles[row, (corner + 1) % 3]
            low = min(one, other)
            ends[filled[low]], slots[filled[low]] = max(one, other), 3 * row + corner
            filled[low] += 1
    edges, sides = np.empty((3 * len(triangles), 2), np.int64), np.empty(3 * len(triangles), np.int64)
    count = 0
    for low in range(size):
        first, last = starts[low], starts[low + 1]
        before = -1
        for index in first + np.argsort(ends[first:last]):
            if ends[index] != before:
                before = ends[index]
                edges[count, 0], edges[count, 1] = low, before
                count += 1
            sides[slots[index]] = count - 1
    return edges[:count].copy(), sides.reshape(-1, 3)


@kernel
def _third_shortest(edges: np.ndarray, lengths: np.ndarray, size: int) -> np.ndarray:
    """Return the third shortest length at each of `size` points; inf with fewer edges."""
    least = np.full((size, 3), np.inf)
    for edge in range(len(edges)):
        for end in range(2):
            three, length = least[edges[edge, end]], lengths[edge]
            for rank in range(3):
                if length < three[rank]:
                    length, three[rank] = three[rank], length
    return least[:, 2].copy()


@kernel
def _in_rows(edges: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Return starts and neighbours in compressed rows; those of a point are ordered, because edges are."""
    starts = np.zeros(size + 1, np.int32)
    for row in range(len(edges)):
        for end in range(2):
            starts[edges[row, end] + 1] += 1
    starts = np.cumsum(starts).astype(np.int32)
    filled = starts[:-1].copy()
    neighbours = np.empty(2 * len(edges), np.int32)
    for row in range(len(edges)):
        for end in range(2):
            point = edges[row, end]
            neighbours[filled[point]] = edges[row, 1 - end]
            filled[point] += 1
    return starts, neighbours


@kernel
def _connected(edges: np.ndarray, chosen: np.ndarray, size: int) -> np.ndarray:
    """Return the number of the piece of each of `size` points."""
    roots = np.arange(size)
    for row in range(len(edges)):
        if not chosen[row]:
            continue
        one, other = edges[row, 0], edges[row, 1]
        while roots[one] != one:
            roots[one] = roots[roots[one]]
            one = roots[one]
        while roots[other] != other:
            roots[other] = roots[roots[other]]
            other = roots[other]
        # The first point of a piece is its root.
        roots[max(one, other)] = min(one, other)
    numbers, count = np.empty(size, np.int32), 0
    for point in range(size):
        root = roots[point]
        if root == point:
            numbers[point] = count
            count += 1
        else:
            numbers[point] = numbers[root]
    return numbers


def triangle_areas(corners: np.ndarray) -> np.ndarray:
    """Return the areas of triangles; corners of shape (m, 3, 2)."""
    a, b, c = np.moveaxis(corners, 1, 0)
    (x, y), (u, v) = (b - a).T, (c - a).T
    return 0.5 * np.abs(x * v - y * u)


def triangulate(points: np.ndarray, progress: Progress = Progress()) -> Mesh:
    """Return the Delaunay triangulation of points, shape (n, 2); without triangles if all lie on one line."""
    try:
        if len(points) >= FEWEST:
            # Near the origin, because qhull rounds all to the precision of the largest number.
            found = apart(Delaunay, points - points.mean(axis=0), progress=progress)
            return Mesh(points, found.simplices)
    except QhullError:
        pass
    return Mesh(points, np.empty((0, 3), np.int32))
