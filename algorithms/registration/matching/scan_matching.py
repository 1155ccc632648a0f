"""Which control points the targets of one scan are, or why that cannot be decided."""

from dataclasses import dataclass
from typing import Optional, Union

import numpy as np

from ..adjustment.control_network import ControlNetwork
from ..adjustment.scan_adjustment import fit_scan
from ..adjustment.target_layout import line_width
from ..lists.point_list import PointList
from ..settings import Model, Settings
from .accidental_matches import AccidentalMatches
from .diagnosis import accidental, explain_failure, mirrored_solution
from .match_warnings import match_warnings
from .matching_task import MatchingTask, matching_task
from .pose_uncertainty import rotation_std_deg
from .refusals import Refusal, ambiguous, nearly_on_a_line, refused_list, too_few
from .settings import DecisionSettings
from .solution import Solution

UNEXPLAINED = Refusal("no overlap", "")


@dataclass(frozen=True)
class ScanMatch:
    """Which point each target is.

    Attributes
    ----------
    solution : Solution
    chance : float or None
        Expected number of accidental matches; None if matched by names.
    warnings : tuple of str
    """

    solution: Solution
    chance: Optional[float]
    warnings: tuple[str, ...]


def match_scan(
    scan: PointList, network: ControlNetwork, settings: Settings, explain: bool = True
) -> Union[ScanMatch, Refusal]:
    """Match the targets of a scan with control points.

    Parameters
    ----------
    scan : PointList
        Near the origin.
    network : ControlNetwork
    settings : Settings
    explain : bool
        Whether to find out why nothing matches, which takes several searches.
    """
    task = matching_task(scan, network, settings)
    refusal = refused_list(task)
    if refusal:
        return refusal
    model, targets = settings.model, scan.xyz
    accidents = AccidentalMatches(task.control, targets, model, task.free_scale, settings.matches.accidents)
    least = model.least_targets
    if not task.named:
        least = max(least, accidents.least(least))
        if least > min(len(targets), len(network.points)):
            return too_few(task, accidents)
    solutions = task.solutions(targets, model, least)
    if not solutions:
        return Refusal(*explain_failure(task, least)) if explain else UNEXPLAINED
    return _decided(task, solutions, accidents)


def _decided(
    task: MatchingTask, solutions: list[Solution], accidents: AccidentalMatches
) -> Union[ScanMatch, Refusal]:
    """Return the best solution, unless it is mirrored, ambiguous, uncertain or accidental."""
    best, model, decision = solutions[0], task.settings.model, task.settings.matches.decision
    # A few targets in one plane fit though the list is mirrored.
    mirrored = task.in_one_plane(best) and mirrored_solution(task, best.matched + 1)
    if mirrored:
        return Refusal(*mirrored)
    rivals = _rivals(best, solutions[1:], model, decision)
    if rivals:
        return ambiguous(task, [best, *rivals])
    kept = _kept(task, best)
    uncertainty = rotation_std_deg(best.pose, task.scan.xyz[kept], model.levelled, task.control.sigma)
    if uncertainty > decision.most_rotation_std_deg:
        return nearly_on_a_line(task, uncertainty)
    if task.named:
        return ScanMatch(best, None, match_warnings(task, best))
    # An outlier may be a true match; where the fit is poor, it more probably is not.
    poor = _variance_factor(best, model) > decision.poor_sigma0**2
    evidence = len(kept) if poor else best.matched, best.misfit, accidents.repetition(best.labels[kept])
    expected = accidents.expected(*evidence)
    if accidents.may_explain(*evidence):
        return Refusal(*accidental(task, best, expected))
    return ScanMatch(best, expected, match_warnings(task, best))


def _rivals(
    best: Solution, others: list[Solution], model: Model, decision: DecisionSettings
) -> list[Solution]:
    """Return the solutions that are as good as the best."""
    factor = _variance_factor(best, model)
    limit = best.misfit + decision.most_squares * factor
    # Where SIGMA is too small, true targets do not match, and a wrong solution may match more.
    width = min(decision.reach_factor * factor**0.5, decision.most_reach_factor)
    return [
        item
        for item in others
        if item.contradicts(best, model.least_targets)
        and (item.misfit <= limit if item.matched == best.matched else item.support(width) >= best.matched)
    ]


def _kept(task: MatchingTask, solution: Solution) -> np.ndarray:
    """Return the rows of the matched targets that are not outliers."""
    rows = np.flatnonzero(solution.labels >= 0)
    points, targets = task.control.points[solution.labels[rows]], task.scan.xyz[rows]
    nothing = np.zeros((3 * len(rows), 3 * len(rows)))
    width = line_width(task.scan.xyz, task.settings)
    return rows[fit_scan(targets, points, nothing, task.settings, width).used]


def _variance_factor(solution: Solution, model: Model) -> float:
    return max(1.0, solution.misfit / max(3 * solution.matched - model.unknowns, 1))
