"""Compiled loops over points on the lattice, apart from its step, which alone needs no compiler."""

import numpy as np

from ...kernels import kernel
from .lattice import FINE_STEPS, PER_METRE


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
