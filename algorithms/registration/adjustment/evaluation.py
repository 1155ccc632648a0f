"""The adjusted block in the words of `results`: matrices, parameters, residuals and tests of every scan."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy import stats

from ..lists.point_list import PointList
from ..results import (
    REGISTERED,
    ControlPoint,
    Correspondence,
    Estimate,
    ScaleTest,
    ScanRegistration,
)
from ..sequential_registration import Growth, Placed
from ..settings import Model, Settings
from .block_adjustment import Adjusted
from .least_squares import Sighting, adjust
from .similarity import Pose, parameter_design
from .statistical_tests import divided, global_test, spread_factor

SCALE_ALPHA = 0.01
"""Significance level of the test of the scale."""

LEVEL = 1e-6
"""Cosine of rotation_y below which rotation_x and rotation_z cannot be told apart."""

SHIFTS = ("shift_x", "shift_y", "shift_z")
ROTATIONS = ("rotation_x", "rotation_y", "rotation_z")


@dataclass(frozen=True)
class Frames:
    """What was taken off the coordinates before all computations.

    Attributes
    ----------
    control : ndarray, shape (3,)
    scans : dict of str to ndarray, shape (3,)
    """

    control: np.ndarray
    scans: dict


def describe_scans(
    scans: Sequence[PointList], growth: Growth, adjusted: Adjusted, settings: Settings, frames: Frames
) -> tuple[ScanRegistration, ...]:
    """Return the outcome of each scan, in the given order."""
    numbers = {placed.scan.name: number for number, placed in enumerate(growth.placed)}
    return tuple(
        _registered(scan, numbers[scan.name], growth, adjusted, settings, frames)
        if scan.name in numbers
        else _refused(scan, growth)
        for scan in scans
    )


def _refused(scan: PointList, growth: Growth) -> ScanRegistration:
    refusal = growth.refused[scan.name]
    return ScanRegistration(
        name=scan.name,
        status=refusal.status,
        reason=refusal.reason,
        targets=len(scan.names),
        rivals=refusal.rivals,
        warnings=scan.warnings,
    )


def _registered(
    scan: PointList, number: int, growth: Growth, adjusted: Adjusted, settings: Settings, frames: Frames
) -> ScanRegistration:
    placed, block = growth.placed[number], adjusted.block
    pose, cofactors = block.poses[number], block.pose_cofactors[number]
    whole = Pose(
        pose.rotation, pose.scale, pose.centre + frames.scans[scan.name], pose.place + frames.control
    )
    factor = spread_factor(global_test(block.sum_of_squares, block.redundancy))
    values, derivatives = _parameters(whole, settings.model)
    covariance = factor**2 * derivatives @ cofactors @ derivatives.T
    deviations = np.sqrt(np.diag(covariance))
    correspondences = _correspondences(scan, number, growth, adjusted, settings, frames)
    matched = {item.target for item in correspondences}
    test = adjusted.tests[number]
    scale_test = _scale_test(placed, number, adjusted, settings)
    return ScanRegistration(
        name=scan.name,
        status=REGISTERED,
        reason="",
        targets=len(scan.names),
        matrix=whole.matrix(),
        scale=float(whole.scale),
        estimates=tuple(
            Estimate(name, value, float(deviation)) for (name, value), deviation in zip(values, deviations)
        ),
        correlations=divided(covariance, np.outer(deviations, deviations)),
        correspondences=correspondences,
        unmatched=tuple(name for name in scan.names if name not in matched),
        test=test,
        scale_test=scale_test,
        chance=placed.found.chance,
        round=placed.round,
        warnings=(
            *scan.warnings,
            *placed.found.warnings,
            *_misjudged(scan.name, test, settings),
            *_unscaled(scan.name, scale_test, settings.model),
        ),
    )


def _misjudged(name: str, test, settings: Settings) -> list[str]:
    """Warn if the residuals contradict the a priori standard deviation."""
    if not test.probability < 0.001:
        return []
    return [
        f"The residuals of {name} are {test.sigma0:.1f} times as large as SIGMA says (chi-square probability "
        f"{test.probability:.1g}); look for wrong targets, or set SIGMA to "
        f"{test.sigma0 * settings.sigma:.2g}."
    ]


def _unscaled(name: str, test: Optional[ScaleTest], model: Model) -> list[str]:
    """Warn of a scale that the model lacks."""
    return [f"{name}: {test.advice}"] if test and test.significant and not model.scaled else []


def _parameters(pose: Pose, model: Model) -> tuple[list, np.ndarray]:
    """Return names and values of the parameters about the origin of the scan, and their derivatives.

    The rotation is R = Rx Ry Rz. The derivatives are by the unknowns of the adjustment, shape (u, u).
    """
    matrix = pose.matrix()
    values = list(zip(SHIFTS, matrix[:3, 3].tolist()))
    derivatives = np.zeros((model.unknowns, model.unknowns))
    derivatives[:3] = parameter_design(pose.turned(np.zeros((1, 3))), model)[0]
    if model.levelled:
        heading = np.degrees(np.arctan2(pose.rotation[1, 0], pose.rotation[0, 0]))
        values.append((ROTATIONS[2], float(heading)))
        derivatives[3, 3] = np.degrees(1.0)
    else:
        angles, by_turns = _angles(pose.rotation)
        values += zip(ROTATIONS, np.degrees(angles).tolist())
        derivatives[3:6, 3:6] = np.degrees(by_turns)
    if model.scaled:
        values.append(("scale", float(pose.scale)))
        derivatives[-1, -1] = pose.scale
    return values, derivatives


def _angles(rotation: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the angles of R = Rx Ry Rz in radians, and their derivatives by small turns about x, y, z."""
    y = np.arcsin(np.clip(rotation[0, 2], -1.0, 1.0))
    if np.cos(y) < LEVEL:
        # Only the sum or difference of the others is known; all of it goes to z.
        z = np.arctan2(rotation[1, 0], rotation[1, 1])
        return np.array([0.0, y, z]), np.full((3, 3), np.nan)
    x = np.arctan2(-rotation[1, 2], rotation[2, 2])
    z = np.arctan2(-rotation[0, 1], rotation[0, 0])
    about_y = np.array([0.0, np.cos(x), np.sin(x)])
    about_z = np.array([np.sin(y), -np.sin(x) * np.cos(y), np.cos(x) * np.cos(y)])
    turns = np.column_stack([[1.0, 0.0, 0.0], about_y, about_z])
    return np.array([x, y, z]), np.linalg.inv(turns)


