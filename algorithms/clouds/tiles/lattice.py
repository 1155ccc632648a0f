"""The lattice of integers on which tiles hold coordinates.

Its step is 10 micrometres, and it is fixed to the coordinate system's origin. A tile's border, a pixel's
edge and a distance are then the same however the cloud is cut into files or chunks, and at any size of the
coordinates.
"""

import numpy as np

from ...kernels import kernel

LATTICE = 1e-5
"""Step of the lattice, in metres: a tenth of the finest step that scanners' files use."""

FINE = 1e-7
"""Step of the integers that coordinates are rounded from, in metres; finer than files are written."""


def to_lattice(metres: float) -> int:
    """Return a length in steps of the lattice."""
    return round(metres / LATTICE)


def tiles_of(xyz: np.ndarray, origin: np.ndarray, edge: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the tile (column, row) of each point, and its lattice coordinates.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
        Metres, relative to `origin`.
    origin : ndarray of int64, shape (3,)
        Metres.
    edge : int
        Of a tile, in lattice steps.

    Returns
    -------
    tile : ndarray of int64, shape (n, 2)
    steps : ndarray of int32, shape (n, 3)
        x, y from the lower left corner of the tile, z absolute.
    """
    return _tiles_of(np.ascontiguousarray(xyz), origin, edge, round(1 / FINE), round(LATTICE / FINE))


@kernel
def _tiles_of(
    xyz: np.ndarray, origin: np.ndarray, edge: int, per_metre: int, steps: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the tile of each point, and its lattice coordinates about the tile's corner."""
    key = np.empty((len(xyz), 2), np.int64)
    steps_from = np.empty((len(xyz), 3), np.int32)
    for i in range(len(xyz)):
        for axis in range(2):
            value = _rounded(xyz[i, axis], origin[axis], per_metre, steps)
            key[i, axis] = value // edge
            steps_from[i, axis] = value - key[i, axis] * edge
        steps_from[i, 2] = _rounded(xyz[i, 2], origin[2], per_metre, steps)
    return key, steps_from


@kernel
def _rounded(value: float, origin: int, per_metre: int, steps: int) -> int:
    """Round to the lattice by way of finer integers: a tie must not depend on the origin."""
    fine = np.int64(np.rint(value * per_metre)) + origin * per_metre
    return (fine + steps // 2) // steps
