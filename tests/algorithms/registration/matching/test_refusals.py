"""Registrations that must be refused, and the reason that the user reads."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, labels, listed, register, scanned
from ichnograph.tests.scenes.targets import target_scene

CUBE = np.array([[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)], float)
COLUMNS = np.array([[6.0 * x, 6.0 * y, 1.5] for x in range(6) for y in range(5)])


def test_a_cube_is_ambiguous_and_all_its_solutions_are_listed():
    scan = register(CUBE, scanned(CUBE)[0])

    assert scan.status == "ambiguous"
    assert len(scan.rivals) == 24
    assert all(len(rival) == 8 for rival in scan.rivals)
    assert len({tuple(rival.items()) for rival in scan.rivals}) == 24


def test_a_levelled_cube_has_four_solutions():
    scan = register(CUBE, scanned(CUBE)[0], model=Model.LEVELLED)

    assert scan.status == "ambiguous" and len(scan.rivals) == 4


def test_a_part_of_a_regular_hall_is_ambiguous():
    part = COLUMNS[[7, 8, 12, 13, 14, 18]]
    scan = register(COLUMNS, scanned(part)[0])

    assert scan.status == "ambiguous" and len(scan.rivals) > 10


def test_one_place_off_the_raster_resolves_a_regular_hall():
    control = np.concatenate([COLUMNS, [[9.1, 10.3, 2.8]]])
    seen = [7, 8, 12, 13, 14, 18, 30]
    scan = register(control, scanned(control[seen])[0])

    assert labels(scan) == {str(row + 1): f"P{number + 1}" for row, number in enumerate(seen)}


def test_targets_on_a_line_leave_a_scan_turning_about_it():
    line = np.linspace([0, 0, 1], [9, 5, 2], 6) ** [[1], [1], [1], [1], [1], [1]]
    line[1:5] += np.array([[0.31], [-0.42], [0.17], [0.55]]) * (line[5] - line[0]) / 10
    scan = register(np.concatenate([HALL, line]), scanned(line)[0])

    assert scan.status == "collinear" and "add a target beside it" in scan.reason


def test_targets_above_each_other_leave_a_levelled_scan_turning():
    pole = np.array([[2.0, 2.0, 0.5], [2.0, 2.0, 1.7], [2.0, 2.0, 3.6]])
    scan = register(np.concatenate([HALL, pole]), scanned(pole)[0], model=Model.LEVELLED)

    assert scan.status == "collinear" and "above each other" in scan.reason


def test_a_target_picked_twice_is_named():
    targets, _ = scanned(HALL[[0, 1, 2, 3, 4, 2]])
    targets[5, 0] += 0.001
    scan = register(HALL, targets)

    assert scan.status == "coincident" and "targets 3 and 6" in scan.reason


@pytest.mark.parametrize("model, count", [(Model.RIGID, 2), (Model.SIMILARITY, 2), (Model.LEVELLED, 1)])
def test_too_few_targets_are_counted(model, count):
    scan = register(HALL, scanned(HALL[:count])[0], model=model)

    assert scan.status == "too few" and f"has {count} target" in scan.reason


def test_few_targets_among_many_control_points_may_match_by_accident():
    scene = target_scene(300, 3, 3, seed=5)
    scan = register(scene.control.xyz, scene.targets.xyz, sigma=0.004)

    assert scan.status == "chance"
    assert "expected" in scan.reason


def test_names_that_are_not_in_the_control_list_are_counted():
    scan = register_scans(
        listed("control", HALL, prefix="P"),
        [listed("scan", scanned(HALL)[0], prefix="T")],
        Settings(matching=Matching.NAMES),
    ).scans[0]

    assert scan.status == "no overlap" and "0 have the name of a control point" in scan.reason
