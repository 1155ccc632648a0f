"""The covariances of targets, from the frame of their scan to that of the control points."""

from typing import Optional

import numpy as np

from .similarity import Pose


def in_control_frame(covariances: Optional[np.ndarray], count: int, pose: Pose, sigma: float) -> np.ndarray:
    """Return m R C (m R)' of each target, shape (k, 3, 3), and sigma^2 I of targets without a covariance.

    Parameters
    ----------
    covariances : ndarray, shape (k, 3, 3), or None
        In the scan, square metres; nan where unknown.
    count : int
        The number k of targets.
    pose : Pose
    sigma : float
        Standard deviation of a coordinate of the others, metres of the control frame.
    """
    result = np.tile(np.eye(3) * sigma**2, (count, 1, 1))
    if covariances is None:
        return result
    known = np.isfinite(covariances).all(axis=(1, 2))
    turn = pose.scale * pose.rotation
    result[known] = turn @ covariances[known] @ turn.T
    return result
