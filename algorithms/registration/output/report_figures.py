"""The figures of the report: the paper's 6 to 8."""

from collections.abc import Sequence
from typing import Optional, TypeVar

import numpy as np

from ...reporting.charts import bar_chart
from ...reporting.figures import COLOURS, GREY, INK, RED
from ...reporting.maps import Map
from ...reporting.numbers import round_step
from ..results import ControlPoint, Correspondence, Registration, ScanRegistration
from .layers import PLANE_FACTOR, exaggeration

Item = TypeVar("Item", ControlPoint, Correspondence)

SURVEYED, APPENDED, RESIDUAL, PALE = COLOURS[0], COLOURS[3], COLOURS[1], "#dbe3e7"

FARTHEST = 10.0
"""Largest distance of a station from the middle of its targets, in units of the largest of a target."""


def site_plan(registration: Registration) -> tuple[str, str]:
    """Return the plan of all scans and its caption: stations, rays, and the precision of appended points."""
    scans, points = registration.registered, registration.points
    hubs = np.array([_hub(scan) for scan in scans])
    surveyed, appended = _split(points)
    seen = sorted(points, key=lambda point: not point.scans)
    with Map.around(np.vstack([hubs, _places(points)])) as plan:
        for number, (hub, scan) in enumerate(zip(hubs, scans)):
            plan.rays(hub, _places(scan.correspondences), COLOURS[number % len(COLOURS)], 0.7)
        plan.dots(_places(surveyed), SURVEYED)
        plan.dots(_places(appended), APPENDED)
        times = _ellipse_times(appended, plan)
        for point in appended:
            plan.ellipse(point.position[:2], point.covariance[:2, :2], times * PLANE_FACTOR, APPENDED)
        plan.triangles(_stations(scans), INK)
        plan.names(
            np.vstack([hubs, _places(seen)]),
            [*(scan.name for scan in scans), *(point.name for point in seen)],
            ["strong"] * len(scans) + [""] * len(seen),
            leading=len(scans),
        )
        drawing = plan.svg()
    ellipses = f", with 95 % ellipses drawn {times:g} times too large" if appended else ""
    return (
        drawing,
        "Plan (figure 6 of the paper). Triangles: stations, with lines to the points that they use. Blue: "
        f"surveyed points. Violet: points appended from scans{ellipses}. Where there is no room, names "
        "are left out.",
    )


def scan_plan(scan: ScanRegistration, registration: Registration) -> tuple[str, str]:
    """Return the plan of one scan and its caption: its station, its targets, their residuals enlarged."""
    used = [item for item in scan.correspondences if item.used]
    rejected = [item for item in scan.correspondences if not item.used]
    surveyed, appended = _split(used)
    hub, others = _hub(scan), _places(registration.points)
    times = exaggeration([scan])
    residuals = np.array([item.residual[:2] for item in used]).reshape(-1, 2)
    with Map.around(np.vstack([hub, _places(scan.correspondences)]), tallest=460.0) as plan:
        plan.dots(others[plan.shows(others)], GREY, 3.0)
        plan.rays(hub, _places(scan.correspondences), PALE)
        plan.dots(_places(surveyed), SURVEYED)
        plan.dots(_places(appended), APPENDED)
        plan.crosses(_places(rejected), RED)
        plan.arrows(_places(used), _places(used) + times * residuals, RESIDUAL)
        plan.triangles(_stations([scan]), INK)
        plan.names(
            np.vstack([hub, _places(used), _places(rejected)]),
            [scan.name, *(item.control for item in (*used, *rejected))],
            ["strong"] + [""] * len(used) + ["red"] * len(rejected),
        )
        drawing = plan.svg()
    crosses = " Crosses: rejected targets." if rejected else ""
    return (
        drawing,
        f"Plan (figure 6). Arrows: horizontal residuals, drawn {times} times too large, from control point "
        f"to target. Blue: surveyed, violet: appended, grey: points that {scan.name} does not use.{crosses}",
    )


def residual_bars(scan: ScanRegistration) -> tuple[str, str]:
    """Return the residuals of a scan as bars: their components, and their lengths."""
    items = scan.correspondences
    names = [item.control for item in items]
    rejected = [not item.used for item in items]
    components = 1000 * np.array([item.residual for item in items])
    lengths = np.linalg.norm(components, axis=1)
    longest = 1.1 * float(lengths[[item.used for item in items]].max()) or None
    return (
        bar_chart(names, dict(zip(("vx", "vy", "vz"), components.T)), "mm", longest, rejected),
        bar_chart(names, {"v": lengths}, "mm", longest, rejected, height=144.0),
    )


def _hub(scan: ScanRegistration) -> np.ndarray:
    """Return the station that saw the targets of a scan, or the middle of the targets if it is not known."""
    station = _station(scan)
    return _middle(scan) if station is None else station


def _station(scan: ScanRegistration) -> Optional[np.ndarray]:
    """Return the origin of a scan; None if that is far away, as it is in a cloud that was moved before."""
    if scan.matrix is None:
        return None
    if scan.placement is not None and scan.placement.station is not None:
        return scan.placement.station[:2]
    if not scan.correspondences:
        return scan.matrix[:2, 3]
    middle, origin = _middle(scan), scan.matrix[:2, 3]
    spread = np.linalg.norm(_places(scan.correspondences) - middle, axis=1).max()
    return origin if np.linalg.norm(origin - middle) <= FARTHEST * spread else None


def _middle(scan: ScanRegistration) -> np.ndarray:
    return _places(scan.correspondences).mean(axis=0)


def _stations(scans: Sequence[ScanRegistration]) -> np.ndarray:
    """Return the stations that are known, shape (n, 2)."""
    stations = [_station(scan) for scan in scans]
    return np.array([station for station in stations if station is not None]).reshape(-1, 2)


def _split(items: Sequence[Item]) -> tuple[list[Item], list[Item]]:
    """Return the points or correspondences that are surveyed, and the others."""
    return [item for item in items if item.surveyed], [item for item in items if not item.surveyed]


def _places(items: Sequence[Item]) -> np.ndarray:
    """Return the plane positions of points or correspondences, shape (n, 2)."""
    return np.array([item.position[:2] for item in items]).reshape(-1, 2)


def _ellipse_times(points: Sequence[ControlPoint], plan: Map) -> float:
    """Return how many times too large ellipses are drawn, so that the largest is well seen."""
    wanted = 0.04 * plan.diagonal * min(1.0, (20 / max(len(points), 1)) ** 0.5)
    largest = max((float(np.linalg.eigvalsh(point.covariance[:2, :2])[-1]) for point in points), default=0.0)
    return round_step(wanted / (PLANE_FACTOR * largest**0.5)) if largest > 0 else 1.0
