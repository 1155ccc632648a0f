"""Points on the surfaces of made-up rooms, as a scanner would leave them."""

import numpy as np

SPACING = 0.025
HEIGHT = 2.6


def upright(start, stop, low=0.0, high=HEIGHT, spacing=SPACING) -> np.ndarray:
    """Return points on an upright surface between two places, shape (n, 3)."""
    start, stop = np.array(start, float), np.array(stop, float)
    length = np.hypot(*(stop - start))
    along, up = np.meshgrid(
        np.arange(spacing / 2, length, spacing), np.arange(low + spacing / 2, high, spacing)
    )
    xy = start + along.reshape(-1, 1) / length * (stop - start)
    return np.column_stack([xy, up.ravel()])


def flat(x0, y0, x1, y1, z, spacing=SPACING) -> np.ndarray:
    """Return points on a level rectangle, shape (n, 3)."""
    x, y = np.meshgrid(np.arange(x0 + spacing / 2, x1, spacing), np.arange(y0 + spacing / 2, y1, spacing))
    return np.column_stack([x.ravel(), y.ravel(), np.full(x.size, float(z))])


def room(x0, y0, x1, y1, height=HEIGHT, spacing=SPACING) -> np.ndarray:
    """Return points on the floor, the ceiling and the four walls of a room."""
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    walls = [upright(a, b, 0.0, height, spacing) for a, b in zip(corners, corners[1:] + corners[:1])]
    level = [flat(x0, y0, x1, y1, z, spacing) for z in (0.0, height)]
    return np.concatenate(level + walls)


def without(points, low, high) -> np.ndarray:
    """Return the points that are not inside a box, given by two corners."""
    inside = np.all((points >= np.array(low) - 1e-9) & (points <= np.array(high) + 1e-9), axis=1)
    return points[~inside]


def scanned(*surfaces, noise=0.002, seed=0) -> np.ndarray:
    """Return the points of surfaces with noise, metres."""
    points = np.concatenate(surfaces)
    return points + np.random.default_rng(seed).normal(0, noise, points.shape)
