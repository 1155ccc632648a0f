"""Scan after scan, the control points grow (paper, chapter 4)."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.distance import cdist

from ..progress import Progress
from .adjustment.control_network import Network
from .adjustment.scan_adjustment import Fit, fit_scan
from .adjustment.similarity import Pose, parameter_design
from .adjustment.target_layout import line_width
from .lists.point_list import PointList
from .matching.control_points import GATE, factor_of
from .matching.scan_matching import Found, find_scan
from .settings import Matching, Settings

CERTAIN = 1e-8
"""Expected number of accidental matches below which a scan is registered at once."""

NEAR_MISS = 3.0
"""A target closer to a control point than this many tolerances (eps_D of the paper) is no new point."""


@dataclass(frozen=True)
class Placed:
    """A scan that stands on control points.

    Attributes
    ----------
    scan : PointList
    found : Found
    round : int
        1 if surveyed points sufficed.
    pose : Pose
    cofactors : ndarray, shape (u, u)
        Covariance of the parameters, by the a priori standard deviations.
    labels : ndarray of int, shape (n,)
        The point of each target: its control point, also of those that were rejected, or the point that was
        appended for it.
    rejected : dict of int to ndarray, shape (3,)
        Rows of targets that are not used, with Baarda's w that led to it; nan if they are too far off.
    """

    scan: PointList
    found: Found
    round: int
    pose: Pose
    cofactors: np.ndarray
    labels: np.ndarray
    rejected: dict


@dataclass(frozen=True)
class Growth:
    """What came of all scans.

    Attributes
    ----------
    network : Network
    placed : tuple of Placed
        In the order in which the scans were registered.
    refused : dict of str to Refusal
        By the name of the scan.
    """

    network: Network
    placed: tuple[Placed, ...]
    refused: dict


def grow(scans: dict, network: Network, settings: Settings, progress: Progress = Progress()) -> Growth:
    """Register scans in the order that works, and append their unmatched targets.

    Parameters
    ----------
    scans : dict of str to PointList
        Near the origin.
    network : Network
        The surveyed points.
    settings : Settings
    progress : Progress
    """
    placed: list[Placed] = []
    waiting = dict(sorted(scans.items()))
    turn = 0
    while waiting:
        turn += 1
        found: dict = {}
        for name, scan in waiting.items():
            progress.update(len(placed) / len(scans), f"Matching {name}")
            result = find_scan(scan, network, settings, explain=False)
            if isinstance(result, Found):
                found[name] = result
        if not found:
            break
        for name in _well_founded(found):
            scan, network = _place(waiting.pop(name), found[name], network, settings, turn)
            placed.append(scan)
    refused = {name: find_scan(scan, network, settings) for name, scan in waiting.items()}
    return Growth(network, tuple(placed), refused)


def _well_founded(found: dict) -> list[str]:
    """Return the scans to register now: all that are certain, or else the most certain one.

    What little speaks for may be accidental, and would mislead the others; with more points it may become
    certain.
    """
    order = sorted(found, key=lambda name: (found[name].chance or 0.0, -found[name].solution.matched))
    certain = [name for name in order if (found[name].chance or 0.0) <= CERTAIN]
    return certain or order[:1]


def _place(
    scan: PointList, found: Found, network: Network, settings: Settings, turn: int
) -> tuple[Placed, Network]:
    """Adjust a scan onto the network, and append its unmatched targets to it."""
    labels = found.solution.labels.copy()
    fit, network = _fitted(scan.xyz, labels, network, settings)
    # Points that were appended since the scan was matched are as good as any other.
    more = _joining(scan, fit, labels, network, settings)
    if more:
        labels[list(more)] = list(more.values())
        fit, network = _fitted(scan.xyz, labels, network, settings)
    rows = np.flatnonzero(labels >= 0)
    used = rows[fit.used]
    rejected = {int(rows[number]): normalized for number, normalized in fit.rejected.items()}
    labels[list(rejected)] = -1
    for row, point in _near_misses(scan, fit.pose, labels, network, settings).items():
        labels[row] = point
        rejected.setdefault(row, np.full(3, np.nan))
    rejected = {row: normalized for row, normalized in rejected.items() if labels[row] >= 0}
    fresh = np.flatnonzero(labels < 0)
    network = _appended(scan, fit, fresh, labels[used], network, settings.sigma)
    labels[fresh] = len(network.names) - len(fresh) + np.arange(len(fresh))
    return Placed(scan, found, turn, fit.pose, fit.cofactors, labels, rejected), network


def _fitted(
    targets: np.ndarray, labels: np.ndarray, network: Network, settings: Settings
) -> tuple[Fit, Network]:
    rows = np.flatnonzero(labels >= 0)
    network = network.with_related(labels[rows])
    fit = fit_scan(
        targets[rows],
        network.points[labels[rows]],
        network.covariance_of(labels[rows]),
        settings.model,
        settings.sigma,
        line_width(targets, settings),
    )
    return fit, network


def _joining(scan: PointList, fit: Fit, labels: np.ndarray, network: Network, settings: Settings) -> dict:
    """Return the appended points that unmatched targets are, by the rows of the targets."""
    free = np.flatnonzero(labels < 0)
    points = np.setdiff1d(np.flatnonzero(~network.surveyed), labels)
    if not len(free) or not len(points):
        return {}
    gate = (GATE * factor_of(settings.tolerance, settings.sigma, settings.control_sigma)) ** 2
    used = labels[labels >= 0][fit.used]
    placed = fit.pose.apply(scan.xyz[free])
    design = parameter_design(fit.pose.turned(scan.xyz[free]), settings.model)
    found: dict = {}
    taken: dict = {}
    for row, place, derivatives in zip(free, placed, design):
        nearest = points[np.linalg.norm(network.points[points] - place, axis=1).argmin()]
        if settings.matching is Matching.NAMES:
            same = [point for point in points if network.labels[point] == scan.names[row]]
            if not same:
                continue
            nearest = same[0]
        gap = network.points[nearest] - place
        both = derivatives @ fit.gain @ network.covariance_between(used, nearest)
        covariance = derivatives @ fit.cofactors @ derivatives.T + np.eye(3) * settings.sigma**2
        covariance += network.covariance_of(np.array([nearest])) - both - both.T
        distance = float(gap @ np.linalg.solve(covariance, gap))
        if distance <= gate and distance < taken.get(nearest, np.inf):
            found = {other: point for other, point in found.items() if point != nearest}
            found[int(row)], taken[nearest] = int(nearest), distance
    return found


def _near_misses(
    scan: PointList, pose: Pose, labels: np.ndarray, network: Network, settings: Settings
) -> dict:
    """Return the control points that unmatched targets nearly are, or are by name, by their rows."""
    factor = factor_of(settings.tolerance, settings.sigma, settings.control_sigma)
    limit = NEAR_MISS * factor * np.sqrt(2 * (settings.sigma**2 + settings.control_sigma**2))
    free = np.flatnonzero(labels < 0)
    away = cdist(pose.apply(scan.xyz[free]), network.points)
    away[:, labels[labels >= 0]] = np.inf
    found: dict = {}
    for row, distances in zip(free, away):
        named = [point for point, label in enumerate(network.labels) if label == scan.names[row]]
        if settings.matching is Matching.NAMES and named:
            found[int(row)] = named[0]
        elif distances.min() <= limit:
            found[int(row)] = int(distances.argmin())
    return found


def _appended(
    scan: PointList, fit: Fit, rows: np.ndarray, used: np.ndarray, network: Network, sigma: float
) -> Network:
    """Append targets, with the covariance that they get from the control points and the scan."""
    if not len(rows):
        return network
    design = fit.pose.turned(scan.xyz[rows])
    design = parameter_design(design, fit.model).reshape(-1, fit.model.unknowns)
    covariance = design @ fit.cofactors @ design.T + np.eye(len(design)) * sigma**2
    with_loose = design @ fit.gain @ network.covariance_with_loose(used)
    names = tuple(scan.names[row] for row in rows)
    return network.appended(scan.name, names, fit.pose.apply(scan.xyz[rows]), covariance, with_loose)