def _correspondences(
    scan: PointList, number: int, growth: Growth, adjusted: Adjusted, settings: Settings, frames: Frames
) -> tuple[Correspondence, ...]:
    placed, network, block = growth.placed[number], growth.network, adjusted.block
    pose, used, residuals = block.poses[number], adjusted.used[number], block.targets[number]
    factor = spread_factor(global_test(block.sum_of_squares, block.redundancy))
    sigma0 = spread_factor(adjusted.tests[number])
    rows = {name: row for row, name in enumerate(placed.scan.names)}
    places = {int(row): place for place, row in enumerate(used)}
    nothing = np.full(3, np.nan)
    found = []
    for name in scan.names:
        row = rows[name]
        if row not in places and row not in adjusted.rejected[number]:
            continue
        point, place = placed.labels[row], places.get(row)
        target = placed.scan.xyz[row : row + 1]
        design = parameter_design(pose.turned(target), settings.model)[0]
        position = block.points[point]
        normalized = adjusted.rejected[number][row] if place is None else residuals.normalized[place]
        found.append(
            Correspondence(
                target=name,
                control=network.names[point],
                surveyed=not network.origins[point],
                used=place is not None,
                position=position + frames.control,
                residual=pose.turned(target)[0] + (pose.place - position),
                redundancy=nothing if place is None else residuals.redundancy[place],
                normalized=normalized,
                studentized=nothing if place is None else divided(normalized, np.full(3, sigma0)),
                detectable=nothing if place is None else residuals.detectable[place],
                covariance=factor**2 * design @ block.pose_cofactors[number] @ design.T,
            )
        )
    return tuple(found)


