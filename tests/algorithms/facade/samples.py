"""Walls, lattices and elevations that the tests of the facade share."""

import numpy as np
from ichnograph.algorithms.facade.elevation import (
    OPENING,
    RECTANGLE,
    Detail,
    Edges,
    Elevation,
    Frame,
    Points,
)
from shapely.geometry import MultiPolygon, box


def lattice(left, bottom, right, top, step):
    """Return points `step` apart, half a step from the edges, shape (n, 2)."""
    u = np.arange(left + step / 2, right, step)
    v = np.arange(bottom + step / 2, top, step)
    return np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)


def at(points, w=0.0):
    """Return points in the plane at a depth, shape (n, 3)."""
    return np.column_stack([points, np.full(len(points), w)])


def scattered(points, share=0.3, step=0.02, seed=0):
    """Return points moved at random by up to a share of their step."""
    return points + np.random.default_rng(seed).uniform(-share, share, points.shape) * step


def without(points, left, bottom, right, top):
    """Return the points outside a rectangle."""
    inside = ((points > (left, bottom)) & (points < (right, top))).all(axis=1)
    return points[~inside]


def upright(width, height, w=0.0, step=0.02, noise=0.001, seed=0):
    """Return points of a wall along x that is seen from the south, at y = -w, shape (n, 3)."""
    uv = lattice(0, 0, width, height, step)
    y = -w + np.random.default_rng(seed).normal(0, noise, len(uv))
    return np.column_stack([uv[:, 0], y, uv[:, 1]])


def bare(xyz, origin=(0.0, 0.0, 0.0)):
    """Return points without colour and intensity."""
    return Points(xyz, np.array(origin, float), None, None, np.zeros(len(xyz), np.int32))


def small_elevation(frame=None):
    """Return a wall of 4 x 3 m with one opening."""
    frame = frame or Frame(np.array([412345.678, 5812345.789, 71.234]), 213.4, 1.7)
    window = box(1.0, 1.0, 2.0, 2.5)
    nothing = float("nan")
    detail = Detail(
        1, OPENING, RECTANGLE, window, window, Edges(0.001, nothing, 0.002, 0.003), 0.002, -0.2, 50,
        (10.4, 20.6, 30.0), 123.4,
    )  # fmt: skip
    wall = MultiPolygon([box(0, 0, 4, 3).difference(window)])
    return Elevation(frame, wall, (detail,), (box(3, 0, 3.5, 1),), 0.01)


def site_of(row, uv):
    """Return x, y, z of points in u, v, by the formula of the manual."""
    a, t = np.radians(float(row["azimuth"])), np.radians(float(row["tilt"]))
    u, v = np.asarray(uv, float).T
    return np.column_stack([
        float(row["x0"]) - u * np.cos(a) - v * np.sin(a) * np.sin(t),
        float(row["y0"]) + u * np.sin(a) - v * np.cos(a) * np.sin(t),
        float(row["z0"]) + v * np.cos(t),
    ])  # fmt: skip
