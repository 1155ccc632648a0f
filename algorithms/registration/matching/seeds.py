"""Seeds: the smallest sets of matches that fix a pose, target by target."""

from collections.abc import Iterator
from typing import Optional

import numpy as np

from ...progress import Progress
from ..adjustment.similarity import Pose
from .matching_matrix import MatchingMatrix, seeds
from .pose_uncertainty import leverage, scale_shift
from .search_space import SearchSpace
from .similar_triangles import SimilarTriangles, named_seeds


def seed_sets(
    space: SearchSpace, matrix: Optional[MatchingMatrix], progress: Progress = Progress()
) -> Iterator[tuple[int, np.ndarray]]:
    """Yield, target by target, the sets of nodes that fix a pose and end with it, in parts.

    Parameters
    ----------
    space : SearchSpace
    matrix : MatchingMatrix or None
        None if the scale is unknown.
    progress : Progress
    """
    if matrix is None:
        yield from _seeds_of_any_scale(space, progress)
        return
    for last in range(space.size - 1, matrix.targets):
        for nodes in seeds(matrix, last, space.model):
            yield last, nodes


def _seeds_of_any_scale(space: SearchSpace, progress: Progress) -> Iterator[tuple[int, np.ndarray]]:
    named = space.settings.named
    triangles = None if named else SimilarTriangles(space.control, space.settings.matches.triangles, progress)
    for last in range(space.size - 1, len(space.targets)):
        if triangles is None:
            yield last, named_seeds(space.control, space.targets, last, space.allowed, space.size)
        else:
            for nodes in triangles.seeds(space.targets, last, len(space.control.points)):
                yield last, nodes


def are_wide(space: SearchSpace, corners: np.ndarray) -> np.ndarray:
    """Return which seeds are wide enough to fix a pose.

    Parameters
    ----------
    space : SearchSpace
    corners : ndarray, shape (s, 2 or 3, 3)

    Returns
    -------
    ndarray of bool, shape (s,)
    """
    if space.size == 2:
        return np.linalg.norm(np.diff(corners[..., :2], axis=1)[:, 0], axis=1) > space.width
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    doubled = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return doubled > space.width * sides.max(axis=1, initial=0.0)


def matched_at_most(space: SearchSpace, poses: Pose, mine: np.ndarray, theirs: np.ndarray) -> np.ndarray:
    """Return how many targets the poses of seeds lay on control points, at most.

    Parameters
    ----------
    space : SearchSpace
    poses : Pose
    mine, theirs : ndarray of int, shape (s, 2 or 3)
        The targets of the seeds, and their points.
    """
    if not len(mine):
        return np.zeros(0, int)
    reach = space.control.reach(leverage(poses, space.targets, mine, space.model), theirs)
    reach = reach + scale_shift(poses, space.targets, space.control.scale_error, len(mine))
    placed = poses.apply(np.broadcast_to(space.targets, (len(mine), *space.targets.shape)))
    distances, _ = space.control.tree.query(placed, distance_upper_bound=float(reach.max()))
    return (distances <= reach).sum(axis=1)
