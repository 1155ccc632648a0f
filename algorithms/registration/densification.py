"""The densification of the control network by the targets of a registered scan."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy.linalg import block_diag
from scipy.spatial.distance import cdist

from .adjustment.control_network import ControlNetwork
from .adjustment.scan_adjustment import Fit, fit_scan
from .adjustment.similarity import Pose, parameter_design
from .adjustment.target_covariances import in_control_frame
from .adjustment.target_layout import line_width
from .lists.point_list import PointList
from .matching.scan_matching import ScanMatch
from .results import Placement
from .settings import Settings


@dataclass(frozen=True)
class PlacedScan:
    """A scan that was registered to control points.

    Attributes
    ----------
    scan : PointList
    match : ScanMatch or None
        None if targets did not place the scan.
    round : int or None
        1 if surveyed points sufficed; None if targets did not place the scan.
    pose : Pose
    labels : ndarray of int, shape (n,)
        The point of each target: its control point, also of those that were rejected, or the point that was
        appended for it.
    rejected : dict of int to ndarray, shape (3,)
        Rows of targets that are not used, with Baarda's w that led to it; nan if they are too far off to be
        tested.
    placement : Placement or None
        How surfaces placed the scan, if they did.
    """

    scan: PointList
    match: Optional[ScanMatch]
    round: Optional[int]
    pose: Pose
    labels: np.ndarray
    rejected: dict[int, np.ndarray]
    placement: Optional[Placement] = None

    @property
    def held(self) -> bool:
        """Whether the frame of the scan is the frame of all, because there are no control points."""
        return self.match is None and self.placement is None


def placed_scan(
    scan: PointList, match: ScanMatch, network: ControlNetwork, settings: Settings, number: int
) -> tuple[PlacedScan, ControlNetwork]:
    """Adjust a scan to the network, and append its unmatched targets to it.

    Parameters
    ----------
    scan : PointList
    match : ScanMatch
    network : ControlNetwork
    settings : Settings
    number : int
        Of the round.
    """
    labels = match.solution.labels.copy()
    fit, network = _fitted(scan, labels, network, settings)
    # Other scans may have appended points since this one was matched.
    more = _appended_matches(scan, fit, labels, network, settings)
    if more:
        labels[list(more)] = list(more.values())
        fit, network = _fitted(scan, labels, network, settings)
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
    return PlacedScan(scan, match, number, fit.pose, labels, rejected), network


def _fitted(
    scan: PointList, labels: np.ndarray, network: ControlNetwork, settings: Settings
) -> tuple[Fit, ControlNetwork]:
    rows = np.flatnonzero(labels >= 0)
    network = network.with_correlated(labels[rows])
    fit = fit_scan(
        scan.xyz[rows],
        network.points[labels[rows]],
        network.covariance_of(labels[rows]),
        settings,
        line_width(scan.xyz, settings),
        scan.covariances_of(rows),
    )
    return fit, network


def _appended_matches(
    scan: PointList, fit: Fit, labels: np.ndarray, network: ControlNetwork, settings: Settings
) -> dict[int, int]:
    """Return the appended points that unmatched targets match, by the rows of the targets."""
    free = np.flatnonzero(labels < 0)
    points = np.setdiff1d(np.flatnonzero(~network.surveyed), labels)
    if not len(free) or not len(points):
        return {}
    limit = (settings.matches.tolerances.position_factor * settings.distance_factor) ** 2
    used = labels[labels >= 0][fit.used]
    placed = fit.pose.apply(scan.xyz[free])
    design = parameter_design(fit.pose.rotated(scan.xyz[free]), settings.model)
    found: dict[int, int] = {}
    taken: dict[int, float] = {}
    for row, position, derivatives in zip(free, placed, design):
        nearest = points[np.linalg.norm(network.points[points] - position, axis=1).argmin()]
        if settings.named:
            same = [point for point in points if network.labels[point] == scan.names[row]]
            if not same:
                continue
            nearest = same[0]
        gap = network.points[nearest] - position
        both = derivatives @ fit.gain @ network.covariance_between(used, nearest)
        covariance = derivatives @ fit.cofactors @ derivatives.T + np.eye(3) * settings.sigma**2
        covariance += network.covariance_of(np.array([nearest])) - both - both.T
        distance = float(gap @ np.linalg.solve(covariance, gap))
        if distance <= limit and distance < taken.get(nearest, np.inf):
            found = {other: point for other, point in found.items() if point != nearest}
            found[int(row)], taken[nearest] = int(nearest), distance
    return found


def _near_misses(
    scan: PointList, pose: Pose, labels: np.ndarray, network: ControlNetwork, settings: Settings
) -> dict[int, int]:
    """Return the control points that unmatched targets nearly match, or match by name, by their rows."""
    factor = settings.matches.tolerances.near_miss_factor * settings.distance_factor
    limit = factor * np.sqrt(2 * (settings.sigma**2 + settings.control_sigma**2))
    free = np.flatnonzero(labels < 0)
    away = cdist(pose.apply(scan.xyz[free]), network.points)
    away[:, labels[labels >= 0]] = np.inf
    found: dict[int, int] = {}
    for row, distances in zip(free, away):
        named = [point for point, label in enumerate(network.labels) if label == scan.names[row]]
        if settings.named and named:
            found[int(row)] = named[0]
        elif distances.min() <= limit:
            found[int(row)] = int(distances.argmin())
    return found


def _appended(
    scan: PointList, fit: Fit, rows: np.ndarray, used: np.ndarray, network: ControlNetwork, sigma: float
) -> ControlNetwork:
    """Append targets, with the covariance that follows from the control points and the scan."""
    if not len(rows):
        return network
    design = fit.pose.rotated(scan.xyz[rows])
    design = parameter_design(design, fit.model).reshape(-1, fit.model.unknowns)
    of_targets = block_diag(*in_control_frame(scan.covariances_of(rows), len(rows), fit.pose, sigma))
    covariance = design @ fit.cofactors @ design.T + of_targets
    with_loose = design @ fit.gain @ network.covariance_with_loose(used)
    names = tuple(scan.names[row] for row in rows)
    return network.appended(scan.name, names, fit.pose.apply(scan.xyz[rows]), covariance, with_loose)
