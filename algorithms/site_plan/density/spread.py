"""The spread of points within a pixel: those of a wall stand above one another, foliage fills the pixel."""

import numpy as np

from ...kernels import kernel
from .settings import SpreadSettings


@kernel
def count_in_parts(
    counts: np.ndarray,
    ground: np.ndarray,
    xyz: np.ndarray,
    x0: int,
    y0: int,
    step: int,
    lattice: float,
    low: float,
    high: float,
    parts: int,
) -> None:
    """Count the points between two heights above the ground in the parts of their pixels.

    A count stops at the largest number that `counts` can hold.
    """
    most = np.iinfo(counts.dtype).max
    for i in range(len(xyz)):
        x, y = xyz[i, 0] + x0, xyz[i, 1] + y0
        height = xyz[i, 2] * lattice - ground[y // step, x // step]
        if low <= height < high:
            row, column = y * parts // step, x * parts // step
            counts[row, column] += counts[row, column] < most


def spread_of(counts: np.ndarray, settings: SpreadSettings = SpreadSettings()) -> np.ndarray:
    """Return the share of each pixel over which its points are spread.

    Pairs of points that share a part of the pixel are counted against those that would if the points
    were strewn over all of it: foliage gives 1 whatever its density, a thin sheet the share that it
    crosses, about a quarter.

    Parameters
    ----------
    counts : ndarray of uint8, shape (rows * parts, columns * parts)
        Number of points in each part of the pixels.
    settings : SpreadSettings

    Returns
    -------
    ndarray of float32, shape (rows, columns)
        From 0 to 1; nan where the points are too few.
    """
    return _spread_of(counts, settings.parts, settings.fewest_points)


@kernel
def _spread_of(counts: np.ndarray, parts: int, fewest: int) -> np.ndarray:
    rows, columns = counts.shape[0] // parts, counts.shape[1] // parts
    spread = np.full((rows, columns), np.nan, np.float32)
    for row in range(rows):
        for column in range(columns):
            points, pairs = 0, 0
            for r in range(row * parts, (row + 1) * parts):
                for c in range(column * parts, (column + 1) * parts):
                    count = np.int64(counts[r, c])
                    points += count
                    pairs += count * (count - 1)
            if points >= fewest:
                strewn = points * (points - 1) / parts**2
                spread[row, column] = strewn / max(pairs, strewn)
    return spread
