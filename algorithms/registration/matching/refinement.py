"""From a seed to a solution: targets are added, the surest first, and removed, until nothing changes."""

from typing import Optional

import numpy as np
from scipy.spatial.distance import cdist

from ...progress import Progress
from ..adjustment.similarity import Pose, fit_pose
from ..adjustment.target_layout import fixes_pose
from .pose_uncertainty import leverage, scale_shift
from .search_space import SearchSpace
from .solution import Solution


def refined(
    space: SearchSpace, mine: np.ndarray, theirs: np.ndarray, progress: Progress = Progress()
) -> Solution:
    """Return the solution that a seed leads to, in the order of the list.

    Parameters
    ----------
    space : SearchSpace
    mine, theirs : ndarray of int, shape (2 or 3,)
        The targets of the seed, and their points.
    progress : Progress
        Asked whether to stop, at every change.
    """
    labels = np.full(len(space.targets), -1)
    labels[mine] = theirs
    barred = np.zeros(labels.shape, bool)
    most = space.settings.matches.search.most_changes * len(labels)
    for change in range(most):
        progress.update(change / most)
        added = _added(space, labels, barred)
        removed = None if added else _removed(space, labels, progress)
        if added:
            labels[added[0]] = added[1]
        elif removed is not None:
            labels[removed], barred[removed] = -1, True
        else:
            break
    used = np.flatnonzero(labels >= 0)
    in_order, gaps = np.full(len(labels), -1), np.full(len(labels), np.inf)
    in_order[space.order] = labels
    gaps[space.order] = _free_gaps(space, labels).min(axis=1)
    return Solution(in_order, _fitted(space, labels, used), _misfit(space, labels, used), gaps)


def _added(space: SearchSpace, labels: np.ndarray, barred: np.ndarray) -> Optional[tuple[int, int]]:
    """Return the free target that lies closest to a free point, and the point, if within reach."""
    gaps = _free_gaps(space, labels)
    gaps[barred] = np.inf
    row, point = np.unravel_index(gaps.argmin(), gaps.shape)
    return (int(row), int(point)) if gaps[row, point] <= 1.0 else None


def _removed(space: SearchSpace, labels: np.ndarray, progress: Progress) -> Optional[int]:
    """Return the target that is out of reach by the pose of the others, or causes a poor fit, if any."""
    used = np.flatnonzero(labels >= 0)
    gaps, misfits = np.zeros(len(used)), np.full(len(used), np.inf)
    for number, row in enumerate(used):
        progress.check()
        others = np.delete(used, number)
        if fixes_pose(space.targets[others], space.model, space.width / 2):
            gaps[number] = _gaps(space, labels, others)[row, labels[row]]
            misfits[number] = _misfit(space, labels, others)
    if gaps.max() > 1.0:
        return int(used[gaps.argmax()])
    factor = space.settings.matches.search.misfit_share * space.control.factor
    limit = factor**2 * (3 * len(used) - space.model.unknowns)
    poor = _misfit(space, labels, used) > limit and np.isfinite(misfits).any()
    return int(used[misfits.argmin()]) if poor else None


def _free_gaps(space: SearchSpace, labels: np.ndarray) -> np.ndarray:
    """Return the gaps between targets without a point and points without a target, infinite elsewhere."""
    gaps = _gaps(space, labels, np.flatnonzero(labels >= 0))
    gaps[labels >= 0] = np.inf
    gaps[:, labels[labels >= 0]] = np.inf
    return gaps


def _gaps(space: SearchSpace, labels: np.ndarray, used: np.ndarray) -> np.ndarray:
    """Return the distances of all targets from all points, over their reach, by the pose of those `used`."""
    pose = _fitted(space, labels, used)
    added = leverage(pose[None], space.targets, used[None], space.model)
    reach = space.control.reach(added, labels[used][None])[0]
    if len(used) <= space.size:
        reach = reach + scale_shift(pose[None], space.targets, space.control.scale_error, 1)[0]
    gaps = cdist(pose.apply(space.targets), space.control.points) / reach[:, None]
    return np.where(space.allowed, gaps, np.inf)


def _fitted(space: SearchSpace, labels: np.ndarray, used: np.ndarray) -> Pose:
    model = space.model if len(used) > space.size else space.seed_model
    return fit_pose(space.control.points[labels[used]], space.targets[used], model)


def _misfit(space: SearchSpace, labels: np.ndarray, used: np.ndarray) -> float:
    """Return the squared residuals of the targets `used`, over the variance of a coordinate."""
    placed = _fitted(space, labels, used).apply(space.targets[used])
    residuals = placed - space.control.points[labels[used]]
    return float((residuals**2).sum()) / space.control.sigma**2
