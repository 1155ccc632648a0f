"""REPORT: a registration as a page to read, print and keep."""

from pathlib import Path

from ...reporting.html import (
    MISSING,
    Markup,
    definitions,
    link,
    notes,
    number,
    paragraph,
    section,
    table,
    write_page,
)
from ..adjustment.statistical_tests import ALPHA, CRITICAL_W, NONCENTRALITY, POWER
from ..results import ControlPoint, Registration, ScanRegistration
from ..settings import Matching, Model, Settings
from .layers import PLANE_FACTOR, SPACE_FACTOR
from .report_figures import site_plan
from .report_scan import LEVEL, TAU, refused_section, registered_section, verdict

MODELS = {
    Model.RIGID: "rigid",
    Model.SIMILARITY: "with a scale near 1",
    Model.LEVELLED: "levelled",
    Model.LEVELLED_SCALE: "levelled with a scale near 1",
    Model.UNKNOWN_SCALE: "unknown scale",
}

ALPHA_SIGN, DELTA = "\N{GREEK SMALL LETTER ALPHA}", "\N{GREEK SMALL LETTER DELTA}"

LEGEND = {
    "v": "Residual: the transformed target minus its control point, along x, y and z of the control points, "
    "and its length.",
    "sigma0": "Standard deviation of unit weight a posteriori over a priori: 1 if the residuals are as large "
    "as SIGMA says.",
    "Probability": "Of the chi-square test: how often v'Pv is as large or larger if the a priori standard "
    f"deviations hold. The verdict is on a level of {100 * LEVEL:g} %, both sides together.",
    "r": "Redundancy number, 0 to 1: the part of an error of a coordinate that its residual shows.",
    "w": "Baarda's normalized residual, by the a priori standard deviation; suspected beyond "
    f"{CRITICAL_W:.2f} ({ALPHA_SIGN} = {ALPHA:g}).",
    TAU: "Pope's studentized residual, by the a posteriori standard deviation of the scan; its limit "
    f"({ALPHA_SIGN} = {ALPHA:g}) depends on the redundancy.",
    "MDB": "Minimal detectable bias: the smallest error of a coordinate that the w-test finds with a power "
    f"of {100 * POWER:g} % ({DELTA}0 = {NONCENTRALITY:.2f}).",
    "95 % ellipse, ellipsoid": f"Semi-axes are {PLANE_FACTOR:.3f} (plane) and {SPACE_FACTOR:.3f} (space) "
    "standard deviations.",
    "Accidental matches": "How many are expected of as many targets, if the scan had nothing to do with the "
    "control points.",
    "Round": "1 if surveyed points sufficed to register the scan, 2 if it needed points appended in round 1, "
    "and so on.",
    "Scale": "What the targets say about the scale, in parts per million from 1, whether or not it was "
    "estimated.",
}


def write_report(registration: Registration, path: Path) -> None:
    """Write the report as one HTML page; some scan must be registered.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    anchors = {scan.name: f"scan-{number}" for number, scan in enumerate(registration.scans, start=1)}
    refused = [scan for scan in registration.scans if not scan.registered]
    write_page(
        path,
        "Registration of scans",
        paragraph(_result(registration)),
        notes(registration.warnings),
        _scans(registration, anchors),
        *(refused_section(scan, anchors[scan.name]) for scan in refused),
        section("Settings", _settings(registration)),
        section("Plan", site_plan(registration)),
        *(registered_section(scan, registration, anchors[scan.name]) for scan in registration.registered),
        _control(registration.points),
        section("What the numbers mean", definitions(LEGEND)),
    )


def _result(registration: Registration) -> str:
    done, scans = len(registration.registered), len(registration.scans)
    longest = 1000 * registration.max_residual
    return (
        f"{done} of {scans} scans {'is' if done == 1 else 'are'} registered; the longest residual is "
        f"{longest:.1f} mm. Global test of all scans together: {verdict(registration.test)}"
    )


def _scans(registration: Registration, anchors: dict) -> Markup:
    header = (
        "scan",
        "status",
        "targets",
        "matched",
        "rejected",
        "appended",
        "round",
        "sigma0",
        "probability",
        "longest v (mm)",
        "scale (ppm)",
        "accidental matches",
    )
    rows = [
        (link(scan.name, anchors[scan.name]), scan.status, str(scan.targets), *_summary(scan))
        for scan in registration.scans
    ]
    refused = [row for row, scan in enumerate(registration.scans) if not scan.registered]
    return section("Scans", table(header, rows, words=(0, 1), marked=refused))


def _summary(scan: ScanRegistration) -> tuple:
    if not scan.registered:
        return (MISSING,) * 9
    used = [item for item in scan.correspondences if item.used]
    scale = scan.scale_test
    return (
        str(len(used)),
        str(len(scan.correspondences) - len(used)),
        str(len(scan.unmatched)),
        str(scan.round),
        number(scan.test.sigma0, 2),
        number(scan.test.probability, 3),
        number(1000 * max(item.length for item in used), 1),
        f"{scale.deviation:.0f} \N{PLUS-MINUS SIGN} {scale.std:.0f}" if scale else MISSING,
        MISSING if scan.chance is None else f"{scan.chance:.1g}",
    )


def _settings(registration: Registration) -> Markup:
    settings, crs = registration.settings, registration.crs
    return table(
        ("setting", "value"),
        [
            ("matching", "by names" if settings.matching is Matching.NAMES else "by distances"),
            ("transformation", f"{MODELS[settings.model]}, {settings.model.unknowns} parameters"),
            ("standard deviation of a target", f"{1000 * settings.sigma:g} mm"),
            ("standard deviation of a control point", _control_sigma(settings)),
            ("tolerance of distances", _tolerance(registration)),
            (
                "coordinate reference system",
                (crs.to_string() if crs.to_epsg() else crs.to_wkt()) if crs else "none",
            ),
        ],
        words=(0, 1),
    )


def _control_sigma(settings: Settings) -> str:
    return f"{1000 * settings.control_sigma:g} mm" if settings.control_sigma else "0, held fixed"


def _tolerance(registration: Registration) -> str:
    origin = "derived" if registration.settings.tolerance is None else "chosen"
    return f"{1000 * registration.tolerance:.1f} mm, {origin}"


def _control(points: tuple[ControlPoint, ...]) -> Markup:
    header = ("name", "origin", "x", "y", "z", "sx", "sy", "sz", "scans")
    rows = [
        (
            point.name,
            point.origin,
            *(number(value, 4) for value in point.position),
            *(number(1000 * variance**0.5, 1) for variance in point.covariance.diagonal()),
            str(len(point.scans)),
        )
        for point in points
    ]
    caption = "Coordinates in metres, their standard deviations in millimetres; how many scans use the point."
    return section("Control points", table(header, rows, words=(0, 1), caption=caption))
