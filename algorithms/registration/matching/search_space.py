"""The targets and the control points that a search matches."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.distance import cdist

from ...progress import Progress
from ..adjustment.target_layout import spread
from ..settings import Model, Settings
from .control_points import ControlPoints
from .matching_matrix import MatchingMatrix, matching_matrix, pruned

LINES = 2000
"""Lines through two targets that are compared with all targets at once; their arrays fit into the cache."""


@dataclass(frozen=True)
class SearchSpace:
    """Targets, control points, and which of them may match.

    Attributes
    ----------
    control : ControlPoints
    targets : ndarray, shape (n, 3)
        Near the origin, in the order of the search.
    model : Model
        That the solutions have; in a diagnosis not the one of the settings.
    allowed : ndarray of bool, shape (n, N)
        Points with which a target may match; at most one for each target if matched by names.
    settings : Settings
    order : ndarray of int, shape (n,)
        Rows of the targets in the order of the list.
    width : float
        How far from a line, in the scan, the corner of a triangle must be to be a seed.
    """

    control: ControlPoints
    targets: np.ndarray
    model: Model
    allowed: np.ndarray
    settings: Settings
    order: np.ndarray
    width: float

    @property
    def size(self) -> int:
        """The number of targets of a seed."""
        return self.model.least_targets

    @property
    def seed_model(self) -> Model:
        """The model of the pose of a seed.

        Its scale is 1 if the scale of the scan is near 1, because three targets hardly determine it.
        """
        if self.settings.free_scale:
            return self.model
        return Model.LEVELLED if self.model.levelled else Model.RIGID

    def matrix(self, least: int, progress: Progress = Progress()) -> MatchingMatrix:
        """Return the matching matrix, without nodes that fit no solution of `least` targets."""
        search = self.settings.matches.search
        levelled = self.model.levelled
        matrix = matching_matrix(self.control, self.targets, self.allowed, levelled, search, progress)
        # The degrees of nodes are not known unless all targets are there.
        whole = matrix.targets == len(self.targets)
        return pruned(matrix, len(self.targets), least, progress) if whole else matrix

    def reordered(self, matrix: MatchingMatrix) -> "SearchSpace":
        """Return the space with the targets first that have few edges in the matching matrix.

        Their seeds are tried quickly, and a solution that they lead to ends the search.
        """
        nodes = np.r_[matrix.starts, matrix.ends]
        edges = np.bincount(nodes // len(self.control.points), minlength=len(self.targets))
        order = np.argsort(edges, kind="stable")
        return replace(self, order=order, targets=self.targets[order], allowed=self.allowed[order])

    def longest_line(self, progress: Progress = Progress()) -> int:
        """Return the largest number of targets on a line, vertical if levelled; they fix no pose."""
        near = 2 * self.width
        if self.model.levelled:
            return int((cdist(self.targets[:, :2], self.targets[:, :2]) <= near).sum(axis=1).max())
        first, second = np.triu_indices(len(self.targets), 1)
        along = self.targets[second] - self.targets[first]
        along /= np.maximum(np.linalg.norm(along, axis=1), np.finfo(float).tiny)[:, None]
        longest = 1
        for rows in np.array_split(np.arange(len(first)), len(first) // LINES + 1):
            progress.check()
            arms = self.targets[None, :, :] - self.targets[first[rows]][:, None, :]
            square = (arms**2).sum(axis=2) - np.einsum("pnk,pk->pn", arms, along[rows]) ** 2
            longest = max(longest, int((square <= near**2).sum(axis=1).max(initial=1)))
        return longest


def search_space(
    control: ControlPoints, targets: np.ndarray, model: Model, allowed: np.ndarray, settings: Settings
) -> SearchSpace:
    """Return the space of a search, with the targets in the order of the list.

    Parameters
    ----------
    control, targets, model, allowed, settings
        See `SearchSpace`.
    """
    width = _seed_width(control, targets, model, settings)
    return SearchSpace(control, targets, model, allowed, settings, np.arange(len(targets)), width)


def _seed_width(control: ControlPoints, targets: np.ndarray, model: Model, settings: Settings) -> float:
    search = settings.matches.search
    if settings.free_scale:
        flat_share = settings.adjustment.layout.flat_share
        return search.width_factor * flat_share * float(np.ptp(targets, axis=0).max(initial=0.0))
    level = targets[:, :2] - targets[:, :2].mean(axis=0)
    widest = np.linalg.norm(level, axis=1).max() if model.levelled else spread(targets)[1]
    return min(search.width_factor * control.factor * control.sigma, search.width_share * float(widest))
