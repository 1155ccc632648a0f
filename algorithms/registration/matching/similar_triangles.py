"""Seeds when the scale is unknown: triangles of the same shape, by distance ratios (the paper's outlook)."""

from collections.abc import Iterator
from itertools import permutations

import numpy as np
from scipy.spatial import cKDTree

from ...progress import Progress
from .control_points import ControlPoints
from .settings import TriangleSettings

FARTHEST = 10.0
"""Ratio of a side to the longest one, which is 1 at most, that no search around a shape reaches."""


class SimilarTriangles:
    """The triangles of the control points, for queries of those with the shape of three targets.

    Parameters
    ----------
    control : ControlPoints
    settings : TriangleSettings
    progress : Progress
        Asked whether to stop while the triangles are collected.
    """

    def __init__(
        self,
        control: ControlPoints,
        settings: TriangleSettings = TriangleSettings(),
        progress: Progress = Progress(),
    ) -> None:
        self._settings = settings
        limit = float(control.limits.max())
        parts = []
        for first in range(len(control.points) - 2):
            progress.check()
            parts.append(_shapes(control.points, first, limit))
        corners, ratios, octaves = (np.concatenate(part) for part in zip(*parts))
        # The shape of a long triangle is known better than that of a short one: one tree for each doubling.
        self._trees = []
        for octave in np.unique(octaves[octaves >= settings.least_octave]):
            progress.check()
            rows = np.flatnonzero(octaves == octave)
            tree = cKDTree(ratios[rows], balanced_tree=False, compact_nodes=False)
            self._trees.append((corners[rows], tree, 2.0 ** (1 - octave)))

    def seeds(self, targets: np.ndarray, last: int, count: int) -> Iterator[np.ndarray]:
        """Yield sets of three nodes, shape (s, 3), that end with `last`, as `matching_matrix.seeds` does."""
        first, second = np.triu_indices(last, 1)
        triples = np.column_stack([first, second, np.full(len(first), last)])
        size = self._settings.batch_size
        for start in range(0, len(triples), size):
            for order in permutations(range(3)):
                corners = triples[start : start + size, order]
                sides = _sides(targets[corners])
                # Targets in one place have no longest side, and are far from all shapes.
                with np.errstate(over="ignore"):
                    ratios = sides[:, :2] / np.maximum(sides[:, 2:], np.finfo(float).tiny)
                ratios = np.minimum(ratios, FARTHEST)
                for triangles, tree, radius in self._trees:
                    # Sides whose lengths are equal within their uncertainty may be sorted either way.
                    near = tree.query_ball_point(ratios, radius)
                    numbers = [len(each) for each in near]
                    mine = np.repeat(corners, numbers, axis=0)
                    yield mine * count + triangles[np.concatenate([*near, []]).astype(int)]


def _shapes(points: np.ndarray, first: int, limit: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return corners, ratios of sides and octaves of the longest sides of the triangles of a first corner.

    The sides are sorted by length, and the corners are opposite to them.
    """
    others = np.array(np.triu_indices(len(points) - first - 1, 1)).T + first + 1
    corners = np.column_stack([np.full(len(others), first), others])
    sides = _sides(points[corners])
    order = np.argsort(sides, axis=1)
    sides = np.maximum(np.take_along_axis(sides, order, axis=1), np.finfo(float).tiny)
    longest = np.maximum(sides[:, 2:], limit)
    octaves = np.floor(np.log2(longest[:, 0] / limit)).astype(int)
    return np.take_along_axis(corners, order, axis=1), sides[:, :2] / longest, octaves


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
