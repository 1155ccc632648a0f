"""The adjustment of one scan to control points whose errors may be related (paper, eqs. 2 to 5)."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from ..settings import Model
from .similarity import Pose, fit_pose, moved_pose, parameter_design
from .statistical_tests import CRITICAL_W, UNCONTROLLED, critical_tau, divided
from .target_layout import fixes_pose

ROUNDS = 20
SMALL_STEP = 1e-10


@dataclass(frozen=True)
class Fit:
    """An adjusted scan.

    Attributes
    ----------
    model : Model
    pose : Pose
    cofactors : ndarray, shape (u, u)
        Covariance of the parameters, by the a priori standard deviations.
    gain : ndarray, shape (u, 3 k)
        How the parameters follow the coordinates of the control points that were used.
    used : ndarray of bool, shape (k0,)
        Which of the given targets were.
    rejected : dict of int to ndarray, shape (3,)
        Baarda's w that led to the rejection, by the number of the target.
    """

    model: Model
    pose: Pose
    cofactors: np.ndarray
    gain: np.ndarray
    used: np.ndarray
    rejected: dict


def fit_scan(
    targets: np.ndarray, points: np.ndarray, covariance: np.ndarray, model: Model, sigma: float, width: float
) -> Fit:
    """Adjust a scan, and reject outliers one at a time.

    A target is rejected if both Baarda's w, by the a priori standard deviations, and Pope's tau, by the a
    posteriori one, say so: where noise was only taken for too small, nothing is rejected.

    Parameters
    ----------
    targets, points : ndarray, shape (k0, 3)
        Partners, row by row.
    covariance : ndarray, shape (3 k0, 3 k0)
        Of the points.
    model : Model
    sigma : float
        Standard deviation of a target's coordinate, metres.
    width : float
        How far from a line the targets that remain must lie.
    """
    used = np.ones(len(targets), bool)
    rejected: dict = {}
    while True:
        rows = np.repeat(used, 3)
        related = covariance[np.ix_(rows, rows)] + np.eye(rows.sum()) * sigma**2
        pose, cofactors, gain, normalized, sigma0, redundancy = _adjusted(
            targets[used], points[used], related, model
        )
        worst = worst_target(normalized, sigma0, redundancy)
        if worst is None:
            break
        number = int(np.flatnonzero(used)[worst])
        rest = used.copy()
        rest[number] = False
        if not fixes_pose(targets[rest], model, width):
            break
        rejected[number], used = normalized[worst], rest
    return Fit(model, pose, cofactors, gain, used, rejected)


def worst_target(normalized: np.ndarray, sigma0: float, redundancy: float):
    """Return the row with the largest |w| if both tests suspect it, else None.

    Parameters
    ----------
    normalized : ndarray, shape (k, 3)
        Baarda's w.
    sigma0, redundancy : float
        Of the scan.
    """
    largest = np.nan_to_num(np.abs(normalized)).max(axis=1)
    worst = int(largest.argmax())
    limit = max(CRITICAL_W, critical_tau(redundancy) * sigma0)
    return worst if largest[worst] > limit else None


def _adjusted(targets, points, covariance, model) -> tuple:
    pose = fit_pose(points, targets, model)
    factor = cho_factor(covariance)
    for _ in range(ROUNDS):
        design = parameter_design(pose.turned(targets), model).reshape(-1, model.unknowns)
        weighted = cho_solve(factor, design)
        cofactors = np.linalg.inv(design.T @ weighted)
        gain = cofactors @ weighted.T
        step = gain @ (points - pose.apply(targets)).ravel()
        pose = moved_pose(pose, step, model)
        if np.abs(step).max() < SMALL_STEP:
            break
    residuals = (pose.apply(targets) - points).ravel()
    weighted_residuals = cho_solve(factor, residuals)
    # P Qvv P = P - P A Q A' P, whose diagonal serves related observations too.
    weights = cho_solve(factor, np.eye(len(residuals)))
    variances = np.diag(weights) - np.einsum("ij,jk,ik->i", weighted, cofactors, weighted)
    controlled = variances > UNCONTROLLED * np.diag(weights)
    normalized = divided(weighted_residuals, np.where(controlled, np.sqrt(np.abs(variances)), 0.0))
    redundancy = len(residuals) - model.unknowns
    sigma0 = float(np.sqrt(residuals @ weighted_residuals / max(redundancy, 1)))
    return pose, cofactors, gain, normalized.reshape(-1, 3), sigma0, redundancy
