"""Whether another solution is about as likely as the best one."""

from math import inf, log

import numpy as np
from scipy.spatial.distance import cdist

from ..adjustment.similarity import fit_pose
from ..settings import Model
from .matching_task import MatchingTask
from .settings import DecisionSettings
from .solution import Solution, Solutions


def rivals_of_best(task: MatchingTask, solutions: Solutions) -> list[Solution]:
    """Return the solutions that fit as many targets as the best one, and about as well."""
    best, *others = solutions
    model, decision = task.settings.model, task.settings.matches.decision
    return [
        other
        for other in others
        if other.contradicts(best, model.least_targets)
        and as_likely(
            squares_of(task, other, best.matched), best.misfit, redundancy(best.matched, model), decision
        )
    ]


def as_likely(squares: float, least: float, redundant: int, settings: DecisionSettings) -> bool:
    """Return whether a solution is less than `most_odds` times less likely than the best one.

    SIGMA counts as an estimate from `sigma_redundancy` observations, so that the likelihood of a sum of
    squares is that of Student's t: proportional to (f + v'Pv) ^ -((f + r) / 2).

    Parameters
    ----------
    squares, least : float
        v'Pv of the solution and of the best one, both of as many targets.
    redundant : int
        r, the redundancy of both.
    settings : DecisionSettings
    """
    known = settings.sigma_redundancy
    odds = (known + redundant) / 2 * log((known + min(squares, 1e300)) / (known + least))
    return odds <= log(settings.most_odds)


def squares_of(task: MatchingTask, solution: Solution, count: int, mirror: np.ndarray = np.eye(3)) -> float:
    """Return v'Pv of a solution of `count` targets: where it matches fewer, the nearest others join it.

    So solutions of different size are compared with the same number of targets. If too few points are left,
    the sum is infinite.

    Parameters
    ----------
    task : MatchingTask
    solution : Solution
    count : int
    mirror : ndarray, shape (3, 3)
        By which the targets were multiplied before they were matched.
    """
    if solution.matched >= count:
        return solution.misfit
    targets, points, labels = task.scan.xyz @ mirror, task.control.points, solution.labels.copy()
    gaps = np.where(task.allowed, cdist(solution.pose.apply(targets), points), inf)
    gaps[labels >= 0] = inf
    gaps[:, labels[labels >= 0]] = inf
    for _ in range(count - solution.matched):
        row, point = np.unravel_index(gaps.argmin(), gaps.shape)
        if gaps[row, point] == inf:
            return inf
        labels[row] = point
        gaps[row] = gaps[:, point] = inf
    rows = np.flatnonzero(labels >= 0)
    matched = points[labels[rows]]
    residuals = fit_pose(matched, targets[rows], task.settings.model).apply(targets[rows]) - matched
    return float((residuals**2).sum()) / task.control.sigma**2


def redundancy(matched: int, model: Model) -> int:
    """Return the redundancy of a solution; at least 0."""
    return max(3 * matched - model.unknowns, 0)
