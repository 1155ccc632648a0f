"""The moments of the points in the cells of a grid, summed chunk by chunk.

Coordinates are integers of 10 micrometres about the corner of their cell. Their sums are exact, so that
neither the order of the points nor the chunks matter.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from ...clouds.tiles.lattice import LATTICE, to_lattice
from ...geometry.packed_cells import HALF_RANGE, packed, summed, unpacked

PAIRS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
"""The products of coordinates that are summed."""


@dataclass(frozen=True)
class Cells:
    """Cells that hold points, in the order of their numbers.

    Attributes
    ----------
    edge : float
        Metres.
    keys : ndarray of int64, shape (n,)
        Column, row and level of each cell, packed.
    moments : ndarray of float64, shape (n, 10)
        Number of points, sums of their coordinates about the cell's corner and of the products `PAIRS`, in
        steps of the lattice.
    """

    edge: float
    keys: np.ndarray
    moments: np.ndarray

    @property
    def numbers(self) -> np.ndarray:
        """Column, row and level, shape (n, 3)."""
        return unpacked(self.keys)

    @property
    def counts(self) -> np.ndarray:
        """Number of points of each cell."""
        return self.moments[:, 0]

    def centres(self) -> np.ndarray:
        """Return the means of the points, shape (n, 3), metres."""
        steps = self.numbers * float(to_lattice(self.edge)) + self.moments[:, 1:4] / self.counts[:, None]
        return steps * LATTICE

    def covariances(self) -> np.ndarray:
        """Return the covariances of the points, shape (n, 3, 3), square metres."""
        means = self.moments[:, 1:4] / self.counts[:, None]
        result = np.empty((len(self.keys), 3, 3))
        for column, (one, other) in enumerate(PAIRS, start=4):
            value = self.moments[:, column] / self.counts - means[:, one] * means[:, other]
            result[:, one, other] = result[:, other, one] = value
        return result * LATTICE**2

    def doubled(self) -> "Cells":
        """Return cells of twice the edge."""
        parents = self.numbers >> 1
        offset = (self.numbers - 2 * parents) * float(to_lattice(self.edge))
        keys, moments = summed(packed(parents), _about(self.moments, offset))
        return Cells(2 * self.edge, keys, moments)

    def rows(self, wanted: np.ndarray) -> "Cells":
        """Return some of the cells."""
        return Cells(self.edge, self.keys[wanted], self.moments[wanted])

    def neighbours(self, of: "Cells", steps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the rows of the cells that lie `steps` from others, and which of these exist, shape (k,)."""
        wanted = packed(of.numbers + steps)
        rows = np.minimum(np.searchsorted(self.keys, wanted), len(self.keys) - 1)
        return rows, self.keys[rows] == wanted

    def joined(self, others: "Cells", steps: np.ndarray) -> "Cells":
        """Return the cells with the points of others, which lie `steps` from them, shape (n, 3)."""
        offset = steps * float(to_lattice(self.edge))
        return Cells(self.edge, self.keys, self.moments + _about(others.moments, offset))


def _about(moments: np.ndarray, offset: np.ndarray) -> np.ndarray:
    """Return moments about a corner from which the present one lies at `offset`, shape (n, 3)."""
    result, count, sums = moments.copy(), moments[:, 0], moments[:, 1:4]
    result[:, 1:4] += count[:, None] * offset
    for column, (one, other) in enumerate(PAIRS, start=4):
        result[:, column] += offset[:, one] * sums[:, other] + offset[:, other] * sums[:, one]
        result[:, column] += count * offset[:, one] * offset[:, other]
    return result


def cells_of(chunks: Iterable[np.ndarray], edge: float) -> Cells:
    """Return the cells of points.

    Parameters
    ----------
    chunks : iterable of ndarray, shape (n, 3)
        Metres, near the origin.
    edge : float
        Metres.
    """
    keys, moments = np.zeros(0, np.int64), np.zeros((0, 10))
    for xyz in chunks:
        fresh = summed(*_points(xyz, to_lattice(edge)))
        keys, moments = summed(np.r_[keys, fresh[0]], np.concatenate([moments, fresh[1]]))
    return Cells(edge, keys, moments)


def _points(xyz: np.ndarray, edge: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the cell of each point, and its moments."""
    steps = np.rint(xyz / LATTICE)
    numbers = np.floor(steps / edge)
    steps -= numbers * edge
    # Points a million cells away, as of reflections, are on no surface that two scans share.
    near = (np.abs(numbers) < HALF_RANGE).all(axis=1)
    steps = steps[near]
    products = [steps[:, one] * steps[:, other] for one, other in PAIRS]
    return packed(numbers[near]), np.column_stack([np.ones(len(steps)), steps, *products])
