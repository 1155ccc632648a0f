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
    """Return places `step` apart, half a step from the edges, shape (n, 2)."""
    u = np.arange(left + step / 2, right, step)
    v = np.arange(bottom + step / 2, top, step)
    return np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)


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
