"""Why the targets of a scan match nothing: usual mistakes of surveys, tried one by one."""

from dataclasses import replace
from typing import Optional

import numpy as np

from ..adjustment.target_layout import is_of_projection
from ..settings import Model
from .matching_task import MatchingTask
from .mirror_images import mirror_images, mirrored_list
from .solution import Solution

LENGTHS = {"millimetres": 0.001, "centimetres": 0.01, "feet": 0.3048, "inches": 0.0254, "kilometres": 1000.0}


def explain_failure(task: MatchingTask, least: int) -> tuple[str, str]:
    """Return the status and the reason of a scan without a solution of `least` targets."""
    # Three targets fit their mirror image too, two if levelled, so that they prove no explanation.
    enough = max(least, task.settings.model.least_targets + 1)
    causes = (_mirrored, _other_unit, _not_levelled, _scaled, _scaled_by_names, _misnamed)
    for number, cause in enumerate(causes):
        explained = cause(task.within(number / len(causes), (number + 1) / len(causes)), enough)
        if explained:
            return explained
    return _nothing(task, least)


def _mirrored(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    images = mirror_images(task, least)
    return mirrored_list(task, images[0]) if images else None


def _other_unit(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    if task.free_scale:
        return None
    scan, points, model = task.scan, task.control, task.settings.model
    for number, (unit, metres) in enumerate(LENGTHS.items()):
        part = task.within(number / len(LENGTHS), (number + 1) / len(LENGTHS))
        for what, targets, control in (
            (scan.name, scan.xyz * metres, points),
            ("the control list", scan.xyz, replace(points, points=points.points * metres)),
        ):
            solutions = part.solutions(targets, model, least, control)
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
    best = solutions[0]
    matched = scan.xyz[best.labels >= 0]
    ppm = 1e6 * (float(best.pose.scale) - 1)
    if not is_of_projection(ppm, matched, task.settings):
        return None
    return (
        "scale",
        f"{best.matched} of {len(scan.names)} targets of {scan.name} fit with a scale error of "
        f"{ppm:+.0f} ppm, which suggests grid coordinates that are not reduced for the projection; choose a "
        f"model with scale (MODEL={model.value}).",
    )


def _scaled_by_names(task: MatchingTask, least: int) -> Optional[tuple[str, str]]:
    """Explain by any scale, which names allow for."""
    scan, model = task.scan, task.settings.model
    if not task.named or model.scaled:
        return None
    model = Model.LEVELLED_SCALE if model.levelled else Model.SIMILARITY
    solutions = replace(task, settings=replace(task.settings, model=model)).solutions(scan.xyz, model, least)
    if not solutions:
        return None
    return (
        "scale",
        f"By their names, {solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit with a "
        f"scale of {float(solutions[0].pose.scale):.6g}; if the scan may have another scale than the control "
        f"points, choose a model with scale (MODEL={model.value}), else check units and control list.",
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
