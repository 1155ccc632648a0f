"""Why the targets of a scan match nothing: the mistakes that surveyors know, tried one by one."""

from dataclasses import replace
from typing import TYPE_CHECKING, Optional

import numpy as np

from ..settings import Model
from .control_points import DRIFT

if TYPE_CHECKING:
    from .scan_matching import Question

LENGTHS = {"millimetres": 0.001, "centimetres": 0.01, "feet": 0.3048, "inches": 0.0254, "kilometres": 1000.0}
MIRRORS = (np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]]), np.diag([1, 1, -1]))
"""x and y swapped, and upside down; a scan that may take any pose needs only one of them."""

CONVINCING = 4
"""Three targets fit their mirror image too."""


def explain_failure(question: "Question", least: int) -> tuple[str, str]:
    """Return the status and the reason of a scan without a solution of `least` targets."""
    enough = max(least, CONVINCING)
    explained = (
        mirrored_solution(question, enough)
        or _other_unit(question, enough)
        or _not_levelled(question, enough)
        or _scaled(question, enough)
        or _misnamed(question, enough)
    )
    return explained or _nothing(question, least)


def mirrored_solution(question: "Question", least: int) -> Optional[tuple[str, str]]:
    """Return status and reason if the mirror image of the list has a solution of `least` targets."""
    scan, model = question.scan, question.settings.model
    for mirror in MIRRORS[: 2 if model.levelled else 1]:
        solutions = question.solutions(scan.xyz @ mirror, model, max(least, CONVINCING))
        if solutions:
            return (
                "mirrored",
                f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit the control "
                "points as in a "
                "mirror: in one of the two lists x and y are swapped, or an axis points the other way.",
            )
    return None


def _other_unit(question: "Question", least: int) -> Optional[tuple[str, str]]:
    if question.free_scale:
        return None
    scan, site, model = question.scan, question.site, question.settings.model
    for unit, metres in LENGTHS.items():
        for what, targets, control in (
            (scan.name, scan.xyz * metres, site),
            ("the control list", scan.xyz, replace(site, points=site.points * metres)),
        ):
            solutions = question.solutions(targets, model, least, control)
            if solutions:
                return (
                    "units",
                    f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit if the "
                    "coordinates of "
                    f"{what} are {unit}; convert them to metres.",
                )
    return None


def _not_levelled(question: "Question", least: int) -> Optional[tuple[str, str]]:
    scan, model = question.scan, question.settings.model
    if not model.levelled or question.free_scale:
        return None
    solutions = question.solutions(scan.xyz, Model.RIGID, least)
    if not solutions:
        return None
    tilt = float(np.degrees(np.arccos(np.clip(solutions[0].pose.rotation[2, 2], -1.0, 1.0))))
    return (
        "tilted",
        f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit if the scan is tilted by "
        f"{tilt:.2f} degrees; choose a model that is not levelled, or correct the order of the axes (z is "
        "up).",
    )


def _scaled(question: "Question", least: int) -> Optional[tuple[str, str]]:
    scan, model = question.scan, question.settings.model
    if model.scaled:
        return None
    model = Model.LEVELLED_SCALE if model.levelled else Model.SIMILARITY
    solutions = question.solutions(scan.xyz, model, least, replace(question.site, drift=DRIFT))
    if not solutions:
        return None
    return (
        "scale",
        f"{solutions[0].matched} of {len(scan.names)} targets of {scan.name} fit with a scale error of "
        f"{1e6 * (float(solutions[0].pose.scale) - 1):+.0f} ppm, as grid coordinates have that are not "
        "reduced for the "
        "projection; choose a model with scale.",
    )


def _misnamed(question: "Question", least: int) -> Optional[tuple[str, str]]:
    if not question.named or question.free_scale:
        return None
    scan = question.scan
    anything = replace(question, allowed=np.ones_like(question.allowed))
    solutions = anything.solutions(scan.xyz, question.settings.model, least)
    if not solutions:
        return None
    return (
        "misfit",
        f"By their names, the targets of {scan.name} do not fit the control points, but by their distances "
        f"{solutions[0].matched} of {len(scan.names)} do; correct the names, or match by distances.",
    )


def _nothing(question: "Question", least: int) -> tuple[str, str]:
    scan = question.scan
    limit = f"{1000 * float(np.median(question.site.limits)):.0f} mm"
    if question.named:
        return (
            "misfit",
            f"The targets of {scan.name} do not fit the control points of their names: no {least} of them "
            "agree "
            f"within {limit} in their distances; correct the names, or raise SIGMA or TOLERANCE.",
        )
    return (
        "no overlap",
        f"No {least} of {len(scan.names)} targets of {scan.name} have the distances of control points "
        f"within {limit} "
        "(fewer would match by accident); check that the list belongs to this site, pick more targets, or "
        "raise SIGMA or TOLERANCE.",
    )
