"""What a user should know about a scan that matches: mirror images, tilts and wrong names."""

from collections.abc import Sequence

import numpy as np

from ..adjustment.control_network import ControlNetwork
from ..lists.point_list import PointList
from .matching_task import MatchingTask
from .mirror_images import MirrorImage
from .solution import Solution


def match_warnings(task: MatchingTask, best: Solution, images: Sequence[MirrorImage]) -> tuple[str, ...]:
    """Return the warnings about a solution, in sentences.

    Parameters
    ----------
    task : MatchingTask
    best : Solution
    images : sequence of MirrorImage
        Those that fit as well.
    """
    scan, network = task.scan, task.network
    warnings = [_undecided(task, image) for image in images]
    tilt = float(np.degrees(np.arccos(np.clip(best.pose.rotation[2, 2], -1.0, 1.0))))
    if tilt > task.settings.matches.decision.least_tilt_deg and not task.free_scale:
        warnings.append(
            f"{scan.name} is tilted by {tilt:.0f} degrees; if the scanner stood upright, the axes of a "
            "list are in another order (z is up)."
        )
    if task.named:
        warnings += _wrong_names(task, best)
    else:
        warnings += _contradicted_names(scan, network, best)
    return tuple(warnings)


def _undecided(task: MatchingTask, image: MirrorImage) -> str:
    """Return the warning that nothing shows whether the list is mirrored."""
    return (
        f"The matched targets of {task.scan.name} lie in one plane or symmetrically, so that a mirrored "
        f"list would fit as well ({image.cause}); check the position of the scanner in the report, or add a "
        "target."
    )


def incomplete_search(task: MatchingTask) -> str:
    """Return the warning that not all seeds were tried."""
    return (
        f"The search for the targets of {task.scan.name} was ended before all triangles were tried, because "
        "there are too many; a solution with more targets may exist. Shorten the lists to make sure."
    )


def _wrong_names(task: MatchingTask, best: Solution) -> list[str]:
    """Return warnings about the targets that do not lie at the control point of their name."""
    scan, network = task.scan, task.network
    placed = best.pose.apply(scan.xyz)
    near = task.settings.matches.tolerances.near_miss_factor * task.control.factor * task.control.sigma
    warnings = []
    for row in np.flatnonzero((best.labels < 0) & task.allowed.any(axis=1)):
        own = np.linalg.norm(network.points[task.allowed[row]] - placed[row], axis=1).min()
        away = np.linalg.norm(network.points - placed[row], axis=1)
        sentence = (
            f"Target {scan.names[row]} of {scan.name} lies {own:.3f} m from the control point of its name"
        )
        nearest = int(away.argmin())
        if away[nearest] <= near:
            sentence += f", but {away[nearest]:.3f} m from {network.names[nearest]}: its name is wrong"
        warnings.append(sentence + "; it was left out.")
    return warnings


def _contradicted_names(scan: PointList, network: ControlNetwork, best: Solution) -> list[str]:
    if not scan.named:
        return []
    known = set(network.labels)
    wrong = [
        f"{name} is {network.names[label]}"
        for name, label in zip(scan.names, best.labels)
        if label >= 0 and name in known and network.labels[label] != name
    ]
    # Numbers that merely count the rows of both lists contradict each other everywhere.
    agreeing = sum(
        name == network.labels[label] for name, label in zip(scan.names, best.labels) if label >= 0
    )
    if not wrong or agreeing < len(wrong):
        return []
    return [f"According to the distances, these names in {scan.name} are wrong: {', '.join(wrong)}."]
