"""The adjustment of one scan: pose, covariance, and the rejection of outliers."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.least_squares import Sighting, adjust
from ichnograph.algorithms.registration.adjustment.scan_adjustment import fit_scan
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, scanned

FIXED = np.zeros((24, 24))
SETTINGS = Settings(sigma=0.003)
WIDTH = 0.01


def test_with_fixed_points_it_is_the_adjustment_of_a_block_of_one_scan():
    targets, _ = scanned(HALL, noise=0.003)
    fit = fit_scan(targets, HALL, FIXED, SETTINGS, WIDTH)
    sighting = Sighting(targets, np.arange(8), fit_pose(HALL, targets, Model.RIGID))
    block = adjust([sighting], HALL, np.ones(8, bool), Model.RIGID, 0.003)

    assert fit.pose.matrix() == pytest.approx(block.poses[0].matrix(), abs=1e-9)
    assert fit.cofactors == pytest.approx(block.pose_cofactors[0], rel=1e-6)
    assert fit.used.all() and not fit.rejected


def test_outliers_are_rejected_one_at_a_time_with_their_w():
    targets, matrix = scanned(HALL, noise=0.002)
    targets[2] += [0.5, 0, 0]
    targets[6] += [0, 0, -0.05]
    fit = fit_scan(targets, HALL, FIXED, SETTINGS, WIDTH)

    assert set(fit.rejected) == {2, 6} == set(np.flatnonzero(~fit.used))
    assert all(np.abs(w).max() > 3.29 for w in fit.rejected.values())
    assert fit.pose.matrix()[:3, 3] == pytest.approx(matrix[:3, 3], abs=0.01)


def test_a_target_is_tested_by_its_own_covariance():
    targets, _ = scanned(HALL, noise=0.001)
    targets[3] += [0.02, 0, 0]
    own = np.tile(np.eye(3) * 0.001**2, (8, 1, 1))
    own[3] *= 15**2
    free = Settings(sigma=0.001)

    assert set(fit_scan(targets, HALL, FIXED, free, WIDTH).rejected) == {3}
    assert not fit_scan(targets, HALL, FIXED, free, WIDTH, own).rejected


def test_an_underestimated_sigma_causes_no_rejections():
    targets, _ = scanned(HALL, noise=0.02)

    assert fit_scan(targets, HALL, FIXED, SETTINGS, WIDTH).used.all()


def test_a_target_without_which_the_others_lie_on_a_line_is_kept():
    places = np.array([[0.0, 0, 0], [3, 0, 0], [7, 0, 0], [12, 0, 0], [4, 5, 1]])
    targets = places + [[0, 0, 0], [0.03, 0, 0], [-0.05, 0, 0], [0, 0, 0], [0, 0.4, 0]]
    fit = fit_scan(targets, places, np.zeros((15, 15)), SETTINGS, WIDTH)

    assert fit.used[4]


def test_uncertain_points_make_an_uncertain_pose():
    targets, _ = scanned(HALL)
    certain = fit_scan(targets, HALL, FIXED, SETTINGS, WIDTH)
    uncertain = fit_scan(targets, HALL, np.eye(24) * 3 * 0.003**2, SETTINGS, WIDTH)

    assert uncertain.cofactors == pytest.approx(4 * certain.cofactors, rel=1e-6)


def test_the_gain_holds_the_derivatives_by_the_control_points():
    targets, _ = scanned(HALL)
    fit = fit_scan(targets, HALL, FIXED, SETTINGS, WIDTH)
    moved = HALL.copy()
    moved[3, 1] += 1e-5
    shifted = fit_scan(targets, moved, FIXED, SETTINGS, WIDTH)

    assert fit.gain.shape == (6, 24)
    assert (shifted.pose.position - fit.pose.position) / 1e-5 == pytest.approx(fit.gain[:3, 10], abs=1e-5)
