"""REPORT: a registration as a page to read, print and keep."""

from collections.abc import Sequence
from pathlib import Path

from ...reporting.numbers import MISSING, number
from ...reporting.page import write_page
from ..adjustment.settings import OutlierTestSettings
from ..results import ControlPoint, Registration, ScanRegistration, SharedSurfaces
from ..settings import Matching, Model, Settings
from .layers import PLANE_FACTOR, SPACE_FACTOR
from .report_figures import site_plan
from .report_scan import TAU, scan_content, verdict

TEMPLATE = Path(__file__).parent / "templates" / "registration.html"

MODELS = {
    Model.RIGID: "rigid",
    Model.SIMILARITY: "with a scale near 1",
    Model.LEVELLED: "levelled",
    Model.LEVELLED_SCALE: "levelled with a scale near 1",
    Model.UNKNOWN_SCALE: "unknown scale",
}

MOST_RIVALS = 12
"""Solutions that are listed of a scan that has several."""

ALPHA_SIGN = "\N{GREEK SMALL LETTER ALPHA}"
NONCENTRALITY_SIGN = "\N{GREEK SMALL LETTER DELTA}\N{SUBSCRIPT ZERO}"


def write_report(registration: Registration, path: Path) -> None:
    """Write the report as one HTML page; some scan must be registered.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    refused = [scan for scan in registration.scans if not scan.registered]
    tests = registration.settings.adjustment.tests
    plan, plan_caption = site_plan(registration)
    write_page(
        path,
        TEMPLATE,
        anchors={scan.name: f"scan-{place}" for place, scan in enumerate(registration.scans, start=1)},
        result=_result(registration),
        warnings=registration.warnings,
        scans=[(scan.name, scan.status, [str(scan.targets), *_summary(scan)]) for scan in registration.scans],
        refused_scans=refused,
        refused_names={scan.name for scan in refused},
        most_rivals=MOST_RIVALS,
        settings=_settings(registration),
        plan=plan,
        plan_caption=plan_caption,
        registered_scans=[scan_content(scan, registration) for scan in registration.registered],
        weak=tests.weak_redundancy,
        critical_w=tests.critical_w,
        surfaces=[_shared(item) for item in registration.surfaces],
        control=_control(registration.points),
        legend=_legend(tests),
    )


def _legend(tests: OutlierTestSettings) -> dict[str, str]:
    """Return the columns of the tables and what they mean."""
    return {
        "v": "Residual: the transformed target minus its control point, along x, y and z of the control "
        "points, and its length.",
        "sigma0": "Standard deviation of unit weight a posteriori over a priori: 1 if the residuals are as "
        "large as SIGMA says.",
        "Probability": "Of the chi-square test: how often v'Pv is as large or larger if the a priori "
        f"standard deviations hold. The verdict is on a level of {100 * tests.global_significance:g} %, both "
        "sides together.",
        "r": "Redundancy number, 0 to 1: the part of an error of a coordinate that its residual shows.",
        "w": "Baarda's normalized residual, by the a priori standard deviation; suspected beyond "
        f"{tests.critical_w:.2f} ({ALPHA_SIGN} = {tests.significance:g}).",
        TAU: "Pope's studentized residual, by the a posteriori standard deviation of the scan; its limit "
        f"({ALPHA_SIGN} = {tests.significance:g}) depends on the redundancy.",
        "MDB": "Minimal detectable bias: the smallest error of a coordinate that the w-test finds with a "
        f"power of {100 * tests.power:g} % ({NONCENTRALITY_SIGN} = {tests.noncentrality:.2f}).",
        "95 % ellipse, ellipsoid": f"Semi-axes are {PLANE_FACTOR:.3f} (plane) and {SPACE_FACTOR:.3f} (space) "
        "standard deviations.",
        "Accidental matches": "How many are expected of as many targets, if the scan had nothing to do with "
        "the control points.",
        "Round": "1 if surveyed points sufficed to register the scan, 2 if it needed points appended in "
        "round 1, and so on.",
        "Shared surfaces": "Patches of about a metre that two scans share; overlap: the part of the surface "
        "of the scan with less that the other has too; distance: how far the patches of both lie apart after "
        "the adjustment, root mean square; slides: whether they leave a direction free, which only targets "
        "or other scans hold.",
        "Scale": "What the targets say about the scale, in parts per million from 1, whether or not it was "
        "estimated.",
    }


def _result(registration: Registration) -> str:
    done, scans = len(registration.registered), len(registration.scans)
    if not registration.points:
        return f"{done} of {scans} scans are registered, by their surfaces alone."
    longest = 1000 * registration.max_residual
    tests = registration.settings.adjustment.tests
    return (
        f"{done} of {scans} scans {'is' if done == 1 else 'are'} registered; the longest residual is "
        f"{longest:.1f} mm. Global test of all scans together: {verdict(registration.test, tests)}"
    )


def _summary(scan: ScanRegistration) -> tuple[str, ...]:
    """Return what the table of scans shows besides name, status and number of targets."""
    if scan.test is None:
        return (MISSING,) * 9
    used = [item for item in scan.correspondences if item.used]
    scale = scan.scale_test
    return (
        str(len(used)),
        str(len(scan.correspondences) - len(used)),
        str(len(scan.unmatched)),
        MISSING if scan.round is None else str(scan.round),
        number(scan.test.sigma0, 2),
        number(scan.test.probability, 3),
        number(1000 * max((item.length for item in used), default=float("nan")), 1),
        f"{scale.deviation:.0f} \N{PLUS-MINUS SIGN} {scale.std:.0f}" if scale else MISSING,
        MISSING if scan.chance is None else f"{scan.chance:.1g}",
    )


def _settings(registration: Registration) -> list[tuple[str, str]]:
    settings, crs = registration.settings, registration.crs
    return [
        ("matching", "by names" if settings.matching is Matching.NAMES else "by distances"),
        ("transformation", f"{MODELS[settings.model]}, {settings.model.unknowns} parameters"),
        ("standard deviation of a target without its own", f"{1000 * settings.sigma:g} mm"),
        ("standard deviation of a control point", _control_sigma(settings)),
        ("tolerance of distances", _tolerance(registration)),
        (
            "coordinate reference system",
            (crs.to_string() if crs.to_epsg() else crs.to_wkt()) if crs else "none",
        ),
    ]


def _control_sigma(settings: Settings) -> str:
    return f"{1000 * settings.control_sigma:g} mm" if settings.control_sigma else "0, held fixed"


def _tolerance(registration: Registration) -> str:
    origin = "derived" if registration.settings.tolerance is None else "chosen"
    return f"{1000 * registration.tolerance:.1f} mm, {origin}"


def _shared(item: SharedSurfaces) -> tuple[str, ...]:
    slides = "yes" if len(item.free) else "no"
    return (*item.scans, str(item.patches), f"{100 * item.overlap:.0f}", number(1000 * item.rms, 2), slides)


def _control(points: Sequence[ControlPoint]) -> list[tuple[str, ...]]:
    return [
        (
            point.name,
            point.origin,
            *(number(value, 4) for value in point.position),
            *(number(1000 * variance**0.5, 1) for variance in point.covariance.diagonal()),
            str(len(point.scans)),
        )
        for point in points
    ]
