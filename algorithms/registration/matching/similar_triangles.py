"""Seeds when the scale is unknown: triangles of the same shape, by distance ratios (the paper's outlook)."""

from itertools import permutations

import numpy as np
from scipy.spatial import cKDTree

from .control_points import ControlPoints
from .settings import TriangleSettings


class SimilarTriangles:
    """The triangles of the control points, for queries of those with the shape of three targets.

    Parameters
    ----------
    control : ControlPoints
    settings : TriangleSettings
    """

    def __init__(self, control: ControlPoints, settings: TriangleSettings = TriangleSettings()) -> None:
        limit = float(control.limits.max())
        corners = np.array(np.meshgrid(*[np.arange(len(control.points))] * 3, indexing="ij")).reshape(3, -1).T
        corners = corners[(corners[:, 0] < corners[:, 1]) & (corners[:, 1] < corners[:, 2])]
        sides = _sides(control.points[corners])
        order = np.argsort(sides, axis=1)
        self._corners = np.take_along_axis(corners, order, axis=1)
        sides = np.take_along_axis(sides, order, axis=1)
        ratios = sides[:, :2] / np.maximum(sides[:, 2:], limit)
        # The shape of a long triangle is known better than that of a short one: one tree for each doubling.
        octaves = np.floor(np.log2(np.maximum(sides[:, 2], limit) / limit)).astype(int)
        self._trees = []
        for octave in np.unique(octaves[octaves >= settings.least_octave]):
            rows = np.flatnonzero(octaves == octave)
            self._trees.append((rows, cKDTree(ratios[rows]), 2.0 ** (1 - octave)))

    def seeds(self, targets: np.ndarray, last: int, count: int) -> np.ndarray:
        """Return sets of three nodes, shape (s, 3), that end with `last`, as `matching_matrix.seeds` does."""
        first, second = np.triu_indices(last, 1)
        triples = np.column_stack([first, second, np.full(len(first), last)])
        found = [np.empty((0, 3), np.int64)]
        for order in permutations(range(3)):
            corners = triples[:, order]
            sides = _sides(targets[corners])
            ratios = sides[:, :2] / np.maximum(sides[:, 2:], np.finfo(float).tiny)
            for rows, tree, radius in self._trees:
                # Sides whose lengths are equal within their uncertainty may be sorted either way.
                near = tree.query_ball_point(ratios, radius)
                numbers = [len(each) for each in near]
                mine = np.repeat(corners, numbers, axis=0)
                theirs = self._corners[rows[np.concatenate([*near, []]).astype(int)]]
                found.append(mine * count + theirs)
        return np.concatenate(found)


def named_seeds(
    control: ControlPoints, targets: np.ndarray, last: int, allowed: np.ndarray, size: int
) -> np.ndarray:
    """Return sets of `size` nodes of the same shape that end with `last`, if targets are matched by names.

    Parameters
    ----------
    control : ControlPoints
    targets : ndarray, shape (n, 3)
    last : int
    allowed : ndarray of bool, shape (n, N)
        At most one point for each target.
    size : int
        2 or 3; two are always of the same shape.
    """
    named = np.flatnonzero(allowed[: last + 1].any(axis=1))
    if last not in named or len(named) < size:
        return np.empty((0, size), np.int64)
    points = allowed.argmax(axis=1)
    earlier = named[:-1]
    if size == 2:
        mine = np.column_stack([earlier, np.full(len(earlier), last)])
        return mine * allowed.shape[1] + points[mine]
    first, second = np.triu_indices(len(earlier), 1)
    mine = np.column_stack([earlier[first], earlier[second], np.full(len(first), last)])
    of_targets, of_points = _sides(targets[mine]), _sides(control.points[points[mine]])
    longest = np.maximum(of_points.max(axis=1), np.finfo(float).tiny)
    scale = longest / np.maximum(of_targets.max(axis=1), np.finfo(float).tiny)
    alike = np.abs(of_targets * scale[:, None] - of_points).max(axis=1) <= 2 * control.limits.max()
    return (mine * allowed.shape[1] + points[mine])[alike]


def _sides(corners: np.ndarray) -> np.ndarray:
    """Return the sides opposite to each corner, shape (t, 3), of triangles of shape (t, 3, 3)."""
    return np.linalg.norm(np.roll(corners, -1, axis=1) - np.roll(corners, -2, axis=1), axis=2)
