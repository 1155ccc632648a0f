"""The block adjustment: what it minimises, and what it says about its observations."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.least_squares import Sighting, adjust
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

SIGMA = 0.003
ALL = np.arange(len(HALL))
SURVEYED = np.ones(len(HALL), bool)


def sighting(noise=SIGMA, seed=0, heading=40.0, rows=ALL, points=HALL, model=Model.RIGID):
    targets, _ = scanned(points, heading=heading, noise=noise, seed=seed)
    return Sighting(targets[rows], np.asarray(rows), fit_pose(points[rows], targets[rows], model))


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY, Model.LEVELLED, Model.LEVELLED_SCALE])
def test_the_closed_form_is_the_adjustment_of_one_scan_with_fixed_points(model):
    one = sighting(model=model)
    block = adjust([one], HALL, SURVEYED, model, SIGMA)

    assert block.poses[0].matrix() == pytest.approx(one.pose.matrix(), abs=1e-8)
    assert block.redundancy == 24 - model.unknowns
    assert block.targets[0].redundancy.sum() == pytest.approx(block.redundancy)
    assert np.array_equal(block.points, HALL) and not block.point_covariances.any()
    squares = (block.targets[0].residuals ** 2).sum() / SIGMA**2
    assert block.sum_of_squares == pytest.approx(squares)


def test_surveyed_points_with_a_standard_deviation_take_their_share_of_the_residuals():
    block = adjust([sighting()], HALL, SURVEYED, Model.RIGID, SIGMA, control_sigma=SIGMA)

    assert block.redundancy == 18
    assert block.control.residuals == pytest.approx(block.targets[0].residuals, abs=1e-9)
    redundancy = block.targets[0].redundancy.sum() + np.nansum(block.control.redundancy)
    assert redundancy == pytest.approx(block.redundancy)


def test_a_point_that_two_scans_see_joins_them():
    surveyed = SURVEYED.copy()
    surveyed[5:] = False
    scans = [sighting(seed=1), sighting(seed=2, heading=200.0)]
    start = HALL + np.where(surveyed[:, None], 0.0, 0.01)
    block = adjust(scans, start, surveyed, Model.RIGID, SIGMA)

    assert block.redundancy == 48 - 12 - 9
    assert block.points[5:] == pytest.approx(HALL[5:], abs=0.01)
    assert (np.sqrt(np.diagonal(block.point_covariances[5:], axis1=1, axis2=2)) < SIGMA).all()
    assert np.isnan(block.control.residuals).all(), "points held fixed are not observed"


def test_an_observation_that_nothing_checks_has_no_test():
    rows = [0, 1]
    one = sighting(rows=rows, model=Model.LEVELLED)
    block = adjust([one], HALL, SURVEYED, Model.LEVELLED, SIGMA)

    assert block.redundancy == 2
    unchecked = block.targets[0].redundancy < 1e-9
    assert np.isnan(block.targets[0].detectable[unchecked]).all()
    assert np.isfinite(block.targets[0].detectable[~unchecked]).all()


def test_statistics_are_those_of_many_simulated_scans():
    blocks = [adjust([sighting(seed=seed)], HALL, SURVEYED, Model.RIGID, SIGMA) for seed in range(300)]
    w = np.array([block.targets[0].normalized for block in blocks])

    assert w.std() == pytest.approx(1.0, abs=0.04)
    assert np.mean([block.sum_of_squares for block in blocks]) == pytest.approx(18.0, abs=1.0)


def needles(targets, along=0.004, across=0.0005):
    """Return covariances of targets that are exact across the ray and poor along it, shape (k, 3, 3)."""
    rays = targets / np.linalg.norm(targets, axis=1)[:, None]
    outer = rays[:, :, None] * rays[:, None, :]
    return across**2 * np.eye(3) + (along**2 - across**2) * outer


def with_covariances(seed=0, heading=40.0, rows=ALL):
    exact, _ = scanned(HALL, heading=heading)
    covariances = needles(exact)[rows]
    noise = np.random.default_rng(seed).normal(size=(len(rows), 3))
    targets = exact[rows] + np.einsum("kab,kb->ka", np.linalg.cholesky(covariances), noise)
    return Sighting(targets, np.asarray(rows), fit_pose(HALL[rows], targets, Model.RIGID), covariances)


def test_targets_with_covariances_have_the_statistics_of_an_independent_solution():
    """The independent one is dense: numeric derivatives of whitened residuals, then textbook formulas."""
    one, control_sigma = with_covariances(), 0.001
    free = np.arange(len(HALL)) < 4
    sigmas = np.where(free, control_sigma, 0.0)
    block = adjust([one], HALL, SURVEYED, Model.RIGID, SIGMA, control_sigma=sigmas)

    def observed(unknowns):
        points = HALL.copy()
        points[free] += unknowns[6:].reshape(-1, 3)
        turned = one.targets @ Rotation.from_rotvec(unknowns[:3]).as_matrix().T + unknowns[3:6]
        return np.concatenate([(turned - points).ravel(), unknowns[6:]])

    rotation = block.poses[0].rotation
    cofactors = np.zeros((36, 36))
    for number, covariance in enumerate(one.covariances):
        cofactors[3 * number : 3 * number + 3, 3 * number : 3 * number + 3] = (
            rotation @ covariance @ rotation.T
        )
    cofactors[24:, 24:] = np.eye(12) * control_sigma**2
    whitening = np.linalg.inv(np.linalg.cholesky(cofactors))
    start = np.r_[Rotation.from_matrix(one.pose.rotation).as_rotvec(), one.pose.matrix()[:3, 3], np.zeros(12)]
    solution = least_squares(lambda x: whitening @ observed(x), start, "3-point", xtol=1e-15, ftol=1e-15)
    v, weights = observed(solution.x), np.linalg.inv(cofactors)
    design = np.linalg.solve(whitening, solution.jac)
    of_residuals = cofactors - design @ np.linalg.solve(design.T @ weights @ design, design.T)
    tests = weights @ of_residuals @ weights

    assert block.targets[0].residuals.ravel() == pytest.approx(v[:24], abs=2e-8)
    assert block.sum_of_squares == pytest.approx(v @ weights @ v, rel=1e-4)
    assert block.targets[0].squares.sum() == pytest.approx(v[:24] @ weights[:24, :24] @ v[:24], rel=1e-4)
    redundancy = np.diag(of_residuals @ weights)
    assert block.targets[0].redundancy.ravel() == pytest.approx(redundancy[:24], abs=1e-4)
    assert block.redundancy == 36 - 18 == pytest.approx(redundancy.sum())
    w = (weights @ v) / np.sqrt(np.diag(tests))
    assert block.targets[0].normalized.ravel() == pytest.approx(w[:24], abs=1e-3)
    delta0 = 3.290527 + 0.841621
    assert block.targets[0].detectable.ravel() == pytest.approx(
        delta0 / np.sqrt(np.diag(tests))[:24], rel=1e-4
    )
    assert block.control.normalized[free].ravel() == pytest.approx(w[24:], abs=1e-3)


def test_statistics_of_targets_with_covariances_are_those_of_many_simulated_scans():
    blocks = [adjust([with_covariances(seed)], HALL, SURVEYED, Model.RIGID, SIGMA) for seed in range(300)]
    w = np.array([block.targets[0].normalized for block in blocks])
    true = np.array([scanned(HALL)[1][:3, :3].T @ block.poses[0].rotation for block in blocks])
    turns = Rotation.from_matrix(true).as_rotvec() @ scanned(HALL)[1][:3, :3].T
    stated = np.sqrt(np.mean([np.diag(block.pose_cofactors[0])[3:] for block in blocks], axis=0))

    assert w.std() == pytest.approx(1.0, abs=0.04)
    assert np.mean([block.sum_of_squares for block in blocks]) == pytest.approx(18.0, abs=1.0)
    assert turns.std(axis=0) / stated == pytest.approx(np.ones(3), abs=0.15)


def test_a_target_without_a_covariance_counts_with_the_common_standard_deviation():
    one = with_covariances()
    unknown = one.covariances.copy()
    unknown[3] = np.nan
    common = one.covariances.copy()
    common[3] = np.eye(3) * SIGMA**2
    partly, wholly = (
        adjust([replace(one, covariances=each)], HALL, SURVEYED, Model.RIGID, SIGMA)
        for each in (unknown, common)
    )

    assert partly.poses[0].matrix() == pytest.approx(wholly.poses[0].matrix(), abs=1e-12)


def test_covariances_turn_with_the_scan_and_grow_with_its_scale():
    """A scan in feet, whose covariances are in square feet, gives the same block."""
    feet = 0.3048
    one = with_covariances()
    larger = Sighting(
        one.targets / feet, one.points, fit_pose(HALL, one.targets / feet, Model.UNKNOWN_SCALE),
        one.covariances / feet**2,
    )  # fmt: skip
    block, other = (
        adjust([each], HALL, SURVEYED, Model.UNKNOWN_SCALE, SIGMA)
        for each in (replace(one, pose=fit_pose(HALL, one.targets, Model.UNKNOWN_SCALE)), larger)
    )

    assert other.sum_of_squares == pytest.approx(block.sum_of_squares)
    assert other.poses[0].scale == pytest.approx(feet * block.poses[0].scale)
