"""A way to lay targets on control points, and the best of several."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..adjustment.similarity import Pose
from .settings import SearchSettings


@dataclass(frozen=True)
class Solution:
    """A way to lay targets on control points.

    Attributes
    ----------
    labels : ndarray of int, shape (n,)
        The point of each target, -1 without one.
    pose : Pose
    misfit : float
        Sum of the squared residuals over the variance of a coordinate.
    gaps : ndarray, shape (n,)
        How far each target without a point lies from the nearest free one, over its reach.
    """

    labels: np.ndarray
    pose: Pose
    misfit: float
    gaps: np.ndarray

    @property
    def matched(self) -> int:
        """The number k of targets with a point."""
        return int((self.labels >= 0).sum())

    def support(self, width: float) -> int:
        """Return the number of targets that lie on points if these reach `width` times as far."""
        return self.matched + int((self.gaps <= width).sum())

    def contradicts(self, other: "Solution", least: int) -> bool:
        """Return whether another solution is not the same one with more or fewer targets.

        Parameters
        ----------
        other : Solution
        least : int
            The number of common targets that makes the poses the same.
        """
        both = (self.labels >= 0) & (other.labels >= 0)
        equal = self.labels[both] == other.labels[both]
        return not equal.all() or int(equal.sum()) < least


@dataclass(frozen=True)
class Solutions(Sequence[Solution]):
    """What a search found, the best first.

    Attributes
    ----------
    items : tuple of Solution
    complete : bool
        False if the search was ended before all seeds were tried.
    """

    items: tuple[Solution, ...] = ()
    complete: bool = True

    def __getitem__(self, index: Any) -> Any:
        return self.items[index]

    def __len__(self) -> int:
        return len(self.items)


def enough(solutions: list[Solution], least: int, settings: SearchSettings) -> int:
    """Return how many targets a solution must match to be worth keeping beside others.

    Parameters
    ----------
    solutions : list of Solution
        Those that were found.
    least : int
        If nothing was found yet.
    settings : SearchSettings
    """
    best = max((item.matched for item in solutions), default=least)
    equal = sum(item.matched == best for item in solutions)
    if equal >= settings.most_solutions:
        return best + 1
    if len(solutions) - equal >= settings.most_solutions:
        return best
    return max(best - settings.slack_targets, least)


def with_solution(
    solution: Solution, solutions: list[Solution], least: int, size: int, settings: SearchSettings
) -> list[Solution]:
    """Return the solutions with a new one, if it matches enough, without those that it supersedes.

    Parameters
    ----------
    solution : Solution
    solutions : list of Solution
    least : int
        Smallest number of targets of a solution.
    size : int
        Number of targets that fix a pose.
    settings : SearchSettings
    """
    if solution.matched < enough(solutions, least, settings):
        return solutions
    same = [item for item in solutions if not solution.contradicts(item, size)]
    if any(item.matched >= solution.matched for item in same):
        return solutions
    kept = [item for item in solutions if not any(item is other for other in same)] + [solution]
    best = max(item.matched for item in kept)
    return [item for item in kept if item.matched >= best - settings.slack_targets]
