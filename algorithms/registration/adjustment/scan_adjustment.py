"""The adjustment of one scan to control points whose errors may be correlated (paper, eqs. 2 to 5)."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve

from ..results import GlobalTest
from ..settings import Model, Settings
from .gauss_newton import iterated
from .similarity import Pose, fit_pose, moved_pose, parameter_design
from .statistical_tests import global_test, normalized_residuals, worst_target
from .target_covariances import in_control_frame
from .target_layout import fixes_pose

State = tuple[Pose, np.ndarray, np.ndarray]
"""The pose; P A and the cofactors of its parameters, at the pose before."""


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
        Derivatives of the parameters by the coordinates of the control points that were used.
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
    rejected: dict[int, np.ndarray]


@dataclass(frozen=True)
class _Adjusted:
    pose: Pose
    cofactors: np.ndarray
    gain: np.ndarray
    normalized: np.ndarray
    test: GlobalTest


def fit_scan(
    targets: np.ndarray,
    points: np.ndarray,
    covariance: np.ndarray,
    settings: Settings,
    width: float,
    own: Optional[np.ndarray] = None,
) -> Fit:
    """Adjust a scan, and reject outliers one at a time, as `worst_target` finds them.

    Parameters
    ----------
    targets, points : ndarray, shape (k0, 3)
        Partners, row by row.
    covariance : ndarray, shape (3 k0, 3 k0)
        Of the points.
    settings : Settings
    width : float
        How far from a line the targets that remain must lie.
    own : ndarray, shape (k0, 3, 3), or None
        Covariances of the targets in the scan, nan where SIGMA counts; None if it counts for all.
    """
    used = np.ones(len(targets), bool)
    rejected: dict[int, np.ndarray] = {}
    while True:
        rows = np.repeat(used, 3)
        of_targets = _of_targets(targets[used], points[used], None if own is None else own[used], settings)
        related = covariance[np.ix_(rows, rows)] + of_targets
        adjusted = _adjusted(targets[used], points[used], related, settings)
        test = adjusted.test
        worst = worst_target(adjusted.normalized, test.sigma0, test.redundancy, settings.adjustment.tests)
        if worst is None:
            break
        number = int(np.flatnonzero(used)[worst])
        rest = used.copy()
        rest[number] = False
        if not fixes_pose(targets[rest], settings.model, width):
            break
        rejected[number], used = adjusted.normalized[worst], rest
    return Fit(settings.model, adjusted.pose, adjusted.cofactors, adjusted.gain, used, rejected)


def _of_targets(
    targets: np.ndarray, points: np.ndarray, own: Optional[np.ndarray], settings: Settings
) -> np.ndarray:
    """Return the covariance of the targets in the control frame, shape (3 k, 3 k)."""
    pose = fit_pose(points, targets, settings.model)
    return block_diag(*in_control_frame(own, len(targets), pose, settings.sigma))


def _adjusted(
    targets: np.ndarray, points: np.ndarray, covariance: np.ndarray, settings: Settings
) -> _Adjusted:
    model, tests = settings.model, settings.adjustment.tests
    factor = cho_factor(covariance)

    def advance(state: State) -> tuple[State, np.ndarray]:
        pose = state[0]
        design = parameter_design(pose.rotated(targets), model).reshape(-1, model.unknowns)
        weighted = cho_solve(factor, design)
        cofactors = np.linalg.inv(design.T @ weighted)
        step = (cofactors @ weighted.T) @ (points - pose.apply(targets)).ravel()
        return (moved_pose(pose, step, model), weighted, cofactors), step

    start = (fit_pose(points, targets, model), np.empty(0), np.empty(0))
    pose, weighted, cofactors = iterated(advance, start, settings.adjustment.iteration)
    residuals = (pose.apply(targets) - points).ravel()
    weighted_residuals = cho_solve(factor, residuals)
    # P Qvv P = P - P A Q A' P, whose diagonal is right for correlated observations too.
    weights = cho_solve(factor, np.eye(len(residuals)))
    variances = np.diag(weights) - np.einsum("ij,jk,ik->i", weighted, cofactors, weighted)
    normalized = normalized_residuals(weighted_residuals, variances, np.diag(weights), tests)
    test = global_test(float(residuals @ weighted_residuals), len(residuals) - model.unknowns, tests)
    return _Adjusted(pose, cofactors, cofactors @ weighted.T, normalized.reshape(-1, 3), test)
