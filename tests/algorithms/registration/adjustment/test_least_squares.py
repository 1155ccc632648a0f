"""The block adjustment: what it minimises, and what it says about its observations."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.least_squares import Sighting, adjust
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import HALL, scanned

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
