"""How uncertain a pose makes the targets that it transforms, beside simulated scans."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.matching.pose_uncertainty import (
    leverage,
    rotation_std_deg,
    scale_shift,
)
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import HALL, scanned

SIGMA = 0.003
PARTNERS = np.array([0, 2, 4, 6])


def simulated(model, trials=400):
    """Return the deviations of all transformed places by poses from noisy partners, shape (t, n, 3)."""
    exact, _ = scanned(HALL)
    random = np.random.default_rng(0)
    found = []
    for _ in range(trials):
        noisy = exact[PARTNERS] + random.normal(0, SIGMA, (4, 3))
        found.append(fit_pose(HALL[PARTNERS], noisy, model).apply(exact) - HALL)
    return np.array(found)


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY, Model.LEVELLED])
def test_leverage_covers_the_variance_that_a_pose_adds(model):
    exact, _ = scanned(HALL)
    pose = fit_pose(HALL[PARTNERS], exact[PARTNERS], model)
    added = leverage(pose[None], exact, PARTNERS[None], model)[0]
    largest = (simulated(model).std(axis=0) / SIGMA).max(axis=1) ** 2

    assert (largest < 1.2 * added).all()
    assert (added < 6 * largest).all()


def test_leverage_grows_with_the_distance_from_the_partners():
    exact = np.concatenate([HALL[PARTNERS], HALL.mean(axis=0) + [[10.0, 0, 0], [100.0, 0, 0]]])
    rows = np.arange(4)
    pose = fit_pose(exact[rows], exact[rows], Model.RIGID)
    added = leverage(pose[None], exact, rows[None], Model.RIGID)[0]

    assert added[5] > 50 * added[4] > 50 * 0.25


def test_a_scale_error_shifts_by_the_distance_from_the_centre():
    pose = fit_pose(HALL, HALL, Model.RIGID)
    shifts = scale_shift(pose[None], HALL, 100e-6, 1)[0]

    assert shifts == pytest.approx(1e-4 * np.linalg.norm(HALL - HALL.mean(axis=0), axis=1))
    assert not scale_shift(pose[None], HALL, 0.0, 1).any()


def test_targets_nearly_on_a_line_leave_the_rotation_about_it_uncertain():
    line = np.array([[0.0, 0, 0], [5, 0.05, 0], [10, 0, 0.02]])
    pose = fit_pose(line, line, Model.RIGID)
    wide = fit_pose(HALL, HALL, Model.RIGID)

    assert rotation_std_deg(pose, line, False, SIGMA) > 1.0
    assert rotation_std_deg(wide, HALL, False, SIGMA) < 0.05
    assert rotation_std_deg(pose, line, True, SIGMA) < 0.05, "about the vertical they determine it"


def test_the_uncertainty_of_the_heading_is_that_of_simulated_scans():
    exact, _ = scanned(HALL)
    random = np.random.default_rng(2)
    headings = []
    for _ in range(400):
        rotation = fit_pose(HALL, exact + random.normal(0, SIGMA, HALL.shape), Model.LEVELLED).rotation
        headings.append(np.degrees(np.arctan2(rotation[1, 0], rotation[0, 0])))
    pose = fit_pose(HALL, exact, Model.LEVELLED)

    assert rotation_std_deg(pose, exact, True, SIGMA) == pytest.approx(np.std(headings), rel=0.1)
