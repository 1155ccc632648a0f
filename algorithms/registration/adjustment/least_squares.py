"""The least squares adjustment of all scans in one block (paper, eqs. 2 to 5).

Each coordinate of a target is an observation of its control point: v = m R B + T - A. Control points that are
not held fixed are unknowns too: those appended from scans, and surveyed points with a standard deviation,
which are then observed as well. The normal equations are set up about the centres of the scans.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Union

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.sparse import csr_matrix

from ..settings import Model
from .gauss_newton import iterated
from .settings import AdjustmentSettings, OutlierTestSettings
from .similarity import Pose, moved_pose, parameter_design
from .statistical_tests import detectable_biases, normalized_residuals

Unknowns = tuple[list[Pose], np.ndarray]
"""The poses of the scans, and the control points."""


@dataclass(frozen=True)
class Sighting:
    """The targets of one scan that have a control point.

    Attributes
    ----------
    targets : ndarray, shape (k, 3)
        In the scan.
    points : ndarray of int, shape (k,)
        Rows of their control points.
    pose : Pose
        Start value.
    """

    targets: np.ndarray
    points: np.ndarray
    pose: Pose


@dataclass(frozen=True)
class Residuals:
    """Observations of one kind after the adjustment; all arrays have shape (k, 3).

    Attributes
    ----------
    residuals : ndarray
        v, metres.
    redundancy : ndarray
        Redundancy numbers r, 0..1.
    normalized : ndarray
        Baarda's w = v / (sigma sqrt(r)); nan where r is 0.
    detectable : ndarray
        Minimal detectable bias sigma delta0 / sqrt(r), metres; nan where r is 0.
    """

    residuals: np.ndarray
    redundancy: np.ndarray
    normalized: np.ndarray
    detectable: np.ndarray


@dataclass(frozen=True)
class Block:
    """An adjusted block.

    Attributes
    ----------
    poses : tuple of Pose
    pose_cofactors : tuple of ndarray, shape (u, u)
        Covariances of the parameters of each scan, by the a priori standard deviations.
    points : ndarray, shape (p, 3)
        Control points, adjusted.
    point_covariances : ndarray, shape (p, 3, 3)
        By the a priori standard deviations; zero where held fixed.
    targets : tuple of Residuals
        Of each scan.
    control : Residuals
        Of the surveyed coordinates, nan in rows that are not observed.
    sum_of_squares : float
        v'Pv.
    redundancy : int
        n - u.
    """

    poses: tuple[Pose, ...]
    pose_cofactors: tuple[np.ndarray, ...]
    points: np.ndarray
    point_covariances: np.ndarray
    targets: tuple[Residuals, ...]
    control: Residuals
    sum_of_squares: float
    redundancy: int


def adjust(
    sightings: Sequence[Sighting],
    points: np.ndarray,
    surveyed: np.ndarray,
    model: Model,
    sigma: float,
    control_sigma: Union[float, np.ndarray] = 0.0,
    settings: AdjustmentSettings = AdjustmentSettings(),
) -> Block:
    """Adjust scans to their control points.

    Parameters
    ----------
    sightings : sequence of Sighting
        Each with enough well placed targets for the model.
    points : ndarray, shape (p, 3)
        Control points; start values of those that were not surveyed, which at least two scans see.
    surveyed : ndarray of bool, shape (p,)
    model : Model
    sigma : float
        A priori standard deviation of the coordinates of targets, metres.
    control_sigma : float or ndarray, shape (p,)
        The same of surveyed points; 0 where held fixed.
    settings : AdjustmentSettings
    """
    sigmas = np.broadcast_to(control_sigma, len(points))
    loose = (sigmas > 0) | ~surveyed
    seen = np.zeros(len(points), bool)
    seen[np.concatenate([item.points for item in sightings])] = True
    system = _System(sightings, points, surveyed & seen, loose & seen, model, sigma, sigmas)
    return system.solved(settings)


class _System:
    """The observation equations, one row for a coordinate; columns are -1 where a row has fewer."""

    def __init__(
        self,
        sightings: Sequence[Sighting],
        points: np.ndarray,
        surveyed: np.ndarray,
        loose: np.ndarray,
        model: Model,
        sigma: float,
        control_sigmas: np.ndarray,
    ) -> None:
        self.sightings, self.given, self.model = sightings, points, model
        self.loose = np.flatnonzero(loose)
        self.observed = np.flatnonzero(surveyed & loose)
        self.pose_unknowns = model.unknowns * len(sightings)
        self.first = np.full(len(points), -1)
        self.first[self.loose] = self.pose_unknowns + 3 * np.arange(len(self.loose))
        self.unknowns = self.pose_unknowns + 3 * len(self.loose)
        rows = [np.full(3 * len(item.points), sigma) for item in sightings]
        self.sigmas = np.concatenate([*rows, np.repeat(control_sigmas[self.observed], 3)])

    def solved(self, settings: AdjustmentSettings) -> Block:
        start = [item.pose for item in self.sightings], self.given
        poses, points = iterated(self._advanced, start, settings.iteration)
        return self._block(poses, points, settings.tests)

    def _advanced(self, unknowns: Unknowns) -> tuple[Unknowns, np.ndarray]:
        poses, points = unknowns
        self.columns, self.values = self._design(poses)
        step, self.cofactors = self._step(self.columns, self.values, self._residuals(poses, points))
        shares = step[: self.pose_unknowns].reshape(len(poses), -1)
        points = points.copy()
        points[self.loose] += step[self.pose_unknowns :].reshape(-1, 3)
        return ([moved_pose(pose, share, self.model) for pose, share in zip(poses, shares)], points), step

    def _residuals(self, poses: list[Pose], points: np.ndarray) -> np.ndarray:
        """Return v at the present values, shape (n,)."""
        of_targets = [
            (pose.rotated(item.targets) + (pose.position - points[item.points])).ravel()
            for item, pose in zip(self.sightings, poses)
        ]
        return np.concatenate([*of_targets, (points - self.given)[self.observed].ravel()])

    def _design(self, poses: list[Pose]) -> tuple[np.ndarray, np.ndarray]:
        """Return the columns and the values of the derivatives of v, shape (n, u + 1) each."""
        width = self.model.unknowns
        columns, values = [], []
        for number, (item, pose) in enumerate(zip(self.sightings, poses)):
            derivatives = parameter_design(pose.rotated(item.targets), self.model).reshape(-1, width)
            of_pose = np.broadcast_to(np.arange(width) + number * width, derivatives.shape)
            columns.append(np.column_stack([of_pose, self._point_columns(item.points)]))
            values.append(np.column_stack([derivatives, np.full(len(derivatives), -1.0)]))
        count = 3 * len(self.observed)
        columns.append(np.full((count, width + 1), -1))
        columns[-1][:, -1] = self._point_columns(self.observed)
        values.append(np.zeros((count, width + 1)))
        values[-1][:, -1] = 1.0
        columns, values = np.concatenate(columns), np.concatenate(values)
        return columns, np.where(columns < 0, 0.0, values)

    def _point_columns(self, points: np.ndarray) -> np.ndarray:
        first = self.first[points][:, None]
        return np.where(first < 0, -1, first + np.arange(3)).ravel()

    def _step(
        self, columns: np.ndarray, values: np.ndarray, residuals: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return x = (A'PA)^-1 A'Pl and the inverse, where l = -v (paper, eq. 3)."""
        rows = np.repeat(np.arange(len(columns)), columns.shape[1])
        weighted = (values / self.sigmas[:, None]).ravel()
        shape = (len(columns), self.unknowns)
        design = csr_matrix((weighted, (rows, np.maximum(columns, 0).ravel())), shape)
        normal = (design.T @ design).toarray()
        # Shifts and angles differ in size by the extent of a scan; so scaled, they do not.
        sizes = np.sqrt(np.diag(normal))
        factor = cho_factor(normal / np.outer(sizes, sizes))
        cofactors = cho_solve(factor, np.eye(self.unknowns)) / np.outer(sizes, sizes)
        return cofactors @ (design.T @ (-residuals / self.sigmas)), cofactors

    def _block(self, poses: list[Pose], points: np.ndarray, tests: OutlierTestSettings) -> Block:
        values, cofactors = self.values, self.cofactors
        columns = np.maximum(self.columns, 0)
        adjusted = np.einsum(
            "ij,ijk,ik->i", values, cofactors[columns[:, :, None], columns[:, None, :]], values
        )
        redundancy = np.clip(1.0 - adjusted / self.sigmas**2, 0.0, 1.0)
        residuals = self._residuals(poses, points)
        ends = 3 * np.cumsum([len(item.points) for item in self.sightings])
        parts = zip(*(np.split(each, ends) for each in (residuals, redundancy, self.sigmas)))
        kinds = [_tested(v.reshape(-1, 3), r.reshape(-1, 3), s.reshape(-1, 3), tests) for v, r, s in parts]
        width = self.model.unknowns
        return Block(
            poses=tuple(poses),
            pose_cofactors=tuple(
                cofactors[i : i + width, i : i + width] for i in range(0, self.pose_unknowns, width)
            ),
            points=points,
            point_covariances=self._point_covariances(cofactors),
            targets=tuple(kinds[:-1]),
            control=self._of_all_points(kinds[-1]),
            sum_of_squares=float(np.sum((residuals / self.sigmas) ** 2)),
            redundancy=len(residuals) - self.unknowns,
        )

    def _point_covariances(self, cofactors: np.ndarray) -> np.ndarray:
        covariances = np.zeros((len(self.given), 3, 3))
        columns = self.first[self.loose][:, None] + np.arange(3)
        covariances[self.loose] = cofactors[columns[:, :, None], columns[:, None, :]]
        return covariances

    def _of_all_points(self, observed: Residuals) -> Residuals:
        """Return the residuals of the surveyed coordinates in the rows of all points."""
        spread = []
        for values in (observed.residuals, observed.redundancy, observed.normalized, observed.detectable):
            spread.append(np.full(self.given.shape, np.nan))
            spread[-1][self.observed] = values
        return Residuals(*spread)


def _tested(
    residuals: np.ndarray, redundancy: np.ndarray, sigmas: np.ndarray, tests: OutlierTestSettings
) -> Residuals:
    return Residuals(
        residuals=residuals,
        redundancy=redundancy,
        normalized=normalized_residuals(residuals / sigmas, redundancy, np.ones(1), tests),
        detectable=detectable_biases(sigmas, redundancy, tests),
    )
