"""How far the uncertainty of a pose moves the targets that it transforms."""

import numpy as np

from ..adjustment.similarity import Pose
from ..settings import Model


def leverage(poses: Pose, targets: np.ndarray, partners: np.ndarray, model: Model) -> np.ndarray:
    """Return the variance that poses add to each target, over that of a coordinate.

    Parameters
    ----------
    poses : Pose
        A stack of s.
    targets : ndarray, shape (n, 3)
    partners : ndarray of int, shape (s, k)
        The targets from which each pose was computed.
    model : Model

    Returns
    -------
    ndarray, shape (s, n)
    """
    arms = poses.rotated(targets[partners])
    squares = (arms**2).sum(axis=(-2, -1))
    all_arms = poses.rotated(np.broadcast_to(targets, (len(partners), *targets.shape)))
    if model.levelled:
        inertia = (arms[..., :2] ** 2).sum(axis=(-2, -1))
        far = (all_arms[..., :2] ** 2).sum(axis=-1)
    else:
        moments = squares[:, None, None] * np.eye(3) - np.swapaxes(arms, -1, -2) @ arms
        inertia = np.linalg.eigvalsh(moments)[:, 0]
        far = (all_arms**2).sum(axis=-1)
    tiny = np.finfo(float).tiny
    added = 1.0 / partners.shape[1] + far / np.maximum(inertia, tiny)[:, None]
    if model.scaled:
        added = added + (all_arms**2).sum(axis=-1) / np.maximum(squares, tiny)[:, None]
    return added


def scale_shift(poses: Pose, targets: np.ndarray, scale_error: float, count: int) -> np.ndarray:
    """Return how far a scale error may move each target by `count` poses without scale, shape (s, n)."""
    arms = poses.rotated(np.broadcast_to(targets, (count, *targets.shape)))
    return scale_error * np.linalg.norm(arms, axis=-1)


def rotation_std_deg(pose: Pose, targets: np.ndarray, levelled: bool, sigma: float) -> float:
    """Return the standard deviation of the least certain rotation of a scan, degrees.

    Parameters
    ----------
    pose : Pose
    targets : ndarray, shape (n, 3)
        From which it was computed.
    levelled : bool
    sigma : float
        Standard deviation of a coordinate.
    """
    arms = pose.rotated(targets)
    arms = arms - arms.mean(axis=0)
    if levelled:
        inertia = float((arms[:, :2] ** 2).sum())
    else:
        inertia = float(np.linalg.eigvalsh((arms**2).sum() * np.eye(3) - arms.T @ arms)[0])
    return float(np.degrees(sigma / np.sqrt(max(inertia, np.finfo(float).tiny))))
