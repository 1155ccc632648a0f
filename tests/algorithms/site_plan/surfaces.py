"""Points of walls, floors, bushes and furniture, and the values of the bands where they are."""

from types import SimpleNamespace

import numpy as np
from ichnograph.algorithms.site_plan.walls.height_gate import make_gate

ORIGIN = np.array([412_300.0, 5_812_700.0, 0.0])

SHIFT = np.array([0.037, 0.053, 0.0])
"""Keeps surfaces at round coordinates off the pixels' edges."""


def cloud_of(points, cuts=()):
    """Return the points as a cloud of one or more chunks."""
    chunks = np.split(points + SHIFT, cuts)
    source = SimpleNamespace(path=SimpleNamespace(name="scan.laz"))
    return SimpleNamespace(
        positions=lambda progress: iter(chunks),
        expected_points=0,
        origin=ORIGIN,
        warnings=(),
        sources=(source,),
        crs=None,
    )


def level(x, y, z, step=0.03):
    """Return a horizontal surface over x from, to and y from, to."""
    east, north = np.meshgrid(np.arange(*x, step), np.arange(*y, step))
    return np.column_stack([east.ravel(), north.ravel(), np.full(east.size, z)])


def upright(start, stop, low, high, step=0.03):
    """Return an upright surface between two places of the plan."""
    length = np.hypot(*np.subtract(stop, start))
    share, z = np.meshgrid(np.arange(0, length, step) / length, np.arange(low, high, step))
    plan = np.array(start) + share.reshape(-1, 1) * np.subtract(stop, start)
    return np.column_stack([plan, z.ravel()])


def box(x, y, low, high):
    """Return the sides and the top of a box."""
    corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
    sides = [upright(a, b, low, high) for a, b in zip(corners, corners[1:] + corners[:1])]
    return np.concatenate([*sides, level(x, y, high)])


def foliage(x, y, high, per_cubic_metre=3000, seed=0):
    """Return points strewn over a box from the ground up."""
    count = round((x[1] - x[0]) * (y[1] - y[0]) * high * per_cubic_metre)
    return np.random.default_rng(seed).uniform((x[0], y[0], 0), (x[1], y[1], high), (count, 3))


def turned(points, degrees):
    """Return the points turned about the origin."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def band_at(image, band, points):
    """Return the values of a band of an image, or of an array as large, at places of the plan."""
    values = getattr(image, band) if isinstance(band, str) else band
    x, y = (points + SHIFT + ORIGIN)[:, :2].T
    column, row = ~image.transform * (x, y)
    return values[row.astype(int), column.astype(int)]


def gate_of(image):
    """Return the gate of an image at the default height."""
    return make_gate(image.density, image.heights, 0.4, image.transform.a)
