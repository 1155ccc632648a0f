"""What the report says about a single scan."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...reporting.numbers import number
from ..adjustment.settings import OutlierTestSettings
from ..adjustment.statistical_tests import critical_tau
from ..results import GlobalTest, Placement, Registration, ScanRegistration, SurfaceChange
from .layers import semi_axes
from .report_figures import residual_bars, scan_plan

IS_FRAME = "Its frame is that of all scans, because there are no control points."

TAU = "\N{GREEK SMALL LETTER TAU}"

UNITS = {"shift": ("m", 4), "rotation": ("\N{DEGREE SIGN}", 6), "scale": ("", 8)}


class Flagged(NamedTuple):
    """A number, and whether the reader should doubt it."""

    text: str
    doubtful: bool


def scan_content(scan: ScanRegistration, registration: Registration) -> dict[str, object]:
    """Return all that the template shows of a scan that was registered."""
    if scan.test is None or scan.correlations is None:
        raise ValueError(f"{scan.name} is not registered.")
    tests = registration.settings.adjustment.tests
    limit = critical_tau(scan.test.redundancy, tests)
    matched = bool(scan.correspondences)
    plan, plan_caption = scan_plan(scan, registration) if matched else ("", "")
    components, lengths = residual_bars(scan) if matched else ("", "")
    return {
        "name": scan.name,
        "matched": _matched(scan),
        "warnings": scan.warnings,
        "verdict": verdict(scan.test, tests),
        "scale_advice": scan.scale_test.advice if scan.scale_test else "",
        "plan": plan,
        "plan_caption": plan_caption,
        "components": components,
        "lengths": lengths,
        "parameters": _parameters(scan),
        "parameter_names": [_spoken(item.name) for item in scan.estimates],
        "correlations": _correlations(scan, scan.correlations),
        "residuals": _residuals(scan),
        "rejected": _rejected(scan),
        "rejected_rows": [row for row, item in enumerate(scan.correspondences) if not item.used],
        "reliability": _reliability(scan, limit, tests),
        "critical_tau": number(limit, 2),
    }


def verdict(test: GlobalTest, tests: OutlierTestSettings = OutlierTestSettings()) -> str:
    """Return the global test in words."""
    if np.isnan(test.probability):
        return "nothing is redundant, so nothing is checked."
    numbers = (
        f"(sigma0 {test.sigma0:.2f}, redundancy {test.redundancy:.1f}, v'Pv {test.sum_of_squares:.2f}, "
        f"chi-square probability {test.probability:.3f})"
    )
    if test.probability < tests.global_significance / 2:
        return f"the residuals are larger than the a priori standard deviations allow {numbers}."
    if test.probability > 1 - tests.global_significance / 2:
        return f"the residuals are smaller than the a priori standard deviations suggest {numbers}."
    return f"the residuals agree with the a priori standard deviations {numbers}."


def _matched(scan: ScanRegistration) -> str:
    used = [item for item in scan.correspondences if item.used]
    surveyed = sum(item.surveyed for item in used)
    sentences = []
    if scan.is_frame:
        sentences.append(IS_FRAME)
    if scan.placement is not None:
        sentences.append(by_surfaces(scan.placement))
    if scan.round is not None:
        sentences.append(
            f"Registered in round {scan.round} with {len(used)} of {scan.targets} targets, of which "
            f"{surveyed} are surveyed points."
        )
    if scan.chance is not None:
        sentences.append(f"Expected accidental matches of so many targets: {scan.chance:.1g}.")
    if scan.placement is not None:
        sentences.append(f"Standard deviation of the scanner: {number(1000 * (scan.std or 0.0), 1)} mm.")
    elif scan.std is not None and not scan.is_frame:
        sentences.append(f"Largest standard deviation at a target: {number(1000 * scan.std, 1)} mm.")
    if scan.surfaces is not None:
        sentences.append(change_by_surfaces(scan.surfaces))
    if scan.unmatched:
        sentences.append(f"Appended to the control points: {', '.join(scan.unmatched)}.")
    return " ".join(sentences)


def by_surfaces(placement: Placement) -> str:
    """Return how surfaces placed a scan, and how sure that is, as sentences."""
    sentences = [
        f"Placed by surfaces: {placement.agreeing} patches agree with {', '.join(placement.scans)}, and "
        f"{placement.contradicting} contradict them."
    ]
    if placement.targets:
        sentences.append(f"{placement.targets} of its targets lie on known points.")
    if placement.next_agreeing is None:
        sentences.append("No other pose was found.")
    else:
        sentences.append(
            f"At the next best pose, the scanner {placement.next_shift:.1f} m away and turned by "
            f"{placement.next_turn_deg:.0f} degrees, {placement.next_agreeing} agree and "
            f"{placement.next_contradicting} contradict."
        )
    return " ".join(sentences)


def change_by_surfaces(change: SurfaceChange) -> str:
    """Return what the surfaces that a scan shares changed, as a sentence."""
    shift, std = 1000 * change.shift, 1000 * change.std
    if not change.used:
        return (
            f"Surfaces would move its targets by up to {shift:.1f} mm, {change.sigmas:.2f} standard "
            f"deviations, and are not used; by the targets alone, the largest standard deviation is "
            f"{std:.1f} mm."
        )
    return (
        f"Surfaces moved its targets by up to {shift:.1f} mm, {change.sigmas:.2f} standard deviations; by "
        f"the targets alone, the largest standard deviation is {std:.1f} mm."
    )


def _parameters(scan: ScanRegistration) -> list[tuple[str, str, str, str]]:
    rows = []
    for item in scan.estimates:
        unit, decimals = UNITS[item.name.split("_")[0]]
        rows.append((_spoken(item.name), number(item.value, decimals), number(item.std, decimals), unit))
    return rows


def _correlations(scan: ScanRegistration, correlations: np.ndarray) -> list[tuple[str, ...]]:
    """Return the lower half of the matrix, without its diagonal."""
    names = [_spoken(item.name) for item in scan.estimates]
    return [
        (name, *(number(value, 2) for value in values[:place]), *[""] * (len(names) - 1 - place))
        for place, (name, values) in enumerate(zip(names, correlations))
        if place
    ]


def _residuals(scan: ScanRegistration) -> list[tuple[str, ...]]:
    return [
        (
            item.target,
            item.control,
            "surveyed" if item.surveyed else "appended",
            *_millimetres((*item.residual, item.length, *semi_axes(item.covariance))),
        )
        for item in scan.correspondences
    ]


def _rejected(scan: ScanRegistration) -> list[str]:
    return [
        f"{item.target} = {item.control} was rejected: it is {item.length:.3f} m off, "
        f"|w| {number(float(np.abs(item.normalized).max()), 1)}."
        for item in scan.correspondences
        if not item.used
    ]


def _reliability(
    scan: ScanRegistration, limit: float, tests: OutlierTestSettings
) -> list[tuple[str, list[Flagged]]]:
    """Return each target with its redundancy numbers, w, tau up to a limit, and minimal detectable biases."""
    return [
        (
            item.target,
            [
                *(Flagged(number(value, 2), value < tests.weak_redundancy) for value in item.redundancy),
                *(Flagged(number(value, 2), abs(value) > tests.critical_w) for value in item.normalized),
                *(Flagged(number(value, 2), abs(value) > limit) for value in item.studentized),
                *(Flagged(text, False) for text in _millimetres(item.detectable)),
            ],
        )
        for item in scan.correspondences
    ]


def _millimetres(metres: Sequence[float]) -> list[str]:
    return [number(1000 * value, 1) for value in metres]


def _spoken(name: str) -> str:
    return name.replace("_", " ")
