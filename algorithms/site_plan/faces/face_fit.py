"""Faces of walls: straight or round, fitted to voxels so that a few strangers do no harm."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.curves import Curve, left_of
from ...geometry.robust import tukey_weights, weighted_sigma_of_residuals

WIDE = 0.05
"""Voxels farther than this (m) from a face belong to another; thin walls are twice as thick."""

LEAST_SCATTER = 0.002
"""Smallest standard deviation (m) that voxels about a face are taken to have."""

TUKEY = 3.0
"""Voxels farther than this many standard deviations have no weight (Beaton and Tukey 1974); their 4.7 is for
few observations, and lets more strangers in."""

ROUNDS = 12


@dataclass(frozen=True)
class Fit:
    """A face as fitted.

    Attributes
    ----------
    curve : Line or Arc
    rms : float
        Of the voxels about it, metres.
    reach : float
        Voxels up to this far from it belong to it, metres.
    """

    curve: Curve
    rms: float
    reach: float


def fit_face(curve: Curve, xy: np.ndarray, area: np.ndarray) -> Optional[Fit]:
    """Fit a face to voxels about a first guess; iterated, with Tukey's weights.

    Parameters
    ----------
    curve : Line or Arc
        First guess, within `WIDE` of the face.
    xy : ndarray of float64, shape (n, 2)
        Means of voxels.
    area : ndarray of float64, shape (n,)
        How much of the face a voxel stands for.

    Returns
    -------
    Fit or None
        None if hardly any voxel is near.
    """
    for _ in range(ROUNDS):
        offset = curve.offset(xy)
        near = np.abs(offset) < WIDE
        if near.sum() < 3 or area[near].sum() <= 0:
            return None
        scatter = max(weighted_sigma_of_residuals(offset[near], area[near]), LEAST_SCATTER)
        weight = np.where(near, tukey_weights(offset, scatter, TUKEY), 0.0) * area
        if np.count_nonzero(weight) < 3:
            return None
        curve = curve.fitted(xy, weight)
    offset = curve.offset(xy)
    reach = min(3 * scatter + LEAST_SCATTER, WIDE)
    used = np.abs(offset) <= reach
    return Fit(curve, float(np.sqrt(np.average(offset[used] ** 2, weights=area[used]))), reach)


def crossing(one: Curve, other: Curve, near: np.ndarray) -> Optional[np.ndarray]:
    """Return the point that two faces share nearest to a place; None if they do not meet there.

    Newton's method: two steps suffice for lines, and a few for arcs.
    """
    point = np.array(near, float)
    for _ in range(8):
        across = np.stack([left_of(one.heading(point)), left_of(other.heading(point))])
        if abs(np.linalg.det(across)) < 1e-3:
            return None
        point = point - np.linalg.solve(across, [one.offset(point), other.offset(point)])
    return point if max(abs(one.offset(point)), abs(other.offset(point))) < 1e-6 else None
