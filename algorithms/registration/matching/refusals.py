"""Why a scan is not registered: the lists, the layout of targets, accidental and ambiguous matches."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy.spatial.distance import cdist

from ..adjustment.target_layout import fixes_pose, line_width
from ..settings import Model
from .accidental_matches import AccidentalMatches
from .matching_task import MatchingTask
from .solution import Solution


@dataclass(frozen=True)
class Refusal:
    """Why a scan has no transformation; the attributes are those of `ScanRegistration`."""

    status: str
    reason: str
    rivals: tuple[dict[str, str], ...] = ()


def refused_list(task: MatchingTask) -> Optional[Refusal]:
    """Return why no search can succeed, None if one may."""
    return (
        _few_targets(task)
        or _coincident_targets(task)
        or _targets_on_a_line(task)
        or _unknown_names(task)
        or _many_points(task)
    )


def _few_targets(task: MatchingTask) -> Optional[Refusal]:
    count, least = len(task.scan.names), task.settings.model.least_targets
    if count >= least:
        return None
    return Refusal(
        "too few",
        f"{task.scan.name} has {count} {'target' if count == 1 else 'targets'}, but "
        f"{_described(task.settings.model)} needs at least {least}; pick more targets.",
    )


def _coincident_targets(task: MatchingTask) -> Optional[Refusal]:
    scan = task.scan
    width = line_width(scan.xyz, task.settings)
    close = np.argwhere(np.triu(cdist(scan.xyz, scan.xyz) <= width, 1))
    if task.free_scale or not len(close):
        return None
    one, other = sorted((scan.names[number] for number in close[0]), key=lambda name: (len(name), name))
    return Refusal(
        "coincident",
        f"The targets {one} and {other} of {scan.name} have the same position; remove one of them.",
    )


def _targets_on_a_line(task: MatchingTask) -> Optional[Refusal]:
    scan, model = task.scan, task.settings.model
    if fixes_pose(scan.xyz, model, line_width(scan.xyz, task.settings)):
        return None
    line = "above each other" if model.levelled else "on a line"
    return Refusal(
        "collinear",
        f"The targets of {scan.name} lie {line}, which leaves the rotation about it unknown; add a target "
        "beside it.",
    )


def _unknown_names(task: MatchingTask) -> Optional[Refusal]:
    known, least = int(task.allowed.any(axis=1).sum()), task.settings.model.least_targets
    if not task.named or known >= least:
        return None
    return Refusal(
        "no overlap",
        f"Of the targets of {task.scan.name}, {known} have the name of a control point, but "
        f"{_described(task.settings.model)} needs at least {least}; correct the names, or match by "
        "distances.",
    )


def _many_points(task: MatchingTask) -> Optional[Refusal]:
    count, most = len(task.network.points), task.settings.matches.triangles.most_points
    if not task.free_scale or task.named or count <= most:
        return None
    return Refusal(
        "too many",
        f"With an unknown scale at most {most} control points can be searched, and there are {count}; "
        f"shorten the list to the surroundings of {task.scan.name}, or match by names.",
    )


def _described(model: Model) -> str:
    return "a levelled scan" if model.levelled else "a scan"


def too_few(task: MatchingTask, accidents: AccidentalMatches) -> Refusal:
    """Return the refusal of a scan whose matches could all be accidental."""
    count, points = len(task.scan.names), len(task.network.points)
    most = min(count, points)
    redundancy = 3 * most - task.settings.model.unknowns
    if redundancy <= 0:
        return Refusal(
            "too few",
            f"{most} matches of {task.scan.name} leave no redundancy to check the solution; pick more "
            "targets, or match by names.",
        )
    return Refusal(
        "chance",
        f"{count} targets of {task.scan.name} are too few for {points} control points: "
        f"{accidents.expected(most, redundancy):.2g} accidental matches are expected; pick more targets, "
        "shorten the control list to the surroundings, or match by names.",
    )


def search_ended(task: MatchingTask) -> Refusal:
    """Return the refusal of a scan whose search was ended without a certain solution."""
    names = "" if task.named else ", or match by names"
    return Refusal(
        "too many",
        f"The search for the {len(task.scan.names)} targets of {task.scan.name} among "
        f"{len(task.network.points)} control points was ended, because too many triangles are "
        f"similar; remove targets that are not control points, or shorten the control list{names}.",
    )


def nearly_on_a_line(task: MatchingTask, rotation_std_deg: float) -> Refusal:
    """Return the refusal of a scan whose matched targets hardly determine its rotation."""
    line = "nearly above each other" if task.settings.model.levelled else "nearly on a line"
    return Refusal(
        "collinear",
        f"The matched targets of {task.scan.name} lie {line}, which leaves the rotation about it uncertain "
        f"by {rotation_std_deg:.0f} degrees; add a target beside it.",
    )


def ambiguous(task: MatchingTask, rivals: list[Solution]) -> Refusal:
    """Return the refusal of a scan with several equally good solutions, which it lists."""
    names, points = task.scan.names, task.network.names
    described = tuple(
        {names[row]: points[label] for row, label in enumerate(item.labels) if label >= 0} for item in rivals
    )
    most = task.settings.matches.search.most_solutions
    number = f"at least {len(rivals)}" if len(rivals) >= most else str(len(rivals))
    listed = "; ".join(
        ", ".join(f"{target} = {point}" for target, point in rival.items()) for rival in described[:4]
    )
    more = f"; and {len(rivals) - 4} more" if len(rivals) > 4 else ""
    by_names = "" if task.named else ", or match by names"
    return Refusal(
        "ambiguous",
        f"The targets of {task.scan.name} fit the control points in {number} equally good ways "
        f"({listed}{more}); add a target that breaks the symmetry{by_names}.",
        described,
    )
