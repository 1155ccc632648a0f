"""What the report says about a single scan."""

from collections.abc import Sequence

import numpy as np

from ...reporting.html import Markup, bullets, element, notes, number, paragraph, section, table
from ..adjustment.statistical_tests import CRITICAL_W, critical_tau
from ..results import GlobalTest, Registration, ScanRegistration
from .layers import semi_axes
from .report_figures import residual_bars, scan_plan

LEVEL = 0.05
"""Of the global test, both sides together."""

WEAK = 0.1
"""Below this redundancy number, hardly anything of an error shows in the residual."""

MOST_RIVALS = 12

TAU = "\N{GREEK SMALL LETTER TAU}"

UNITS = {"shift": ("m", 4), "rotation": ("\N{DEGREE SIGN}", 6), "scale": ("", 8)}


def registered_section(scan: ScanRegistration, registration: Registration, anchor: str) -> Markup:
    """Return all that is known of a scan that was registered."""
    return section(
        scan.name,
        paragraph(_matched(scan)),
        notes(scan.warnings),
        paragraph(f"Global test: {verdict(scan.test)} ", scan.scale_test.advice if scan.scale_test else ""),
        scan_plan(scan, registration),
        residual_bars(scan),
        section("Parameters, scan to control points", _parameters(scan), _correlations(scan), level=3),
        section("Residuals", _residuals(scan), _rejected(scan), level=3),
        section("Reliability", _reliability(scan), level=3),
        anchor=anchor,
    )


def refused_section(scan: ScanRegistration, anchor: str) -> Markup:
    """Return why a scan was not registered."""
    shown = [
        ", ".join(f"{target} = {control}" for target, control in rival.items())
        for rival in scan.rivals[:MOST_RIVALS]
    ]
    more = len(scan.rivals) - len(shown)
    return section(
        f"{scan.name}: {scan.status}",
        notes([scan.reason, *scan.warnings]),
        paragraph("Solutions that are as good as each other, target = control point:") if shown else Markup(),
        bullets([*shown, f"and {more} more"] if more else shown),
        anchor=anchor,
    )


def verdict(test: GlobalTest) -> str:
    """Return the global test in words."""
    if np.isnan(test.probability):
        return "nothing is redundant, so nothing is checked."
    numbers = (
        f"(sigma0 {test.sigma0:.2f}, redundancy {test.redundancy:.1f}, v'Pv {test.sum_of_squares:.2f}, "
        f"chi-square probability {test.probability:.3f})"
    )
    if test.probability < LEVEL / 2:
        return f"the residuals are larger than the a priori standard deviations allow {numbers}."
    if test.probability > 1 - LEVEL / 2:
        return f"the residuals are smaller than the a priori standard deviations let expect {numbers}."
    return f"the residuals agree with the a priori standard deviations {numbers}."


def _matched(scan: ScanRegistration) -> str:
    used = [item for item in scan.correspondences if item.used]
    surveyed = sum(item.surveyed for item in used)
    sentences = [
        f"Registered in round {scan.round} with {len(used)} of {scan.targets} targets, of which {surveyed} "
        "are surveyed points."
    ]
    if scan.chance is not None:
        sentences.append(f"Expected accidental matches of so many targets: {scan.chance:.1g}.")
    if scan.unmatched:
        sentences.append(f"Appended to the control points: {', '.join(scan.unmatched)}.")
    return " ".join(sentences)


def _parameters(scan: ScanRegistration) -> Markup:
    rows = []
    for item in scan.estimates:
        unit, decimals = UNITS[item.name.split("_")[0]]
        rows.append((_spoken(item.name), number(item.value, decimals), number(item.std, decimals), unit))
    return table(("parameter", "value", "standard deviation", "unit"), rows, words=(0, 3))


def _correlations(scan: ScanRegistration) -> Markup:
    names = [_spoken(item.name) for item in scan.estimates]
    rows = [
        (name, *(number(value, 2) for value in values[:place]), *[""] * (len(names) - 1 - place))
        for place, (name, values) in enumerate(zip(names, scan.correlations))
        if place
    ]
    return table(("", *names[:-1]), rows, caption="Correlations")


def _residuals(scan: ScanRegistration) -> Markup:
    header = ("target", "control", "origin", "vx", "vy", "vz", "v", "a", "b", "c")
    rows = [
        (
            item.target,
            item.control,
            "surveyed" if item.surveyed else "appended",
            *_millimetres((*item.residual, item.length, *semi_axes(item.covariance)), 1),
        )
        for item in scan.correspondences
    ]
    caption = (
        "Millimetres; a, b, c: semi-axes of the 95 % ellipsoid of the transformed target. Red: rejected."
    )
    return table(header, rows, words=(0, 1, 2), marked=_rejected_rows(scan), caption=caption)


def _rejected(scan: ScanRegistration) -> Markup:
    return bullets(
        f"{item.target} = {item.control} was rejected: it is {item.length:.3f} m off, "
        f"|w| {number(float(np.abs(item.normalized).max()), 1)}."
        for item in scan.correspondences
        if not item.used
    )


def _reliability(scan: ScanRegistration) -> Markup:
    limit = critical_tau(scan.test.redundancy)
    header = ["target"] + [
        f"{kind} {axis}" for kind in ("r", "w", "\N{GREEK SMALL LETTER TAU}", "MDB") for axis in "xyz"
    ]
    rows = [
        (
            item.target,
            *(_flagged(number(value, 2), value < WEAK) for value in item.redundancy),
            *(_flagged(number(value, 2), abs(value) > CRITICAL_W) for value in item.normalized),
            *(_flagged(number(value, 2), abs(value) > limit) for value in item.studentized),
            *_millimetres(item.detectable, 1),
        )
        for item in scan.correspondences
    ]
    caption = (
        f"Red: redundancy number below {WEAK:g}, |w| above {CRITICAL_W:.2f}, |{TAU}| above "
        f"{number(limit, 2)}, or rejected. MDB in millimetres."
    )
    return table(header, rows, marked=_rejected_rows(scan), caption=caption)


def _rejected_rows(scan: ScanRegistration) -> list[int]:
    return [row for row, item in enumerate(scan.correspondences) if not item.used]


def _flagged(text: str, doubtful: bool) -> object:
    return element("b", text, class_="red") if doubtful else text


def _millimetres(values: Sequence[float], decimals: int) -> list[str]:
    return [number(1000 * value, decimals) for value in values]


def _spoken(name: str) -> str:
    return name.replace("_", " ")
