"""Where a region of one colour can begin: seeds and their surfaces, ordered by how even they are."""

from dataclasses import dataclass

import numpy as np
from numba import njit

CELLS_ACROSS = 4
"""Cells of the grid of seeds across the seed radius."""

HALVINGS = 3
"""Radii that are tried from td down, each half of the one before: the surface adapts to small details."""

FEWEST = 10
"""Points of a surface; a variance of fewer says little."""

PAPER_VARIANCE = 200.0
"""Vr of the paper, for colours with less noise than that."""

NOISE_FACTOR = 2.0
"""The automatic Vr in units of the median variance of the seed surfaces."""


@dataclass(frozen=True)
class Lattice:
    """Points sorted into square cells, so that those near a place are found at once.

    Attributes
    ----------
    corner : ndarray of float64, shape (2,)
    size : float
        Of a cell (m).
    shape : tuple of int
        Columns and rows.
    starts : ndarray of int64, shape (columns * rows + 1,)
    order : ndarray of int64, shape (n,)
        The points of cell i stand from starts[i] to starts[i + 1].
    """

    corner: np.ndarray
    size: float
    shape: tuple[int, int]
    starts: np.ndarray
    order: np.ndarray


def sort_into_cells(points: np.ndarray, size: float) -> Lattice:
    """Sort points, shape (n, 2), into cells of `size` (m)."""
    corner = points.min(axis=0)
    columns, rows = ((points - corner) // size).astype(np.int64).T
    shape = int(columns.max()) + 1, int(rows.max()) + 1
    cells = rows * shape[0] + columns
    order = np.argsort(cells, kind="stable")
    starts = np.searchsorted(cells[order], np.arange(shape[0] * shape[1] + 1))
    return Lattice(corner, size, shape, starts, order)


@dataclass(frozen=True)
class Seeds:
    """Candidates, one for each cell of a grid and each radius.

    Attributes
    ----------
    rows : ndarray of int64, shape (s,)
        Of the points.
    radii : ndarray of float64, shape (s,)
        Of their seed surfaces, at most td (m).
    shifts : ndarray of float64, shape (s,)
        From the colour of the seed to the mean of its surface (Simco1).
    variances : ndarray of float64, shape (s,)
        Sum of the variances of the three colours of the surface (var, equation 3).
    """

    rows: np.ndarray
    radii: np.ndarray
    shifts: np.ndarray
    variances: np.ndarray

    def automatic_variance(self) -> float:
        """Return Vr: the paper's, or more where the noise of the colours is greater."""
        smallest = self.variances[self.radii == self.radii.min(initial=np.inf)]
        noise = float(np.median(smallest)) if len(smallest) else 0.0
        return max(PAPER_VARIANCE, NOISE_FACTOR * noise)

    def accepted(self, colour: float, variance: float) -> "Seeds":
        """Return those within the thresholds tr and Vr, the largest and most even surfaces first.

        The paper takes seeds at random; in this order the result is the same in every run.
        """
        chosen = np.flatnonzero((self.shifts < colour) & (self.variances < variance))
        order = chosen[np.lexsort((self.rows[chosen], self.variances[chosen], -self.radii[chosen]))]
        return Seeds(self.rows[order], self.radii[order], self.shifts[order], self.variances[order])


def find_seeds(points: np.ndarray, rgb: np.ndarray, radius: float) -> Seeds:
    """Return the candidates for seeds.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    rgb : ndarray of float32, shape (n, 3)
        0..255.
    radius : float
        td, the largest radius of a seed surface (m).
    """
    lattice = sort_into_cells(points, radius / CELLS_ACROSS)
    rows = _nearest_to_centres(
        points, lattice.corner, lattice.size, *lattice.shape, lattice.starts, lattice.order
    )
    rows = rows[rows >= 0]
    radii = [radius / 2**halving for halving in range(HALVINGS)]
    found = [
        (rows, np.full(len(rows), reach), *_surfaces(points, rgb, rows, reach, lattice)) for reach in radii
    ]
    return Seeds(*(np.concatenate(parts) for parts in zip(*found)))


def _surfaces(
    points: np.ndarray, rgb: np.ndarray, rows: np.ndarray, radius: float, lattice: Lattice
) -> tuple[np.ndarray, np.ndarray]:
    free = np.zeros(len(points), np.int32)
    shifts, variances = np.empty(len(rows)), np.empty(len(rows))
    _measure(
        points, rgb, rows, radius,
        lattice.corner, lattice.size, *lattice.shape, lattice.starts, lattice.order,
        free, shifts, variances,
    )  # fmt: skip
    return shifts, variances


@njit(cache=True, nogil=True)
def _nearest_to_centres(points, corner, size, columns, rows, starts, order):
    """Return the point nearest to the centre of each cell; -1 in empty cells."""
    nearest = np.full(columns * rows, -1, np.int64)
    for row in range(rows):
        for column in range(columns):
            x, y = corner[0] + (column + 0.5) * size, corner[1] + (row + 0.5) * size
            least = np.inf
            cell = row * columns + column
            for place in range(starts[cell], starts[cell + 1]):
                point = order[place]
                distance = (points[point, 0] - x) ** 2 + (points[point, 1] - y) ** 2
                if distance < least:
                    least = distance
                    nearest[cell] = point
    return nearest


@njit(cache=True, nogil=True)
def gather(points, seed, radius, corner, size, columns, rows, starts, order, labels, members):
    """Write the points around a seed that have no label yet to `members`; return how many, and of all."""
    count, every = 0, 0
    x, y = points[seed, 0], points[seed, 1]
    left = max(int((x - radius - corner[0]) // size), 0)
    right = min(int((x + radius - corner[0]) // size), columns - 1)
    low = max(int((y - radius - corner[1]) // size), 0)
    high = min(int((y + radius - corner[1]) // size), rows - 1)
    for row in range(low, high + 1):
        for place in range(starts[row * columns + left], starts[row * columns + right + 1]):
            point = order[place]
            if (points[point, 0] - x) ** 2 + (points[point, 1] - y) ** 2 <= radius * radius:
                every += 1
                if labels[point] == 0:
                    members[count] = point
                    count += 1
    return count, every


@njit(cache=True, nogil=True)
def mean_and_variance(rgb, members, count, mean):
    """Write the mean colour to `mean` and return the sum of the variances of the three colours."""
    total = 0.0
    for channel in range(3):
        sum_, squares = 0.0, 0.0
        for place in range(count):
            value = float(rgb[members[place], channel])
            sum_ += value
            squares += value * value
        mean[channel] = sum_ / count
        total += squares / count - mean[channel] ** 2
    return total


@njit(cache=True, nogil=True)
def distance_in_colour(rgb, point, mean):
    """Return the Euclidean distance of the colour of a point to a mean."""
    total = 0.0
    for channel in range(3):
        total += (rgb[point, channel] - mean[channel]) ** 2
    return np.sqrt(total)


@njit(cache=True, nogil=True)
def _measure(
    points, rgb, seeds, radius, corner, size, columns, rows, starts, order, labels, shifts, variances
):
    members, mean = np.empty(len(points), np.int64), np.empty(3)
    for place in range(len(seeds)):
        seed = seeds[place]
        count, _ = gather(points, seed, radius, corner, size, columns, rows, starts, order, labels, members)
        if count < FEWEST:
            shifts[place], variances[place] = np.inf, np.inf
            continue
        variances[place] = mean_and_variance(rgb, members, count, mean)
        shifts[place] = distance_in_colour(rgb, seed, mean)
