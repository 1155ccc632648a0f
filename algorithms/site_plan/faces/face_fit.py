"""Lines and arcs fitted to the voxels of faces, so that clutter before a face does not move it."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.curves import Curve
from ...geometry.robust import tukey_weights, weighted_sigma_of_residuals
from .settings import FaceFitSettings


@dataclass(frozen=True)
class CurveFit:
    """A line or an arc as fitted.

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


def fit_curve(
    curve: Curve, xy: np.ndarray, area: np.ndarray, settings: FaceFitSettings = FaceFitSettings()
) -> Optional[CurveFit]:
    """Fit a curve to voxels about a first guess; iterated, with Tukey's weights.

    Parameters
    ----------
    curve : Line or Arc
        First guess, within `wide_m` of the face.
    xy : ndarray of float64, shape (n, 2)
        Means of voxels.
    area : ndarray of float64, shape (n,)
        How much of the face a voxel stands for.
    settings : FaceFitSettings

    Returns
    -------
    CurveFit or None
        None if hardly any voxel is near.
    """
    least = settings.least_scatter_m
    for _ in range(settings.rounds):
        offset = curve.offset(xy)
        near = np.abs(offset) < settings.wide_m
        if near.sum() < 3 or area[near].sum() <= 0:
            return None
        scatter = max(weighted_sigma_of_residuals(offset[near], area[near]), least)
        weight = np.where(near, tukey_weights(offset, scatter, settings.tukey_cut), 0.0) * area
        if np.count_nonzero(weight) < 3:
            return None
        curve = curve.fitted(xy, weight)
    offset = curve.offset(xy)
    reach = min(3 * scatter + least, settings.wide_m)
    used = np.abs(offset) <= reach
    return CurveFit(curve, float(np.sqrt(np.average(offset[used] ** 2, weights=area[used]))), reach)
