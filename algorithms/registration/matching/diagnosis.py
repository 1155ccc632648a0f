"""Why the targets of a scan match nothing: usual mistakes of surveys, tried one by one."""

from dataclasses import replace
from typing import Optional

import numpy as np

from ..settings import Model
from .matching_task import MatchingTask
from .solution import Solution

LENGTHS = {"millimetres": 0.001, "centimetres": 0.01, "feet": 0.3048, "inches": 0.0254, "kilometres": 1000.0}
MIRRORS = (np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]]), np.diag([1, 1, -1]))
"""x and y swapped, and upside down; without a level either one stands for all mirror images."""


def explain_failure(task: MatchingTask, least: int) -> tuple[str, str]:
    """Return the status and the reason of a scan without a solution of `least` targets."""
    enough = max(least, task.settings.matches.diagnosis.least_targets)
    explained = (
        mirrored_solution(task, enough)
        or _other_unit(task, enough)
        or _not_levelled(task, enough)
        or _scaled(task, enough)
        or _misnamed(task, enough)
    )
    return explained or _nothing(task, least)


def mirrored_solution(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    """Return status and reason if the mirror image of the list has a solution of `least` targets."""
    scan, model = task.scan, task.settings.model
    least = max(least, task.settings.matches.diagnosis.least_targets)
    for mirror in MIRRORS[: 2 if model.levelled else 1]:
        solutions = task.solutions(scan.xyz @ mirror, model, least)
        if solutions:
            return (
                "mirrored",
                f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit the mirror "
                "image of the control points: in one of the two lists x and y are swapped, or an axis is "
                "reversed.",
            )
    return None


def _other_unit(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    if task.free_scale:
        return None
    scan, points, model = task.scan, task.control, task.settings.model
    for unit, metres in LENGTHS.items():
        for what, targets, control in (
            (scan.name, scan.xyz * metres, points),
            ("the control list", scan.xyz, replace(points, points=points.points * metres)),
        ):
            solutions = task.solutions(targets, model, least, control)
            if solutions:
                return (
                    "units",
                    f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit if the "
                    f"coordinates of {what} are in {unit}; convert them to metres.",
                )
    return None


def _not_levelled(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    scan, model = task.scan, task.settings.model
    if not model.levelled or task.free_scale:
        return None
    solutions = task.solutions(scan.xyz, Model.RIGID, least)
    if not solutions:
        return None
    tilt = float(np.degrees(np.arccos(np.clip(solutions[0].pose.rotation[2, 2], -1.0, 1.0))))
    return (
        "tilted",
        f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit if the scan is tilted by "
        f"{tilt:.2f} degrees; choose a model that is not levelled, or correct the order of the axes (z is "
        "up).",
    )


def _scaled(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    scan, model = task.scan, task.settings.model
    if model.scaled:
        return None
    model = Model.LEVELLED_SCALE if model.levelled else Model.SIMILARITY
    control = replace(task.control, scale_error=task.settings.matches.tolerances.scale_error)
    solutions = task.solutions(scan.xyz, model, least, control)
    if not solutions:
        return None
    return (
        "scale",
        f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit with a scale error of "
        f"{1e6 * (float(solutions[0].pose.scale) - 1):+.0f} ppm, which suggests grid coordinates "
        "that are not reduced for the projection; choose a model with scale.",
    )


def _misnamed(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    if not task.named or task.free_scale:
        return None
    scan = task.scan
    anything = replace(task, allowed=np.ones_like(task.allowed))
    solutions = anything.solutions(scan.xyz, task.settings.model, least)
    if not solutions:
        return None
    return (
        "misfit",
        f"By their names, the targets of {scan.name} do not fit the control points, but by their distances "
        f"{solutions[0].matched} of {len(scan.names)} do; correct the names, or match by distances.",
    )


def _nothing(task: MatchingTask, least: int) -> tuple[str, str]:
    scan = task.scan
    limit = f"{1000 * float(np.median(task.control.limits)):.0f} mm"
    if task.named:
        return (
            "misfit",
            f"The targets of {scan.name} do not fit the control points of their names: fewer than "
            f"{least} of them agree within {limit} in their distances; correct the names, or raise SIGMA or "
            "TOLERANCE.",
        )
    return (
        "no overlap",
        f"Fewer than {least} of {len(scan.names)} targets of {scan.name} have the distances of control "
        f"points within {limit}, and so few may match by accident; check that the list belongs to this site, "
        "pick more targets, or raise SIGMA or TOLERANCE.",
    )


def accidental(task: MatchingTask, best: Solution, expected: float) -> tuple[str, str]:
    """Return status and reason of a scan whose match may be accidental; a mistake may explain more."""
    status, reason = explain_failure(task, best.matched)
    if status in ("mirrored", "units", "tilted", "scale"):
        return status, reason
    return (
        "chance",
        f"{best.matched} of {len(task.scan.names)} targets of {task.scan.name} match, but "
        f"{expected:.2g} accidental matches of as many are expected; pick more targets, or match by names.",
    )
