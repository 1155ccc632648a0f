"""Points between a wall and what lies behind it: of the jambs of a hole, or mixed of both."""

import numpy as np
from scipy.spatial import cKDTree

from ...geometry.robust import sigma_about_median

LOCAL = 30
"""Neighbouring points that are judged together."""

STEEPEST = 0.1
"""Points that move further into the hole, in units of their depth, are of no plumb jamb."""

TOO_FAR = 2.0
"""A point that lies further within the hole than its neighbours, in units of their scatter, is no jamb's."""

FEWEST = 5


def is_plumb(between: np.ndarray, wall: np.ndarray) -> np.ndarray:
    """Tell which points are of a jamb at right angles to the wall, so that they lie on the border.

    A laser spot on the edge of a sill or a jamb that faces away from the scanner gives a point between
    wall and pane, on the ray: the deeper it is, the further it lies within the hole. Such points, and those
    of splayed jambs, do not tell where the border is in the plane of the wall.

    Parameters
    ----------
    between, wall : ndarray of float64, shape (n, 3), (m, 3)
        u, v, w.
    """
    if min(len(between), len(wall)) < FEWEST:
        return np.zeros(len(between), bool)
    inwards, _ = cKDTree(wall[:, :2]).query(between[:, :2])
    _, near = cKDTree(between[:, :2]).query(between[:, :2], k=min(LOCAL, len(between)))
    depths, offsets = -between[near, 2], inwards[near]
    depths = depths - depths.mean(axis=1, keepdims=True)
    middle = np.median(offsets, axis=1, keepdims=True)
    slopes = np.sum(depths * (offsets - middle), axis=1) / np.maximum(np.sum(depths**2, axis=1), 1e-12)
    scatter = sigma_about_median(offsets, axis=1)
    return (slopes < STEEPEST) & (inwards - middle[:, 0] <= np.maximum(TOO_FAR * scatter, 0.002))
