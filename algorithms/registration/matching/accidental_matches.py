"""The number of accidental matches that are expected to be as good as the one that was found."""

from math import lgamma, log, pi

import numpy as np
from scipy.spatial.distance import pdist

from ..settings import Model
from .control_points import ControlPoints
from .settings import AccidentSettings


class AccidentalMatches:
    """Expected numbers of accidental matches of targets with control points.

    Among C(n, k) N! / (N - k)! ways to lay k of n targets on N points, each redundant coordinate agrees by
    accident with the probability that a distance does. A match that fits better than the limits ask is
    rarer by the volume of its residuals over that of the limits.

    Parameters
    ----------
    control : ControlPoints
    targets : ndarray, shape (n, 3)
    model : Model
    free_scale : bool
        Whether the scale may be any.
    settings : AccidentSettings
    """

    def __init__(
        self,
        control: ControlPoints,
        targets: np.ndarray,
        model: Model,
        free_scale: bool = False,
        settings: AccidentSettings = AccidentSettings(),
    ) -> None:
        self._settings = settings
        self._control, self._targets, self._levelled = control, targets, model.levelled
        self._given = (4 if model.levelled else 6) + free_scale
        # Where the scale may be any, only ratios count, as if the targets were among the control points.
        self._distance = self._agreement(
            pdist(control.points), pdist(control.points if free_scale else targets)
        )
        self._height = 1.0
        if model.levelled:
            self._height = self._agreement(pdist(control.points[:, 2:]), pdist(targets[:, 2:]))

    def _agreement(self, of_points: np.ndarray, of_targets: np.ndarray) -> float:
        """Return the probability that a distance of targets agrees with one of points."""
        if not len(of_points) or not len(of_targets):
            return 1.0
        lengths = np.sort(of_points)
        limit = float(np.median(self._control.limits)) + self._control.scale_error * float(lengths.mean())
        window = max(limit, self._settings.window_share * float(lengths[-1]))
        near = np.searchsorted(lengths, of_targets + window) - np.searchsorted(lengths, of_targets - window)
        smooth = float(np.mean(near + 0.5)) / (len(lengths) + 1) * limit / window
        return min(smooth, 1.0)

    def repetition(self, points: np.ndarray) -> float:
        """Return the probability that a distance among some control points occurs elsewhere.

        In a regular layout it is much more likely than in a random one.

        Parameters
        ----------
        points : ndarray of int, shape (k,)
        """
        lengths = np.sort(pdist(self._control.points))
        limit = float(np.median(self._control.limits))
        asked = pdist(self._control.points[points])
        near = np.searchsorted(lengths, asked + limit) - np.searchsorted(lengths, asked - limit)
        return float(np.mean(np.maximum(near - 1, 0))) / len(lengths)

    def expected(self, matched: int, misfit: float, repetition: float = 0.0) -> float:
        """Return the expected number of accidental matches of `matched` targets.

        Parameters
        ----------
        matched : int
            k.
        misfit : float
            Sum of the squared residuals over the variance of a coordinate.
        repetition : float
            Of the distances between the matched points.
        """
        distance = max(self._distance, repetition)
        n, points, redundancy = len(self._targets), len(self._control.points), 3 * matched - self._given
        ways = lgamma(n + 1) - lgamma(matched + 1) - lgamma(n - matched + 1)
        ways += lgamma(points + 1) - lgamma(points - matched + 1)
        rarity = redundancy * log(distance)
        if self._levelled:
            rarity += log(self._height / distance)
        radius = max(misfit, 1e-12) ** 0.5 / (2 * self._control.factor)
        volume = redundancy / 2 * log(pi) + redundancy * log(radius) - lgamma(redundancy / 2 + 1)
        return float(np.exp(min(ways + rarity + min(volume, 0.0), 700.0)))

    def may_explain(self, matched: int, misfit: float, repetition: float = 0.0) -> bool:
        """Return whether a match of `matched` targets may be accidental."""
        of_all = matched == len(self._targets)
        most = self._settings.most_expected_of_all if of_all else self._settings.most_expected
        return self.expected(matched, misfit, repetition) > most

    def least(self, smallest: int) -> int:
        """Return the smallest number of targets, from `smallest`, whose match cannot be accidental.

        If every number is too small, return one more than there are targets or points.
        """
        most = min(len(self._targets), len(self._control.points))
        for matched in range(smallest, most + 1):
            redundancy = 3 * matched - self._given
            if redundancy > 0 and not self.may_explain(matched, redundancy):
                return matched
        return most + 1
