"""The task of matching: which targets may match which points."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.matching.matching_task import coincident, matching_task
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, labels, listed, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import control_points, network

TARGETS = scanned(HALL)[0]


def task(names=None, points=HALL, targets=TARGETS, **chosen):
    return matching_task(listed("scan", targets, names), network(points), Settings(**chosen))


def test_control_points_too_close_to_each_other_are_used_once():
    control = np.concatenate([HALL, HALL[2:3] + 0.004])
    registration = register_scans(listed("control", control, prefix="P"), [listed("scan", TARGETS)])

    assert len(labels(registration.scans[0])) == 8
    assert any("P3 and P9" in warning or "P9 and P3" in warning for warning in registration.warnings)


def test_the_later_of_two_coincident_points_matches_nothing():
    control = np.concatenate([HALL, HALL[2:3] + 0.004])

    assert np.flatnonzero(coincident(control_points(control))).tolist() == [8]
    assert task(points=control).allowed[:, 8].sum() == 0
    assert task(points=control).allowed[:, :8].all()


def test_by_names_a_target_matches_the_point_of_its_name_only():
    names = ["P3", "P1", "X", "P8", "P2", "P4", "P5", "P6"]
    allowed = task(names, matching=Matching.NAMES).allowed

    assert allowed.sum(axis=1).tolist() == [1, 1, 0, 1, 1, 1, 1, 1]
    assert allowed.argmax(axis=1)[[0, 1, 3]].tolist() == [2, 0, 7]


@pytest.mark.parametrize(
    ("model", "matching", "scale_error"),
    [
        (Model.RIGID, Matching.DISTANCES, 0.0),
        (Model.SIMILARITY, Matching.DISTANCES, 600e-6),
        (Model.LEVELLED_SCALE, Matching.DISTANCES, 600e-6),
        (Model.UNKNOWN_SCALE, Matching.DISTANCES, 0.0),
        (Model.SIMILARITY, Matching.NAMES, 0.0),
    ],
)
def test_distances_allow_for_a_scale_error_if_the_scale_is_near_1(model, matching, scale_error):
    assert task(model=model, matching=matching).control.scale_error == scale_error


def test_solutions_of_changed_targets_and_points_are_found():
    plain = task()

    assert not plain.solutions(TARGETS[:, [1, 0, 2]], Model.RIGID, 5)
    assert plain.solutions(TARGETS, Model.RIGID, 5)[0].matched == 8
    assert plain.solutions(TARGETS / 2, Model.RIGID, 5, control_points(HALL / 2))[0].matched == 8
