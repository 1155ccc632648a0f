"""Control points: distances, and how far they may differ."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.algorithms.registration.matching.matching_cases import control_points
from scipy import stats

SQUARE = np.array([[0.0, 0, 0], [3, 0, 0], [0, 4, 0]])


def test_distances_match_within_some_standard_deviations_of_their_difference():
    fixed = control_points(SQUARE, Settings(sigma=0.002))
    measured = control_points(SQUARE, Settings(sigma=0.002, control_sigma=0.002))

    assert fixed.distances[1, 2] == 5.0
    assert fixed.limits[0, 1] == pytest.approx(3.5 * np.sqrt(2) * 0.002)
    assert measured.limits[0, 1] == pytest.approx(3.5 * 2 * 0.002)


def test_a_chosen_tolerance_is_the_limit_of_distances():
    assert control_points(SQUARE, Settings(tolerance=0.05)).limits[0, 1] == pytest.approx(0.05)


def test_one_true_target_in_a_hundred_thousand_is_out_of_reach():
    control = control_points(SQUARE, Settings(sigma=1.0))
    reach = control.reach(np.zeros((1, 4)), np.array([[0, 1, 2]]))

    assert reach.shape == (1, 4)
    assert stats.chi2.sf(reach[0, 0] ** 2, 3) == pytest.approx(1e-5, rel=0.3)


def test_the_uncertainty_of_the_pose_and_of_the_points_widen_the_reach():
    rows = np.array([[0, 1, 2]])
    fixed = control_points(SQUARE, Settings(sigma=1.0))
    measured = control_points(SQUARE, Settings(sigma=1.0, control_sigma=1.0))

    assert fixed.reach(np.array([[3.0]]), rows) == pytest.approx(2 * fixed.reach(np.array([[0.0]]), rows))
    assert measured.reach(np.array([[0.0]]), rows)[0, 0] == pytest.approx(
        np.sqrt(2) * fixed.reach(np.array([[0.0]]), rows)[0, 0]
    )
