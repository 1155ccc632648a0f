"""What the layout of targets determines: a pose, or only one that rotates about a line; a scale."""

import numpy as np

from ..settings import Model, Settings


def line_width(targets: np.ndarray, settings: Settings) -> float:
    """Return the distance from a line within which targets count as on it, in units of the scan."""
    if settings.free_scale:
        return settings.adjustment.layout.flat_share * float(np.ptp(targets, axis=0).max(initial=0.0))
    return settings.distance_factor * settings.sigma


def spread(points: np.ndarray) -> np.ndarray:
    """Return the largest distances of points from their best plane, line and middle: shape (3,), metres.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    """
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=len(points) < 3)
    along = np.abs(centred @ axes.T)
    squares = along**2
    return np.sqrt([squares[:, 2].max(), squares[:, 1:].sum(axis=1).max(), squares.sum(axis=1).max()])


def fixes_pose(points: np.ndarray, model: Model, width: float) -> bool:
    """Return whether targets fix a pose: not within `width` of a line, or of a vertical line if levelled."""
    if len(points) < model.least_targets:
        return False
    if model.levelled:
        level = points[:, :2] - points[:, :2].mean(axis=0)
        return bool(np.linalg.norm(level, axis=1).max() > width)
    return bool(spread(points)[1] > width)


def is_of_projection(ppm: float, targets: np.ndarray, settings: Settings) -> bool:
    """Return whether coordinates that are not reduced for the projection may cause a scale error.

    It must be as large as projections have it, and change the extent of the targets by more than distances
    may differ: over a few metres, a wrong target changes it as much.

    Parameters
    ----------
    ppm : float
    targets : ndarray, shape (k, 3)
        Those that fit.
    settings : Settings
    """
    limits = settings.adjustment.scale_test
    most = 1e6 * settings.matches.tolerances.scale_error
    change = abs(ppm) / 1e6 * float(np.linalg.norm(np.ptp(targets, axis=0)))
    large = change > max(settings.distance_tolerance, limits.least_projection_m)
    return large and limits.least_projection_ppm < abs(ppm) <= most
