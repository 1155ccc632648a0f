"""The results of scans and points, from the adjusted block."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.tests.algorithms.registration.hall import (
    GRID,
    HALL,
    labels,
    listed,
    register,
    scanned,
    several_scans,
)


def test_noise_larger_than_sigma_is_reported_and_nothing_rejected():
    targets, _ = scanned(HALL, noise=0.009)
    scan = register(HALL, targets, tolerance=0.08)

    assert len(labels(scan)) == 8
    assert scan.test.probability < 0.001
    assert any("SIGMA" in warning for warning in scan.warnings)


def test_residuals_are_those_of_the_matrix():
    targets, _ = scanned(HALL, noise=0.003)
    scan = register(HALL + GRID, targets)
    placed = targets @ scan.matrix[:3, :3].T + scan.matrix[:3, 3]

    assert [item.residual for item in scan.correspondences] == pytest.approx(placed - HALL - GRID, abs=1e-8)


def test_the_paper_scales_standard_deviations_by_sigma0():
    # q_x = sigma0 sqrt(q_kk), equation 5: SIGMA has no influence on them.
    targets, _ = scanned(HALL, noise=0.003)
    small, large = (register(HALL, targets, sigma=sigma) for sigma in (0.003, 0.006))

    assert large.test.sigma0 == pytest.approx(small.test.sigma0 / 2)
    for one, other in zip(small.estimates, large.estimates):
        assert one.std == pytest.approx(other.std)


def test_studentized_residuals_are_the_normalized_ones_over_sigma0():
    scan = register(HALL, scanned(HALL, noise=0.003)[0])

    for item in scan.correspondences:
        assert item.studentized == pytest.approx(item.normalized / scan.test.sigma0)
        assert item.normalized == pytest.approx(item.residual / (0.003 * np.sqrt(item.redundancy)), rel=1e-5)


def test_the_standard_deviations_are_those_of_simulated_scans():
    found = [register(HALL, scanned(HALL, noise=0.003, seed=seed)[0]) for seed in range(60)]
    shifts = np.array([[item.value for item in scan.estimates] for scan in found])
    stds = np.array([[item.std for item in scan.estimates] for scan in found])

    assert (shifts.std(axis=0) / np.sqrt((stds**2).mean(axis=0))) == pytest.approx(np.ones(6), abs=0.3)


@pytest.mark.parametrize("model", [Model.RIGID, Model.LEVELLED_SCALE])
def test_correlations_have_ones_on_the_diagonal(model):
    correlations = register(HALL, scanned(HALL, noise=0.002)[0], model=model).correlations

    assert np.diag(correlations) == pytest.approx(np.ones(model.unknowns))
    assert correlations == pytest.approx(correlations.T)
    assert np.abs(correlations).max() <= 1 + 1e-12


def test_points_keep_the_order_of_their_list_and_say_who_uses_them():
    seen = several_scans()
    order = [4, 0, 7, 2, 5, 1, 6, 3]
    control = listed("control", HALL[order] + GRID, [f"P{row}" for row in order])
    points = register_scans(control, [listed("a", seen["a"][0])], Settings()).points

    assert [point.name for point in points[:8]] == list(control.names)
    assert all(point.scans == ("a",) and not point.covariance.any() for point in points[:8])
    appended = points[8:]
    assert len(appended) == 6 and {point.origin for point in appended} == {"a"}
    # Of the target itself, and of the pose.
    assert all((np.diag(point.covariance) > 0.003**2).all() for point in appended)


def test_a_surveyed_point_that_no_scan_sees_has_its_own_standard_deviation():
    control = listed("control", np.concatenate([HALL, [[40.0, 40.0, 1.0]]]))
    scans = [listed("scan", scanned(HALL)[0])]
    points = register_scans(control, scans, Settings(control_sigma=0.002)).points

    assert points[8].scans == ()
    assert np.diag(points[8].covariance) == pytest.approx([4e-6] * 3)


def chain(count):
    """Return the lists of scans along a corridor, of which only the first sees the control points."""
    random = np.random.default_rng(4)
    joints = [random.uniform((12 * number, 0, 0), (12 * number + 3, 3, 3), (4, 3)) for number in range(count)]
    scans = []
    for number in range(count):
        places = np.concatenate([HALL if number == 0 else joints[number - 1], joints[number]])
        scans.append(listed(f"s{number}", scanned(places, 50 * number, noise=0.003, seed=number)[0]))
    return scans


def test_the_end_of_a_chain_is_warned_of_and_its_beginning_is_not():
    control = listed("control", HALL, prefix="P")
    scans = register_scans(control, chain(5)).scans

    assert all(scan.registered for scan in scans)
    assert scans[0].std < 0.006 < 0.03 < scans[-1].std
    assert not any("standard deviations of up to" in warning for warning in scans[0].warnings)
    (warning,) = (item for item in scans[-1].warnings if "standard deviations of up to" in item)
    assert "more than the limit of 30 mm" in warning


def test_the_limit_of_the_standard_deviation_is_the_users():
    control = listed("control", HALL, prefix="P")
    scans = register_scans(control, chain(5), Settings(most_std=2.0)).scans

    assert not any("standard deviations of up to" in warning for scan in scans for warning in scan.warnings)
