"""Straight and curved segments of a row of ridge points.

The cut is the cheapest of all (dynamic programming). A point costs the square of its distance from its
segment in standard deviations, and so does a direction. A segment costs what its parameters would save on
noise. A point that fits nowhere may be left out at a price. The directions separate the two ways along a thin
wall.
"""

from collections import namedtuple
from dataclasses import astuple, fields
from typing import Any, Callable, NamedTuple

import numpy as np

from ...geometry.robust import sigma_of_residuals
from ...kernels import kernel
from .settings import SegmentSettings

_make: Callable[..., Any] = namedtuple
_Numbers = _make("_Numbers", [item.name for item in fields(SegmentSettings)])
"""The settings as the kernels take them."""


class Segment(NamedTuple):
    """Points `first`..`last` (inclusive) of a row that lie on a straight line or on an arc."""

    first: int
    last: int
    curved: bool


def cut_into_segments(
    points: np.ndarray, directions: np.ndarray, sigma: float, settings: SegmentSettings = SegmentSettings()
) -> list[Segment]:
    """Return the segments of a row of points, shape (n, 2) (m), in order; some points may be in none.

    Parameters
    ----------
    points, directions : ndarray of float64, shape (n, 2)
        Directions are unit vectors.
    sigma : float
        Standard deviation of a point (m).
    settings : SegmentSettings
    """
    if len(points) < settings.straight_points:
        return []
    local = points - points.mean(axis=0)
    came, kind = _cheapest(_moments(local, directions), sigma, _Numbers(*astuple(settings)))
    segments, end = [], len(points)
    while end > 0:
        start = came[end]
        if kind[end] > 0:
            segments.append(Segment(int(start), int(end) - 1, kind[end] == 2))
        end = start
    return segments[::-1]


def scatter_of(points: np.ndarray, span: int = 5, settings: SegmentSettings = SegmentSettings()) -> float:
    """Return the standard deviation of the points of a row about chords of `span` points to either side."""
    if len(points) <= 2 * span:
        return settings.least_sigma_m
    middle = (points[: -2 * span] + points[2 * span :]) / 2
    chord = points[2 * span :] - points[: -2 * span]
    offset = points[span:-span] - middle
    length = np.hypot(*chord.T)
    across = np.abs(chord[:, 0] * offset[:, 1] - chord[:, 1] * offset[:, 0]) / np.maximum(length, 1e-9)
    sigma = sigma_of_residuals(across) / np.sqrt(1.5)
    return float(np.clip(sigma, settings.least_sigma_m, settings.largest_sigma_m))


def _moments(points: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Return running sums of the products that line and circle need, shape (n + 1, 13)."""
    (x, y), (u, v) = points.T, directions.T
    z = x * x + y * y
    one = np.ones(len(points))
    products = [one, x, y, x * x, x * y, y * y, x * z, y * z, z, z * z, u, v, x * v - y * u]
    return np.vstack([np.zeros(13), np.cumsum(np.column_stack(products), axis=0)])


@kernel
def _cheapest(sums: np.ndarray, sigma: float, numbers: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return where the last segment before each end starts, and its kind: 0 omitted, 1 straight, 2 curved."""
    n = len(sums) - 1
    cost = np.full(n + 1, np.inf)
    came, kind = np.zeros(n + 1, np.int64), np.zeros(n + 1, np.int64)
    cost[0] = 0.0
    for end in range(1, n + 1):
        cost[end], came[end] = cost[end - 1] + numbers.omitted_cost, end - 1
        for start in range(end - numbers.straight_points, max(end - numbers.longest_points, 0) - 1, -1):
            if cost[start] + numbers.straight_cost >= cost[end]:
                continue
            m = sums[end] - sums[start]
            price = cost[start] + numbers.straight_cost + _line_misfit(m, sigma, numbers)
            if price < cost[end]:
                cost[end], came[end], kind[end] = price, start, 1
            if end - start >= numbers.curved_points and cost[start] + numbers.curved_cost < cost[end]:
                price = cost[start] + numbers.curved_cost + _circle_misfit(m, sigma, numbers)
                if price < cost[end]:
                    cost[end], came[end], kind[end] = price, start, 2
    return came, kind


@kernel
def _line_misfit(m: np.ndarray, sigma: float, numbers: Any) -> float:
    """Return what points and directions cost on the best line."""
    n = m[0]
    xx, xy, yy = m[3] - m[1] * m[1] / n, m[4] - m[1] * m[2] / n, m[5] - m[2] * m[2] / n
    squares = max((xx + yy) / 2 - np.sqrt(((xx - yy) / 2) ** 2 + xy * xy), 0.0)
    return squares / sigma**2 + 2 * (n - np.hypot(m[10], m[11])) / numbers.sigma_direction_rad**2


@kernel
def _circle_misfit(m: np.ndarray, sigma: float, numbers: Any) -> float:
    """Return what points and directions cost on the best circle (Kasa 1976); infinite without one."""
    n = m[0]
    mx, my, mz = m[1] / n, m[2] / n, m[8] / n
    xx, xy, yy = m[3] - n * mx * mx, m[4] - n * mx * my, m[5] - n * my * my
    xz, yz, zz = m[6] - n * mx * mz, m[7] - n * my * mz, m[9] - n * mz * mz
    determinant = xx * yy - xy * xy
    if determinant <= 1e-9:
        return np.inf
    a, b = (xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant
    square = mz - a * mx - b * my + (a * a + b * b) / 4
    if not numbers.least_radius_m**2 <= square <= numbers.largest_radius_m**2:
        return np.inf
    squares = max(zz - a * xz - b * yz, 0.0) / (4 * square)
    around = abs(m[12] - a / 2 * m[11] + b / 2 * m[10]) / np.sqrt(square)
    return squares / sigma**2 + 2 * max(n - around, 0.0) / numbers.sigma_direction_rad**2
