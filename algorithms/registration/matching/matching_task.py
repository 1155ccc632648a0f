"""What has to be matched: the targets of one scan, the control points, and which of them may match."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ...progress import Progress
from ..adjustment.control_network import ControlNetwork
from ..lists.point_list import PointList
from ..settings import Model, Settings
from .control_points import ControlPoints
from .search_space import search_space
from .solution import Solutions
from .solution_search import find_solutions


@dataclass(frozen=True)
class MatchingTask:
    """A scan, the control points, and which of its targets may be which of them.

    Attributes
    ----------
    scan : PointList
        Near the origin.
    network : ControlNetwork
    control : ControlPoints
        Those of the network.
    settings : Settings
    allowed : ndarray of bool, shape (n, N)
        Points with which a target may match.
    progress : Progress
        Of every search.
    """

    scan: PointList
    network: ControlNetwork
    control: ControlPoints
    settings: Settings
    allowed: np.ndarray
    progress: Progress

    @property
    def named(self) -> bool:
        """Whether names identify the control point of a target."""
        return self.settings.named

    @property
    def free_scale(self) -> bool:
        """Whether the scale may be any."""
        return self.settings.free_scale

    def within(self, start: float, stop: float) -> "MatchingTask":
        """Return the task with a part of its progress."""
        return replace(self, progress=self.progress.part(start, stop))

    def solutions(
        self, targets: np.ndarray, model: Model, least: int, control: Optional[ControlPoints] = None
    ) -> Solutions:
        """Return the best solutions for the targets of the scan, or for changed ones.

        Parameters
        ----------
        targets : ndarray, shape (n, 3)
        model : Model
        least : int
            Smallest number of targets of a solution.
        control : ControlPoints, optional
            Instead of those of the task.
        """
        space = search_space(control or self.control, targets, model, self.allowed, self.settings)
        return find_solutions(space, least, self.progress)


def matching_task(
    scan: PointList, network: ControlNetwork, settings: Settings, progress: Progress = Progress()
) -> MatchingTask:
    """Return the task of matching a scan with the points of a network."""
    near_one = settings.model.scaled and not settings.free_scale
    scale_error = settings.matches.tolerances.scale_error if near_one else 0.0
    control = ControlPoints.of_network(network, settings, scale_error)
    if settings.named:
        allowed = np.array([[name == label for label in network.labels] for name in scan.names])
    else:
        allowed = np.broadcast_to(~coincident(control), (len(scan.names), len(network.points)))
    return MatchingTask(scan, network, control, settings, allowed, progress)


def coincident(control: ControlPoints) -> np.ndarray:
    """Return which control points are too close to an earlier one to distinguish them; bool, shape (N,)."""
    return np.triu(control.distances <= control.limits, 1).any(axis=0)