def _scale_test(placed: Placed, number: int, adjusted: Adjusted, settings: Settings) -> Optional[ScaleTest]:
    """Test the scale, if need be by an adjustment of the scan alone that has one."""
    model, block, used = settings.model, adjusted.block, adjusted.used[number]
    scaled = {Model.RIGID: Model.SIMILARITY, Model.LEVELLED: Model.LEVELLED_SCALE}.get(model, model)
    redundancy = 3 * len(used) - scaled.unknowns
    if redundancy <= 0:
        return None
    if model is scaled:
        pose, cofactors, test = block.poses[number], block.pose_cofactors[number], adjusted.tests[number]
    else:
        sighting = Sighting(placed.scan.xyz[used], placed.labels[used], block.poses[number])
        fixed = np.ones(len(block.points), bool)
        alone = adjust([sighting], block.points, fixed, scaled, settings.sigma)
        pose, cofactors = alone.poses[0], alone.pose_cofactors[0]
        test = global_test(alone.sum_of_squares, alone.redundancy)
    deviation = float(pose.scale) - 1.0
    std = float(pose.scale) * float(np.sqrt(cofactors[-1, -1])) * spread_factor(test)
    limit = stats.t.isf(SCALE_ALPHA / 2, max(test.redundancy, 1.0))
    significant = bool(abs(deviation) > limit * std)
    return ScaleTest(1e6 * deviation, 1e6 * std, significant, _advice(1e6 * deviation, significant, model))


def _advice(ppm: float, significant: bool, model: Model) -> str:
    if model is Model.UNKNOWN_SCALE:
        return f"One unit of the scan is {1 + ppm / 1e6:.6g} m."
    if not significant:
        return (
            "The scale does not differ from 1; a model without scale is enough."
            if model.scaled
            else "The scale does not differ from 1."
        )
    cause = (
        "as grid coordinates do that are not reduced for the projection"
        if 50 < abs(ppm) < 2000
        else "which points to the calibration of the scanner, or to too small a SIGMA"
    )
    remedy = (
        "keep the model with scale" if model.scaled else "choose a model with scale, or reduce the distances"
    )
    return f"The scale differs from 1 by {ppm:+.0f} ppm, {cause}; {remedy}."


def describe_points(
    control: PointList, growth: Growth, adjusted: Adjusted, settings: Settings, frames: Frames
) -> tuple[ControlPoint, ...]:
    """Return the surveyed points in the order of their list, then the appended ones."""
    network, block = growth.network, adjusted.block
    sightings: dict = {point: [] for point in range(len(network.names))}
    for number, placed in enumerate(growth.placed):
        for row, point in enumerate(placed.labels):
            if row not in adjusted.rejected[number]:
                sightings[int(point)].append((number, row))
    rows = {name: row for row, name in enumerate(network.names[: len(control.names)])}
    order = [rows[name] for name in control.names] + list(range(len(control.names), len(network.names)))
    return tuple(
        _point(row, sightings[row], growth, block, settings, frames)
        for row in order
        if not network.origins[row] or sightings[row]
    )


def _point(
    row: int, sightings: list, growth: Growth, block, settings: Settings, frames: Frames
) -> ControlPoint:
    network = growth.network
    position, covariance = block.points[row], block.point_covariances[row]
    if network.origins[row] and len(sightings) == 1:
        number, target = sightings[0]
        pose, xyz = block.poses[number], growth.placed[number].scan.xyz[target : target + 1]
        design = parameter_design(pose.turned(xyz), settings.model)[0]
        position = pose.apply(xyz)[0]
        covariance = design @ block.pose_cofactors[number] @ design.T + np.eye(3) * settings.sigma**2
    elif not network.origins[row] and not sightings:
        covariance = np.eye(3) * settings.control_sigma**2
    return ControlPoint(
        name=network.names[row],
        position=position + frames.control,
        covariance=covariance,
        origin=network.origins[row] or "surveyed",
        scans=tuple(growth.placed[number].scan.name for number, _ in sightings),
    )
