"""Where a region of one colour can begin: seeds and their surfaces, the most uniform first."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...kernels import kernel
from .settings import SeedSettings


class Lattice(NamedTuple):
    """Points sorted into square cells, so that the neighbours of a point are found quickly.

    Attributes
    ----------
    corner : ndarray of float64, shape (2,)
    size : float
        Of a cell (m).
    columns, rows : int
    starts : ndarray of int64, shape (columns * rows + 1,)
    order : ndarray of int64, shape (n,)
        The points of cell i are those from starts[i] to starts[i + 1].
    """

    corner: np.ndarray
    size: float
    columns: int
    rows: int
    starts: np.ndarray
    order: np.ndarray


def sort_into_cells(points: np.ndarray, size: float) -> Lattice:
    """Return points, shape (n, 2), sorted into cells of `size` (m)."""
    corner = points.min(axis=0)
    columns, rows = ((points - corner) // size).astype(np.int64).T
    width, height = int(columns.max()) + 1, int(rows.max()) + 1
    cells = rows * width + columns
    order = np.argsort(cells, kind="stable")
    starts = np.searchsorted(cells[order], np.arange(width * height + 1))
    return Lattice(corner, size, width, height, starts, order)


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

    def automatic_variance(self, settings: SeedSettings = SeedSettings()) -> float:
        """Return Vr: the paper's, or twice the measured colour noise, if larger."""
        smallest = self.variances[self.radii == self.radii.min(initial=np.inf)]
        noise = float(np.median(smallest)) if len(smallest) else 0.0
        return max(settings.variance, settings.noise_factor * noise)

    def accepted(self, colour: float, variance: float) -> "Seeds":
        """Return the seeds within tr and Vr, those with the largest and most uniform surfaces first.

        The paper takes seeds at random. In this order every run gives the same result.
        """
        chosen = np.flatnonzero((self.shifts < colour) & (self.variances < variance))
        order = chosen[np.lexsort((self.rows[chosen], self.variances[chosen], -self.radii[chosen]))]
        return Seeds(self.rows[order], self.radii[order], self.shifts[order], self.variances[order])


def find_seeds(
    points: np.ndarray, rgb: np.ndarray, radius: float, settings: SeedSettings = SeedSettings()
) -> Seeds:
    """Return the candidates for seeds, with all radii.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    rgb : ndarray of float32, shape (n, 3)
        0..255.
    radius : float
        td, the largest radius of a seed surface (m).
    settings : SeedSettings
    """
    lattice = sort_into_cells(points, radius / settings.cells_across)
    rows = _nearest_to_centres(points, lattice)
    rows = rows[rows >= 0]
    radii = [radius / 2**halving for halving in range(settings.halvings)]
    found = [
        (
            rows,
            np.full(len(rows), reach),
            *_surfaces(points, rgb, rows, reach, lattice, settings.fewest_points),
        )
        for reach in radii
    ]
    return Seeds(*(np.concatenate(parts) for parts in zip(*found)))


def _surfaces(
    points: np.ndarray, rgb: np.ndarray, rows: np.ndarray, radius: float, lattice: Lattice, fewest: int
) -> tuple[np.ndarray, np.ndarray]:
    free = np.zeros(len(points), np.int32)
    shifts, variances = np.empty(len(rows)), np.empty(len(rows))
    _measure(points, rgb, rows, radius, lattice, free, fewest, shifts, variances)
    return shifts, variances


@kernel
def _nearest_to_centres(points: np.ndarray, lattice: Lattice) -> np.ndarray:
    """Return the point nearest to the centre of each cell; -1 in empty cells."""
    corner, size, columns, rows, starts, order = lattice
    nearest = np.full(columns * rows, -1, np.int64)
    for row in range(rows):
        for column in range(columns):
            x, y = corner[0] + (column + 0.5) * size, corner[1] + (row + 0.5) * size
            least = np.inf
            cell = row * columns + column
            for index in range(starts[cell], starts[cell + 1]):
                point = order[index]
                distance = (points[point, 0] - x) ** 2 + (points[point, 1] - y) ** 2
                if distance < least:
                    least = distance
                    nearest[cell] = point
    return nearest


@kernel
def gather(
    points: np.ndarray,
    seed: int,
    radius: float,
    lattice: Lattice,
    labels: np.ndarray,
    members: np.ndarray,
) -> tuple[int, int]:
    """Write the points around a seed without a label to `members`; return their number, and that of all."""
    corner, size, columns, rows, starts, order = lattice
    count, every = 0, 0
    x, y = points[seed, 0], points[seed, 1]
    left = max(int((x - radius - corner[0]) // size), 0)
    right = min(int((x + radius - corner[0]) // size), columns - 1)
    low = max(int((y - radius - corner[1]) // size), 0)
    high = min(int((y + radius - corner[1]) // size), rows - 1)
    for row in range(low, high + 1):
        for index in range(starts[row * columns + left], starts[row * columns + right + 1]):
            point = order[index]
            if (points[point, 0] - x) ** 2 + (points[point, 1] - y) ** 2 <= radius * radius:
                every += 1
                if labels[point] == 0:
                    members[count] = point
                    count += 1
    return count, every


@kernel
def mean_and_variance(rgb: np.ndarray, members: np.ndarray, count: int, mean: np.ndarray) -> float:
    """Write the mean colour to `mean` and return the sum of the variances of the three colours."""
    total = 0.0
    for channel in range(3):
        sum_, squares = 0.0, 0.0
        for index in range(count):
            value = float(rgb[members[index], channel])
            sum_ += value
            squares += value * value
        mean[channel] = sum_ / count
        total += squares / count - mean[channel] ** 2
    return total


@kernel
def distance_in_colour(rgb: np.ndarray, point: int, mean: np.ndarray) -> float:
    """Return the Euclidean distance of the colour of a point to a mean."""
    total = 0.0
    for channel in range(3):
        total += (rgb[point, channel] - mean[channel]) ** 2
    return np.sqrt(total)


@kernel
def _measure(
    points: np.ndarray,
    rgb: np.ndarray,
    seeds: np.ndarray,
    radius: float,
    lattice: Lattice,
    labels: np.ndarray,
    fewest: int,
    shifts: np.ndarray,
    variances: np.ndarray,
) -> None:
    """Write the shift and the variance of each seed surface; infinity where it has too few points."""
    members, mean = np.empty(len(points), np.int64), np.empty(3)
    for index in range(len(seeds)):
        seed = seeds[index]
        count, _ = gather(points, seed, radius, lattice, labels, members)
        if count < fewest:
            shifts[index], variances[index] = np.inf, np.inf
            continue
        variances[index] = mean_and_variance(rgb, members, count, mean)
        shifts[index] = distance_in_colour(rgb, seed, mean)
