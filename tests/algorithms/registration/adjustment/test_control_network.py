"""The control network: names, origins and covariances of surveyed and appended points."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.control_network import ControlNetwork

POINTS = np.array([[0.0, 0, 0], [10, 0, 0], [0, 10, 0]])
FRESH = np.array([[5.0, 5, 2], [8, 1, 3]])
COVARIANCE = np.diag([1.0, 1, 1, 4, 4, 4]) * 1e-6
COVARIANCE[:3, 3:] = COVARIANCE[3:, :3] = np.eye(3) * 0.5e-6


def surveyed(control_sigma=0.0):
    return ControlNetwork.of_surveyed(("A", "B", "C"), POINTS, control_sigma)


def appended(network):
    nothing = np.zeros((6, 3 * len(network.loose)))
    return network.appended("S1", ("7", "8"), FRESH, COVARIANCE, nothing)


def test_appended_points_are_named_by_scan_and_target():
    network = appended(surveyed())

    assert network.names == ("A", "B", "C", "S1:7", "S1:8")
    assert network.labels == ("A", "B", "C", "7", "8")
    assert network.surveyed.tolist() == [True, True, True, False, False]
    assert np.array_equal(network.points, np.concatenate([POINTS, FRESH]))


def test_a_name_that_exists_gets_a_prime():
    network = ControlNetwork.of_surveyed(("A", "S1:7", "C"), POINTS, 0.0)

    assert appended(network).names[3:] == ("S1:7'", "S1:8")


def test_points_held_fixed_have_no_covariance_and_appended_ones_that_of_their_scan():
    network = appended(surveyed())

    assert not network.covariance_of(np.arange(3)).any()
    assert network.covariance_of(np.array([3, 4])) == pytest.approx(COVARIANCE)
    assert network.covariance_between(np.array([0, 3]), 4)[3:] == pytest.approx(COVARIANCE[:3, 3:])


def test_surveyed_points_with_a_standard_deviation_become_correlated_when_they_are_used():
    network = surveyed(0.002)

    assert len(network.with_correlated(np.array([1])).loose) == 1
    assert network.with_correlated(np.array([0, 2])).covariance == pytest.approx(np.eye(6) * 4e-6)
    assert surveyed().with_correlated(np.array([1])) is not None
    assert not len(surveyed().with_correlated(np.array([1])).loose), "held fixed"


def test_the_variance_of_a_distance_is_that_along_it():
    assert not surveyed().distance_variances().any()
    assert surveyed(0.002).distance_variances()[0, 1] == pytest.approx(2 * 4e-6)
    variances = appended(surveyed()).distance_variances()
    assert variances[0, 3] == pytest.approx(1e-6)
    # Both share half of the smaller variance: 1 + 4 - 2 * 0.5.
    assert variances[3, 4] == pytest.approx(4e-6)
    assert variances == pytest.approx(variances.T)


def test_the_variances_are_those_of_simulated_distances():
    random = np.random.default_rng(0)
    moved = FRESH.ravel() + random.multivariate_normal(np.zeros(6), COVARIANCE, 20_000)
    distances = np.linalg.norm(moved[:, :3] - moved[:, 3:], axis=1)

    assert appended(surveyed()).distance_variances()[3, 4] == pytest.approx(distances.var(), rel=0.05)
