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

PER_METRE, FINE_STEPS = round(1 / FINE), round(LATTICE / FINE)
"""Fine integers in a metre, and in a step of the lattice."""


def to_lattice(metres: float) -> int:
    """Return a length in steps of the lattice."""
    return round(metres / LATTICE)


@kernel
def on_lattice(metres: float, origin: int) -> int:
    """Return the step of the lattice that is nearest to a coordinate, metres about an origin of whole metres.

    It is rounded by way of finer integers: a tie must not depend on the origin.
    """
    fine = np.int64(np.rint(metres * PER_METRE)) + origin * PER_METRE
    return (fine + FINE_STEPS // 2) // FINE_STEPS


@kernel
def limits_of(xyz: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the smallest and the largest x, y, z of points, shape (n, 3)."""
    low, high = xyz[0].astype(np.int64), xyz[0].astype(np.int64)
    for i in range(len(xyz)):
        for axis in range(3):
            low[axis] = min(low[axis], xyz[i, axis])
            high[axis] = max(high[axis], xyz[i, axis])
    return low, high
