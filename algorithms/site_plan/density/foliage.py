"""Foliage told from walls: the points of a wall stand above one another, those of foliage fill the space."""

import numpy as np
from numba import njit

PARTS = 4
"""A pixel is cut into this many parts each way."""

FEWEST = 8
"""Of fewer points in a pixel it cannot be told whether they stand above one another."""


@njit(nogil=True, cache=True)
def scatter(parts, ground, xyz, x0, y0, step, lattice, low, high):
    """Count the points between two heights above the ground in the parts of their pixels.

    A count stops at the largest number that `parts` can hold.
    """
    most = np.iinfo(parts.dtype).max
    for i in range(len(xyz)):
        x, y = xyz[i, 0] + x0, xyz[i, 1] + y0
        height = xyz[i, 2] * lattice - ground[y // step, x // step]
        if low <= height < high:
            row, column = y * PARTS // step, x * PARTS // step
            parts[row, column] += parts[row, column] < most


def spread_of(parts: np.ndarray) -> np.ndarray:
    """Return the share of each pixel over which its points are spread.

    Pairs of points that share a part of the pixel are counted against those that would if the points
    were strewn over all of it: foliage gives 1 whatever its density, a thin sheet the share that it
    crosses, about a quarter.

    Parameters
    ----------
    parts : ndarray of uint8, shape (rows * PARTS, columns * PARTS)
        Number of points in each part.

    Returns
    -------
    ndarray of float32, shape (rows, columns)
        From 0 to 1; nan where `FEWEST` points are not reached.
    """
    return _spread_of(parts, FEWEST)


@njit(nogil=True, cache=True)
def _spread_of(parts, fewest):
    rows, columns = parts.shape[0] // PARTS, parts.shape[1] // PARTS
    spread = np.full((rows, columns), np.nan, np.float32)
    for row in range(rows):
        for column in range(columns):
            points, pairs = 0, 0
            for r in range(row * PARTS, (row + 1) * PARTS):
                for c in range(column * PARTS, (column + 1) * PARTS):
                    count = np.int64(parts[r, c])
                    points += count
                    pairs += count * (count - 1)
            if points >= fewest:
                strewn = points * (points - 1) / PARTS**2
                spread[row, column] = strewn / max(pairs, strewn)
    return spread
