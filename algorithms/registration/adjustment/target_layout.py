"""What the layout of targets determines: a pose, or only a pose that still rotates about a line."""

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
