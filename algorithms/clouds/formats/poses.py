"""Poses of scans, checked before points are moved by them."""

import numpy as np

from ..settings import PoseSettings


def pose_problem(linear: np.ndarray, shift: np.ndarray, settings: PoseSettings = PoseSettings()) -> str:
    """Return why points cannot be moved by a pose, in words that follow 'the pose'; nothing if they can.

    Parameters
    ----------
    linear : ndarray, shape (3, 3)
    shift : ndarray, shape (3,)
        Metres.
    settings : PoseSettings
    """
    if not (np.isfinite(linear).all() and np.isfinite(shift).all()):
        return "holds something that is not a number"
    if not linear.any():
        return "is all zero, so that every point would lie in one position"
    if np.abs(shift).max() > settings.farthest_m:
        return f"moves the points by {np.abs(shift).max():.0e} m"
    with np.errstate(over="ignore", invalid="ignore"):
        determinant = float(np.linalg.det(linear))
    if not settings.smallest_volume < abs(determinant) < 1 / settings.smallest_volume:
        return "presses or blows up the points beyond any unit of length"
    return "mirrors the points" if determinant < 0 else ""


def pose_doubt(linear: np.ndarray, settings: PoseSettings = PoseSettings()) -> str:
    """Return what a pose does besides turning and shifting, in words that follow 'the pose'; or nothing."""
    scale = float(np.cbrt(np.linalg.det(linear)))
    if np.abs(linear.T @ linear / scale**2 - np.eye(3)).max() > settings.orthogonal:
        return "distorts the points because its rotation is not orthogonal"
    return f"scales the points by {scale:.6g}" if abs(scale - 1) > settings.orthogonal else ""
