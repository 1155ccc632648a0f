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
    scan, model = task.scan, task.settings.model
    count = len(scan.names)
    if count < model.least_targets:
        return Refusal(
            "too few",
            f"{scan.name} has {count} target{'s' * (count != 1)}, but {_described(model)} needs at least "
            f"{model.least_targets}; pick more targets.",
        )
    width = line_width(scan.xyz, task.settings)
    if not task.free_scale:
        close = np.argwhere(np.triu(cdist(scan.xyz, scan.xyz) <= width, 1))
        if len(close):
            one, other = sorted(
                (scan.names[number] for number in close[0]), key=lambda name: (len(name), name)
            )
            return Refusal(
                "coincident",
                f"The targets {one} and {other} of {scan.name} are at the same place; remove one of them.",
            )
    if not fixes_pose(scan.xyz, model, width):
        line = "above each other" if model.levelled else "on a line"
        return Refusal(
            "collinear",
            f"The targets of {scan.name} lie {line}, so the scan can still turn about it; "
            "pick a target beside it.",
        )
    most_points = task.settings.matches.triangles.most_points
    known = int(task.allowed.any(axis=1).sum())
    if task.named and known < model.least_targets:
        return Refusal(
            "no overlap",
            f"Of the targets of {scan.name}, {known} have the name of a control point, but "
            f"{_described(model)} needs at least {model.least_targets}; correct the names, or match by "
            "distances.",
        )
    if task.free_scale and not task.named and len(task.network.points) > most_points:
        return Refusal(
            "too many",
            f"With an unknown scale at most {most_points} control points can be searched, and there are "
            f"{len(task.network.points)}; shorten the list to the surroundings of {scan.name}, or match "
            "by names.",
        )
    return None


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
            f"{most} matches of {task.scan.name} leave nothing to check them by; pick more targets, or "
            "match "
            "by names.",
        )
    return Refusal(
        "chance",
        f"{count} targets of {task.scan.name} can be matched with {points} control points by accident "
        f"(expected {accidents.expected(most, redundancy):.2g} times); pick more targets, shorten the "
        "control list to the surroundings, or match by names.",
    )


def nearly_on_a_line(task: MatchingTask, rotation_std_deg: float) -> Refusal:
    """Return the refusal of a scan whose matched targets hardly determine its rotation."""
    line = "nearly above each other" if task.settings.model.levelled else "nearly on a line"
    return Refusal(
        "collinear",
        f"The targets of {task.scan.name} that match lie {line}, so the scan may turn about it by "
        f"{rotation_std_deg:.0f} degrees; pick a target beside it.",
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
    return Refusal(
        "ambiguous",
        f"The targets of {task.scan.name} fit the control points in {number} ways that are equally good "
        f"({listed}{more}); add a target that breaks the symmetry, or match by names.",
        described,
    )
