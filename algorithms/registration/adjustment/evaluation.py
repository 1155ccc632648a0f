"""The results of every scan and of every control point, from the adjusted block."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Optional

import numpy as np

from ..lists.point_list import PointList
from ..results import (
    REGISTERED,
    ControlPoint,
    Correspondence,
    Estimate,
    GlobalTest,
    Placement,
    ScaleTest,
    ScanRegistration,
)
from ..sequential_registration import SequentialRegistration
from ..settings import Settings
from .block_adjustment import Adjusted
from .least_squares import Sighting
from .parameters import parameters
from .scale_test import scale_test
from .similarity import Pose, parameter_design
from .statistical_tests import divided, global_test, spread_factor
from .target_covariances import in_control_frame

UNKNOWN = np.full(3, np.nan)


@dataclass(frozen=True)
class Frames:
    """What was subtracted from the coordinates before all computations.

    Attributes
    ----------
    control : ndarray, shape (3,)
    scans : dict of str to ndarray, shape (3,)
    """

    control: np.ndarray
    scans: dict[str, np.ndarray]


def refused_scan(scan: PointList, sequence: SequentialRegistration) -> ScanRegistration:
    """Return the result of a scan that was not registered."""
    refusal = sequence.refused[scan.name]
    return ScanRegistration(
        name=scan.name,
        status=refusal.status,
        reason=refusal.reason,
        targets=len(scan.names),
        rivals=refusal.rivals,
        warnings=scan.warnings,
    )


@dataclass(frozen=True)
class Evaluation:
    """An adjusted block, evaluated scan by scan and point by point.

    Attributes
    ----------
    sequence : SequentialRegistration
    adjusted : Adjusted
    settings : Settings
    frames : Frames
    """

    sequence: SequentialRegistration
    adjusted: Adjusted
    settings: Settings
    frames: Frames

    @property
    def test(self) -> GlobalTest:
        """The global test of the block."""
        block = self.adjusted.block
        return global_test(block.sum_of_squares, block.redundancy, self.settings.adjustment.tests)

    @cached_property
    def _spread(self) -> float:
        return spread_factor(self.test, self.settings.adjustment.tests)

    def scans(self, scans: Sequence[PointList]) -> tuple[ScanRegistration, ...]:
        """Return the result of each scan, in the given order."""
        numbers = {placed.scan.name: number for number, placed in enumerate(self.sequence.placed)}
        return tuple(
            self._registered(scan, numbers[scan.name])
            if scan.name in numbers
            else refused_scan(scan, self.sequence)
            for scan in scans
        )

    def _registered(self, scan: PointList, number: int) -> ScanRegistration:
        placed, block, settings = self.sequence.placed[number], self.adjusted.block, self.settings
        pose, used = block.poses[number], self.adjusted.used[number]
        centre = pose.centre + self.frames.scans[scan.name]
        whole = Pose(pose.rotation, pose.scale, centre, pose.position + self.frames.control)
        values, derivatives = parameters(whole, settings.model, settings.adjustment.layout)
        covariance = self._spread**2 * derivatives @ block.pose_cofactors[number] @ derivatives.T
        deviations = np.sqrt(np.diag(covariance))
        correspondences = self._correspondences(scan, number)
        matched = {item.target for item in correspondences}
        test = self.adjusted.tests[number]
        std = self._std(number)
        own = placed.scan.covariances
        sighting = Sighting(
            placed.scan.xyz[used], placed.labels[used], pose, None if own is None else own[used]
        )
        of_scale = scale_test(sighting, number, self.adjusted, settings) if placed.match else None
        return ScanRegistration(
            name=scan.name,
            status=REGISTERED,
            reason="",
            targets=len(scan.names),
            matrix=whole.matrix(),
            scale=float(whole.scale),
            estimates=tuple(
                Estimate(name, value, float(deviation))
                for (name, value), deviation in zip(values, deviations)
            ),
            std=std,
            correlations=divided(covariance, np.outer(deviations, deviations)),
            correspondences=correspondences,
            unmatched=tuple(name for name in scan.names if name not in matched),
            test=test,
            scale_test=of_scale,
            chance=placed.match.chance if placed.match else None,
            round=placed.round,
            placement=self._placement(number),
            warnings=(
                *scan.warnings,
                *(placed.match.warnings if placed.match else ()),
                *_misjudged_sigma(scan, test, settings),
                *_missing_scale(scan.name, of_scale, settings),
                *_inaccurate(scan.name, std, settings),
            ),
        )

    def _placement(self, number: int) -> Optional[Placement]:
        """Return how surfaces placed a scan, with the station after the adjustment."""
        placement, pose = self.sequence.placed[number].placement, self.adjusted.block.poses[number]
        if placement is None or placement.station is None:
            return placement
        return replace(placement, station=pose.apply(placement.station[None])[0] + self.frames.control)

    def _std(self, number: int) -> float:
        """Return the largest standard deviation of a transformed target in any direction, metres.

        A small sigma0 of few redundant observations does not make it smaller. Of a scan that surfaces placed,
        it is that of the scanner.
        """
        block, placed = self.adjusted.block, self.sequence.placed[number]
        targets = placed.scan.xyz
        if placed.placement is not None and placed.placement.station is not None:
            targets = placed.placement.station[None]
        if not len(targets):
            return 0.0
        design = parameter_design(block.poses[number].rotated(targets), self.settings.model)
        covariances = design @ block.pose_cofactors[number] @ np.swapaxes(design, 1, 2)
        return max(self._spread, 1.0) * float(np.sqrt(np.linalg.eigvalsh(covariances)[:, -1].max()))

    def _correspondences(self, scan: PointList, number: int) -> tuple[Correspondence, ...]:
        rows = {name: row for row, name in enumerate(self.sequence.placed[number].scan.names)}
        used = {int(row): position for position, row in enumerate(self.adjusted.used[number])}
        rejected = self.adjusted.rejected[number]
        return tuple(
            self._correspondence(name, number, rows[name], used.get(rows[name]))
            for name in scan.names
            if rows[name] in used or rows[name] in rejected
        )

    def _correspondence(self, name: str, number: int, row: int, position: Optional[int]) -> Correspondence:
        """Return a target and its point; `position` is that among the used targets, None if rejected."""
        placed, network, block = self.sequence.placed[number], self.sequence.network, self.adjusted.block
        pose, residuals = block.poses[number], block.targets[number]
        sigma0 = spread_factor(self.adjusted.tests[number], self.settings.adjustment.tests)
        used, point = position is not None, placed.labels[row]
        target = placed.scan.xyz[row : row + 1]
        design = parameter_design(pose.rotated(target), self.settings.model)[0]
        normalized = residuals.normalized[position] if used else self.adjusted.rejected[number][row]
        return Correspondence(
            target=name,
            control=network.names[point],
            surveyed=not network.sources[point],
            used=used,
            position=block.points[point] + self.frames.control,
            residual=pose.rotated(target)[0] + (pose.position - block.points[point]),
            redundancy=residuals.redundancy[position] if used else UNKNOWN,
            normalized=normalized,
            studentized=divided(normalized, np.full(3, sigma0)) if used else UNKNOWN,
            detectable=residuals.detectable[position] if used else UNKNOWN,
            covariance=self._spread**2 * design @ block.pose_cofactors[number] @ design.T,
        )

    def points(self, control: PointList) -> tuple[ControlPoint, ...]:
        """Return the surveyed points in the order of their list, then the appended ones."""
        network = self.sequence.network
        seen: dict[int, list[tuple[int, int]]] = {point: [] for point in range(len(network.names))}
        for number, placed in enumerate(self.sequence.placed):
            for row, point in enumerate(placed.labels):
                if row not in self.adjusted.rejected[number]:
                    seen[int(point)].append((number, row))
        rows = {name: row for row, name in enumerate(network.names[: len(control.names)])}
        order = [rows[name] for name in control.names] + list(range(len(control.names), len(network.names)))
        return tuple(self._point(row, seen[row]) for row in order if not network.origins[row] or seen[row])

    def _point(self, row: int, seen: list[tuple[int, int]]) -> ControlPoint:
        """Return a point; `seen` holds the scans that use it, and their targets."""
        network, placed = self.sequence.network, self.sequence.placed
        block, settings = self.adjusted.block, self.settings
        position, covariance = block.points[row], block.point_covariances[row]
        if network.origins[row] and len(seen) == 1:
            number, target = seen[0]
            pose, xyz = block.poses[number], placed[number].scan.xyz[target : target + 1]
            design = parameter_design(pose.rotated(xyz), settings.model)[0]
            position = pose.apply(xyz)[0]
            own = placed[number].scan.covariances
            of_target = in_control_frame(
                None if own is None else own[target : target + 1], 1, pose, settings.sigma
            )[0]
            covariance = design @ block.pose_cofactors[number] @ design.T + of_target
        elif not network.origins[row] and not seen:
            covariance = np.eye(3) * network.sigmas[row] ** 2
        return ControlPoint(
            name=network.names[row],
            position=position + self.frames.control,
            covariance=covariance,
            origin=network.sources[row] or "surveyed",
            scans=tuple(placed[number].scan.name for number, _ in seen),
        )


def _misjudged_sigma(scan: PointList, test: GlobalTest, settings: Settings) -> list[str]:
    """Warn if the residuals contradict the a priori standard deviations."""
    if not test.probability < settings.adjustment.tests.significance:
        return []
    if scan.has_covariances:
        return [
            f"The residuals of {scan.name} are {test.sigma0:.1f} times as large as the standard deviations "
            f"of its targets and of the control points suggest (chi-square probability "
            f"{test.probability:.1g}); look for wrong targets, or set CONTROL_SIGMA "
            "to how accurately the points were surveyed."
        ]
    return [
        f"The residuals of {scan.name} are {test.sigma0:.1f} times as large as SIGMA suggests (chi-square "
        f"probability {test.probability:.1g}); look for wrong targets, or set SIGMA to "
        f"{test.sigma0 * settings.sigma:.2g}."
    ]


def _inaccurate(name: str, std: float, settings: Settings) -> list[str]:
    """Warn of a scan whose position is uncertain, as at the end of a chain."""
    if std <= settings.std_limit:
        return []
    return [
        f"The targets of {name} have standard deviations of up to {1000 * std:.0f} mm, more than the limit "
        f"of {1000 * settings.std_limit:.0f} mm; survey control points in it, or connect it to more scans."
    ]


def _missing_scale(name: str, test: Optional[ScaleTest], settings: Settings) -> list[str]:
    """Warn of a scale that the model lacks."""
    return [f"{name}: {test.advice}"] if test and test.significant and not settings.model.scaled else []
