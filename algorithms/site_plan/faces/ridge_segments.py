"""Cutting a row of ridge points into straight and curved pieces.

The cut is the cheapest of all (dynamic programming): a point costs the square of its distance from its piece
in standard deviations, and so does a direction; a piece costs what its parameters would save on noise, and a
point that fits nowhere may be left out at a price. The directions keep apart the two ways along a thin wall.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from ...geometry.robust import sigma_of_residuals

STRAIGHT_COST, CURVED_COST, OMITTED_COST = 10.0, 25.0, 6.0
"""In squares of standard deviations: about 3 sigma for each point that a piece needs at least."""

STRAIGHT_LEAST, CURVED_LEAST = 3, 8
"""Fewest points of a piece."""

LONGEST = 500
"""Most points of a piece that are looked at, to bound the time; equal neighbours are joined afterwards."""

RADII = (0.12, 50.0)
"""Least and largest radius of a curved piece, metres."""

SIGMA = (0.010, 0.03)
"""Least and largest standard deviation of a ridge point, metres: of a plastered wall and of rubble."""


SIGMA_DIRECTION = 0.3
"""Standard deviation of a ridge point's direction, radians."""


class Piece(NamedTuple):
    """Points `first`..`last` (inclusive) of a row that lie on a straight line or on an arc."""

    first: int
    last: int
    curved: bool


def cut_into_pieces(points: np.ndarray, directions: np.ndarray, sigma: float) -> list:
    """Return the pieces of a row of points, shape (n, 2) (m), in order; some points may be in none.

    Parameters
    ----------
    points, directions : ndarray of float64, shape (n, 2)
        Directions are unit vectors.
    sigma : float
        Standard deviation of a point (m).
    """
    if len(points) < STRAIGHT_LEAST:
        return []
    local = points - points.mean(axis=0)
    came, kind = _cheapest(_moments(local, directions), sigma, RADII[0], RADII[1])
    pieces, end = [], len(points)
    while end > 0:
        start = came[end]
        if kind[end] > 0:
            pieces.append(Piece(int(start), int(end) - 1, kind[end] == 2))
        end = start
    return pieces[::-1]


def scatter_of(points: np.ndarray, span: int = 5) -> float:
    """Return the standard deviation of the points of a row about chords of `span` points to either side."""
    if len(points) <= 2 * span:
        return SIGMA[0]
    middle = (points[: -2 * span] + points[2 * span :]) / 2
    chord = points[2 * span :] - points[: -2 * span]
    offset = points[span:-span] - middle
    length = np.hypot(*chord.T)
    across = np.abs(chord[:, 0] * offset[:, 1] - chord[:, 1] * offset[:, 0]) / np.maximum(length, 1e-9)
    return float(np.clip(sigma_of_residuals(across) / np.sqrt(1.5), *SIGMA))


def _moments(points: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Return running sums of the products that line and circle need, shape (n + 1, 13)."""
    (x, y), (u, v) = points.T, directions.T
    z = x * x + y * y
    one = np.ones(len(points))
    products = [one, x, y, x * x, x * y, y * y, x * z, y * z, z, z * z, u, v, x * v - y * u]
    return np.vstack([np.zeros(13), np.cumsum(np.column_stack(products), axis=0)])


@njit(nogil=True, cache=True)
def _cheapest(sums, sigma, least_radius, largest_radius):
    """Return where the last piece before each end starts, and what it is: 0 omitted, 1 straight, 2 curved."""
    n = len(sums) - 1
    cost = np.full(n + 1, np.inf)
    came, kind = np.zeros(n + 1, np.int64), np.zeros(n + 1, np.int64)
    cost[0] = 0.0
    for end in range(1, n + 1):
        cost[end], came[end] = cost[end - 1] + OMITTED_COST, end - 1
        for start in range(end - STRAIGHT_LEAST, max(end - LONGEST, 0) - 1, -1):
            if cost[start] + STRAIGHT_COST >= cost[end]:
                continue
            m = sums[end] - sums[start]
            price = cost[start] + STRAIGHT_COST + _line_misfit(m, sigma)
            if price < cost[end]:
                cost[end], came[end], kind[end] = price, start, 1
            if end - start >= CURVED_LEAST and cost[start] + CURVED_COST < cost[end]:
                price = cost[start] + CURVED_COST + _circle_misfit(m, sigma, least_radius, largest_radius)
                if price < cost[end]:
                    cost[end], came[end], kind[end] = price, start, 2
    return came, kind


@njit(nogil=True, cache=True)
def _line_misfit(m, sigma):
    """Return what points and directions cost on the best line."""
    n = m[0]
    xx, xy, yy = m[3] - m[1] * m[1] / n, m[4] - m[1] * m[2] / n, m[5] - m[2] * m[2] / n
    squares = max((xx + yy) / 2 - np.sqrt(((xx - yy) / 2) ** 2 + xy * xy), 0.0)
    return squares / sigma**2 + 2 * (n - np.hypot(m[10], m[11])) / SIGMA_DIRECTION**2


@njit(nogil=True, cache=True)
def _circle_misfit(m, sigma, least_radius, largest_radius):
    """Return what points and directions cost on the best circle (Kasa 1976); infinite if there is none."""
    n = m[0]
    mx, my, mz = m[1] / n, m[2] / n, m[8] / n
    xx, xy, yy = m[3] - n * mx * mx, m[4] - n * mx * my, m[5] - n * my * my
    xz, yz, zz = m[6] - n * mx * mz, m[7] - n * my * mz, m[9] - n * mz * mz
    determinant = xx * yy - xy * xy
    if determinant <= 1e-9:
        return np.inf
    a, b = (xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant
    square = mz - a * mx - b * my + (a * a + b * b) / 4
    if not least_radius**2 <= square <= largest_radius**2:
        return np.inf
    squares = max(zz - a * xz - b * yz, 0.0) / (4 * square)
    around = abs(m[12] - a / 2 * m[11] + b / 2 * m[10]) / np.sqrt(square)
    return squares / sigma**2 + 2 * max(n - around, 0.0) / SIGMA_DIRECTION**2
