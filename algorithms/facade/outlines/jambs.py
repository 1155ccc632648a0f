"""Points between a wall and what lies behind it: on the jambs of a hole, or mixed of both surfaces."""

import numpy as np
from scipy.spatial import cKDTree

from ...geometry.robust import sigma_about_median
from .settings import OutlineSettings


def is_plumb(
    between: np.ndarray, wall: np.ndarray, settings: OutlineSettings = OutlineSettings()
) -> np.ndarray:
    """Return which points lie on a jamb at right angles to the wall, and so on the border.

    A laser spot on the edge of a sill or of a jamb that faces away from the scanner gives a point between
    wall and pane, on the ray: the deeper it is, the further it lies within the hole. Such points, and those
    of splayed jambs, do not show the border in the plane of the wall.

    Parameters
    ----------
    between, wall : ndarray of float64, shape (n, 3), (m, 3)
        u, v, w.
    settings : OutlineSettings
    """
    limits = settings.jambs
    if min(len(between), len(wall)) < limits.fewest_points:
        return np.zeros(len(between), bool)
    inwards, _ = cKDTree(wall[:, :2]).query(between[:, :2])
    _, near = cKDTree(between[:, :2]).query(between[:, :2], k=min(limits.neighbours, len(between)))
    depths, offsets = -between[near, 2], inwards[near]
    depths = depths - depths.mean(axis=1, keepdims=True)
    middle = np.median(offsets, axis=1, keepdims=True)
    slopes = np.sum(depths * (offsets - middle), axis=1) / np.maximum(np.sum(depths**2, axis=1), 1e-12)
    scatter = sigma_about_median(offsets, axis=1)
    farthest = np.maximum(limits.outlying * scatter, settings.noise_m)
    return (slopes < limits.steepest) & (inwards - middle[:, 0] <= farthest)


def divide_behind(
    behind: np.ndarray, wall: np.ndarray, spacing: float, settings: OutlineSettings = OutlineSettings()
) -> tuple[np.ndarray, np.ndarray]:
    """Return the points at the edge of an opening that are on its jambs, and those that are mixed.

    Points of a jamb have many depths and one distance from the wall. Mixed points lie beside the wall, and
    nearer to it in depth than to what is seen around them. All others are content, such as a frame.

    Parameters
    ----------
    behind, wall : ndarray of float64, shape (n, 3), (m, 3)
        u, v, w; w is 0 on the wall.
    spacing : float
        Of the points of the wall (m).
    settings : OutlineSettings
    """
    limits = settings.jambs
    nothing = np.empty((0, 3))
    if min(len(behind), len(wall)) < limits.fewest_points:
        return nothing, nothing
    inwards, _ = cKDTree(wall[:, :2]).query(behind[:, :2])
    beside = inwards <= limits.beside_spacings * spacing
    near = behind[beside]
    if len(near) < limits.fewest_points:
        return nothing, nothing
    _, around = cKDTree(behind[:, :2]).query(near[:, :2], k=min(limits.neighbours, len(behind)))
    depths = behind[around, 2]
    spread = np.ptp(np.percentile(depths, (10, 90), axis=1), axis=0)
    plumb = is_plumb(near, wall, settings) & (spread >= limits.least_spread_m)
    close = inwards[beside] <= max(spacing, settings.border.beam_m)
    mixed = ~plumb & close & (near[:, 2] > 0.5 * np.median(depths, axis=1))
    return near[plumb], near[mixed]
