"""The least squares adjustment of all scans in one block (paper, eqs. 2 to 5).

Each coordinate of a target is an observation of its control point: v = m R B + T - A. The three of a target
may be correlated. Control points that are not held fixed are unknowns too: those appended from scans, and
surveyed points with a standard deviation, which are then observed as well. Surfaces that two scans see tie
their poses. The normal equations are set up about the centres of the scans.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Optional, Union

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.sparse import bsr_matrix, csr_matrix

from ..settings import Model
from ..surfaces.tie import Tie
from .gauss_newton import iterated
from .settings import AdjustmentSettings, OutlierTestSettings
from .similarity import Pose, moved_pose, parameter_design
from .statistical_tests import detectable_biases, normalized_residuals
from .target_covariances import in_control_frame

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
    covariances : ndarray, shape (k, 3, 3), or None
        Of the targets, in the scan; nan where unknown.
    held : bool
        Whether the pose is fixed, not unknown.
    """

    targets: np.ndarray
    points: np.ndarray
    pose: Pose
    covariances: Optional[np.ndarray] = None
    held: bool = False


@dataclass(frozen=True)
class Residuals:
    """Observations of one kind after the adjustment.

    Attributes
    ----------
    residuals : ndarray, shape (k, 3)
        v, metres.
    redundancy : ndarray, shape (k, 3)
        Redundancy numbers r, the diagonal of Qvv P: 0..1, of correlated coordinates about so.
    normalized : ndarray, shape (k, 3)
        Baarda's w, P v over the roots of the diagonal of P Qvv P; v / (sigma sqrt(r)) of coordinates that are
        not correlated. nan where nothing checks a coordinate.
    detectable : ndarray, shape (k, 3)
        Minimal detectable bias, delta0 over the same roots, metres; nan where nothing checks a coordinate.
    squares : ndarray, shape (k,)
        v'Pv of each point.
    """

    residuals: np.ndarray
    redundancy: np.ndarray
    normalized: np.ndarray
    detectable: np.ndarray
    squares: np.ndarray


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
        v'Pv of targets and surveyed points. That of surfaces has no place in it: their standard deviations
        come from their own scatter.
    redundancy : float
        n - u; with surfaces, the sum of the redundancy numbers of targets and surveyed points.
    """

    poses: tuple[Pose, ...]
    pose_cofactors: tuple[np.ndarray, ...]
    points: np.ndarray
    point_covariances: np.ndarray
    targets: tuple[Residuals, ...]
    control: Residuals
    sum_of_squares: float
    redundancy: float


def adjust(
    sightings: Sequence[Sighting],
    points: np.ndarray,
    surveyed: np.ndarray,
    model: Model,
    sigma: float,
    control_sigma: Union[float, np.ndarray] = 0.0,
    settings: AdjustmentSettings = AdjustmentSettings(),
    ties: Sequence[Tie] = (),
) -> Block:
    """Adjust scans to their control points, and to each other by surfaces.

    Parameters
    ----------
    sightings : sequence of Sighting
        Each with enough well placed targets for the model, or tied to others, or held.
    points : ndarray, shape (p, 3)
        Control points; start values of those that were not surveyed, which at least two scans see.
    surveyed : ndarray of bool, shape (p,)
    model : Model
    sigma : float
        A priori standard deviation of the coordinates of targets without a covariance, metres.
    control_sigma : float or ndarray, shape (p,)
        The same of surveyed points; 0 where held fixed.
    settings : AdjustmentSettings
    ties : sequence of Tie
        Between scans, by their numbers among the sightings.
    """
    sigmas = np.broadcast_to(control_sigma, len(points))
    loose = (sigmas > 0) | ~surveyed
    seen = np.zeros(len(points), bool)
    seen[np.concatenate([item.points for item in sightings])] = True
    system = _System(sightings, points, surveyed & seen, loose & seen, model, sigma, sigmas, ties)
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
        ties: Sequence[Tie],
    ) -> None:
        self.sightings, self.given, self.model, self.ties = sightings, points, model, ties
        self.loose = np.flatnonzero(loose)
        self.observed = np.flatnonzero(surveyed & loose)
        self.held = np.array([item.held for item in sightings], bool)
        self.pose_unknowns = model.unknowns * len(sightings)
        self.first = np.full(len(points), -1)
        self.first[self.loose] = self.pose_unknowns + 3 * np.arange(len(self.loose))
        self.unknowns = self.pose_unknowns + 3 * len(self.loose)
        self.sigma = sigma
        self.of_control = np.eye(3) * control_sigmas[self.observed, None, None] ** 2

    def solved(self, settings: AdjustmentSettings) -> Block:
        start = [item.pose for item in self.sightings], self.given
        poses, points = iterated(self._advanced, start, settings.iteration)
        return self._block(poses, points, settings.tests)

    def _advanced(self, unknowns: Unknowns) -> tuple[Unknowns, np.ndarray]:
        poses, points = unknowns
        self.columns, self.values = self._design(poses)
        self.weights = self._weights(poses)
        step, self.cofactors = self._step(self._residuals(poses, points), poses)
        shares = step[: self.pose_unknowns].reshape(len(poses), -1)
        points = points.copy()
        points[self.loose] += step[self.pose_unknowns :].reshape(-1, 3)
        return ([moved_pose(pose, share, self.model) for pose, share in zip(poses, shares)], points), step

    def _weights(self, poses: list[Pose]) -> np.ndarray:
        """Return the blocks of P, shape (n / 3, 3, 3): one for each target and each surveyed point."""
        of_targets = [
            in_control_frame(item.covariances, len(item.points), pose, self.sigma)
            for item, pose in zip(self.sightings, poses)
        ]
        return np.linalg.inv(np.concatenate([*of_targets, self.of_control]))

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

    def _step(self, residuals: np.ndarray, poses: list[Pose]) -> tuple[np.ndarray, np.ndarray]:
        """Return x = (A'PA)^-1 A'Pl and the inverse, where l = -v (paper, eq. 3)."""
        columns, values = self.columns, self.values
        rows = np.repeat(np.arange(len(columns)), columns.shape[1])
        shape = (len(columns), self.unknowns)
        design = csr_matrix((values.ravel(), (rows, np.maximum(columns, 0).ravel())), shape)
        count = len(self.weights)
        blocks = (self.weights, np.arange(count), np.arange(count + 1))
        weighted = bsr_matrix(blocks, shape=(3 * count, 3 * count)) @ design
        normal, right = (design.T @ weighted).toarray(), weighted.T @ -residuals
        width = self.model.unknowns
        for tie in self.ties:
            one, other = tie.scans
            share = tie.equations(poses[one], poses[other], self.model)
            rows = np.r_[np.arange(width) + one * width, np.arange(width) + other * width]
            normal[np.ix_(rows, rows)] += share.normal
            right[rows] += share.right
        # The others have no cofactors, and do not move.
        free = np.flatnonzero(~np.r_[np.repeat(self.held, width), np.zeros(3 * len(self.loose), bool)])
        cofactors = np.zeros_like(normal)
        cofactors[np.ix_(free, free)] = _inverse(normal[np.ix_(free, free)])
        return cofactors @ right, cofactors

    def _block(self, poses: list[Pose], points: np.ndarray, tests: OutlierTestSettings) -> Block:
        cofactors, width = self.cofactors, self.model.unknowns
        residuals = self._residuals(poses, points).reshape(-1, 3)
        ends = np.cumsum([len(item.points) for item in self.sightings])
        parts = zip(*(np.split(each, ends) for each in (residuals, self.weights, self._adjusted())))
        kinds = [_tested(v, weights, adjusted, tests) for v, weights, adjusted in parts]
        numbers = float(sum(kind.redundancy.sum() for kind in kinds))
        return Block(
            poses=tuple(poses),
            pose_cofactors=tuple(
                cofactors[i : i + width, i : i + width] for i in range(0, self.pose_unknowns, width)
            ),
            points=points,
            point_covariances=self._point_covariances(cofactors),
            targets=tuple(kinds[:-1]),
            control=self._of_all_points(kinds[-1]),
            sum_of_squares=float(sum(kind.squares.sum() for kind in kinds)),
            redundancy=numbers if self.ties else residuals.size - self.unknowns,
        )

    def _adjusted(self) -> np.ndarray:
        """Return the covariances of adjusted observations, the blocks of A N^-1 A', shape (n / 3, 3, 3)."""
        shape = (len(self.weights), 3, self.values.shape[1])
        values = self.values.reshape(shape)
        columns = np.maximum(self.columns, 0).reshape(shape)
        among = self.cofactors[columns[:, :, None, :, None], columns[:, None, :, None, :]]
        return np.asarray(np.einsum("kai,kabij,kbj->kab", values, among, values))

    def _point_covariances(self, cofactors: np.ndarray) -> np.ndarray:
        covariances = np.zeros((len(self.given), 3, 3))
        columns = self.first[self.loose][:, None] + np.arange(3)
        covariances[self.loose] = cofactors[columns[:, :, None], columns[:, None, :]]
        return covariances

    def _of_all_points(self, observed: Residuals) -> Residuals:
        """Return the residuals of the surveyed coordinates in the rows of all points."""
        spread = []
        for field in fields(Residuals):
            values = getattr(observed, field.name)
            spread.append(np.full((len(self.given), *values.shape[1:]), np.nan))
            spread[-1][self.observed] = values
        return Residuals(*spread)


def _inverse(normal: np.ndarray) -> np.ndarray:
    # Shifts and angles differ in size by the extent of a scan; so scaled, they do not.
    if not len(normal):
        return normal
    sizes = np.sqrt(np.diag(normal))
    if not (sizes > 0).all():
        raise np.linalg.LinAlgError("a scan is held by nothing")
    outer = np.outer(sizes, sizes)
    return np.asarray(cho_solve(cho_factor(normal / outer), np.eye(len(normal))) / outer)


def _tested(
    residuals: np.ndarray, weights: np.ndarray, adjusted: np.ndarray, tests: OutlierTestSettings
) -> Residuals:
    """Return the statistics of observations with the blocks `weights` of P, shape (k, 3, 3).

    References
    ----------
    Baarda (1968): A testing procedure for use in geodetic networks. With v = m R B + T - A, Qvv is
    P^-1 - A N^-1 A'.
    """
    of_residuals = weights - weights @ adjusted @ weights
    redundancy = 1.0 - np.einsum("kab,kba->ka", adjusted, weights)
    weighted = np.einsum("kab,kb->ka", weights, residuals)
    cofactors, own = (np.diagonal(each, axis1=1, axis2=2) for each in (of_residuals, weights))
    return Residuals(
        residuals=residuals,
        redundancy=np.where(np.abs(redundancy) < tests.least_redundancy, 0.0, redundancy),
        normalized=normalized_residuals(weighted, cofactors, own, tests),
        detectable=detectable_biases(cofactors, own, tests),
        squares=np.einsum("ka,ka->k", residuals, weighted),
    )
