"""What the layout of targets allows."""

import numpy as np

from ..matching.control_points import factor_of
from ..settings import Matching, Model, Settings

FLAT = 1e-3
"""Where the scale may be any, what is thinner than this share of its extent counts as a line."""


def has_free_scale(settings: Settings) -> bool:
    """Tell whether the scale may be any, not only near 1: if unknown, or if names say which is which."""
    model = settings.model
    return model is Model.UNKNOWN_SCALE or (settings.matching is Matching.NAMES and model.scaled)


def line_width(targets: np.ndarray, settings: Settings) -> float:
    """Return how far from a line targets may lie and still count as on it, in units of the scan."""
    if has_free_scale(settings):
        return FLAT * float(np.ptp(targets, axis=0).max(initial=0.0))
    return factor_of(settings.tolerance, settings.sigma, settings.control_sigma) * settings.sigma


def spread(points: np.ndarray) -> np.ndarray:
    """Return how far points lie from their best plane, line and middle at most: shape (3,), metres.

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
    """Tell whether targets fix a pose: not within `width` of a line, or of a vertical line if levelled."""
    if len(points) < model.least_targets:
        return False
    if model.levelled:
        level = points[:, :2] - points[:, :2].mean(axis=0)
        return bool(np.linalg.norm(level, axis=1).max() > width)
    return bool(spread(points)[1] > width)
