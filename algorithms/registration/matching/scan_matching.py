"""Which control points the targets of one scan are, or why that cannot be decided."""

from dataclasses import dataclass
from typing import Optional, Union

import numpy as np

from ...progress import Progress
from ..adjustment.control_network import ControlNetwork
from ..adjustment.scan_adjustment import fit_scan
from ..adjustment.target_layout import line_width
from ..lists.point_list import PointList
from ..settings import Model, Settings
from .accidental_matches import AccidentalMatches
from .diagnosis import accidental, explain_failure
from .match_warnings import incomplete_search, match_warnings
from .matching_task import MatchingTask, matching_task
from .mirror_images import mirror_images, mirrored_list
from .pose_uncertainty import rotation_std_deg
from .refusals import Refusal, ambiguous, nearly_on_a_line, refused_list, search_ended, too_few
from .rivals import redundancy, rivals_of_best
from .solution import Solution, Solutions

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
    scan: PointList,
    network: ControlNetwork,
    settings: Settings,
    explain: bool = True,
    progress: Progress = Progress(),
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
    progress : Progress

    Raises
    ------
    CancelledError
        If the caller asked to stop.
    """
    task = matching_task(scan, network, settings, progress)
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
    solutions = task.within(0.0, 0.5).solutions(targets, model, least)
    if not solutions and not solutions.complete:
        return search_ended(task)
    if not solutions:
        return Refusal(*explain_failure(task.within(0.5, 1.0), least)) if explain else UNEXPLAINED
    return _decided(task.within(0.5, 1.0), solutions, accidents)


def _decided(
    task: MatchingTask, solutions: Solutions, accidents: AccidentalMatches
) -> Union[ScanMatch, Refusal]:
    """Return the best solution, unless it is mirrored, ambiguous, uncertain or accidental."""
    best, model, decision = solutions[0], task.settings.model, task.settings.matches.decision
    images = mirror_images(task.within(0.0, 0.5), best.matched)
    for image in images:
        if image.replaces(task, best):
            return Refusal(*mirrored_list(task, image))
    rivals = rivals_of_best(task, solutions)
    if rivals:
        return ambiguous(task, [best, *rivals])
    kept = _kept(task, best)
    uncertainty = rotation_std_deg(best.pose, task.scan.xyz[kept], model.levelled, task.control.sigma)
    if uncertainty > decision.most_rotation_std_deg:
        return nearly_on_a_line(task, uncertainty)
    warnings = match_warnings(task, best, [image for image in images if image.rivals(task, best)])
    if task.named:
        return ScanMatch(best, None, warnings)
    # An outlier may be a true match; where the fit is poor, it more probably is not.
    poor = _variance_factor(best, model) > decision.poor_sigma0**2
    evidence = len(kept) if poor else best.matched, best.misfit, accidents.repetition(best.labels[kept])
    expected = accidents.expected(*evidence)
    if accidents.may_explain(*evidence):
        return Refusal(*accidental(task.within(0.5, 1.0), best, expected))
    if not solutions.complete:
        if expected > task.settings.matches.accidents.certain:
            return search_ended(task)
        warnings = (*warnings, incomplete_search(task))
    return ScanMatch(best, expected, warnings)


def _kept(task: MatchingTask, solution: Solution) -> np.ndarray:
    """Return the rows of the matched targets that are not outliers."""
    rows = np.flatnonzero(solution.labels >= 0)
    points, targets = task.control.points[solution.labels[rows]], task.scan.xyz[rows]
    nothing = np.zeros((3 * len(rows), 3 * len(rows)))
    width = line_width(task.scan.xyz, task.settings)
    own = task.scan.covariances_of(rows)
    return rows[fit_scan(targets, points, nothing, task.settings, width, own).used]


def _variance_factor(solution: Solution, model: Model) -> float:
    return max(1.0, solution.misfit / max(redundancy(solution.matched, model), 1))
