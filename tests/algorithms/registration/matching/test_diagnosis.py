"""Registrations that must not be answered, and what the user is told instead."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import GRID, HALL, labels, listed, scanned
from ichnograph.tests.scenes.targets import target_scene

CUBE = np.array([[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)], float)
COLUMNS = np.array([[6.0 * x, 6.0 * y, 1.5] for x in range(6) for y in range(5)])


def register(control, targets, **settings):
    points = listed("control", control, prefix="P")
    (scan,) = register_scans(points, [listed("scan", targets)], Settings(**settings)).scans
    if not scan.registered:
        assert scan.matrix is None and scan.reason.endswith(".")
        assert "scan" in scan.reason
    return scan


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


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY, Model.LEVELLED, Model.LEVELLED_SCALE])
def test_swapped_axes_are_found_out(model):
    targets, _ = scanned(HALL)
    scan = register(HALL + GRID, targets[:, [1, 0, 2]], model=model)

    assert scan.status == "mirrored"
    assert "x and y are swapped" in scan.reason


def test_swapped_axes_are_found_out_though_the_targets_on_one_wall_fit():
    wall = np.array([[1.0, 0.0, 1.0], [3.7, 0.0, 2.9], [7.2, 0.0, 1.6], [9.9, 0.0, 3.3], [5.1, 0.0, 0.4]])
    control = np.concatenate([wall, HALL + [0, 1, 0]])
    scan = register(control, scanned(control)[0][:, [1, 0, 2]])

    assert scan.status == "mirrored"


def test_targets_in_one_plane_are_registered_with_a_warning_that_a_mirror_would_fit():
    floor = HALL * [1, 1, 0]
    scan = register(floor + GRID, scanned(floor)[0])

    assert scan.registered
    assert any("mirrored" in warning for warning in scan.warnings)


@pytest.mark.parametrize("factor, unit", [(1000, "millimetres"), (100, "centimetres"), (1 / 0.3048, "feet")])
@pytest.mark.parametrize("matching", Matching)
def test_mixed_units_are_named_with_the_list_that_has_them(factor, unit, matching):
    targets, _ = scanned(HALL)
    names = [f"P{row + 1}" for row in range(len(HALL))]
    for control, scan, what in (
        (HALL, targets * factor, "scan"),
        (HALL * factor, targets, "the control list"),
    ):
        result = register_scans(
            listed("control", control, names), [listed("scan", scan, names)], Settings(matching=matching)
        ).scans[0]
        assert result.status == "units"
        assert f"the coordinates of {what} are {unit}" in result.reason


def test_a_scan_with_y_up_fits_no_levelled_model():
    targets, _ = scanned(HALL)
    scan = register(HALL, targets[:, [0, 2, 1]] * [1, 1, -1], model=Model.LEVELLED)

    assert scan.status == "tilted" and "90.00 degrees" in scan.reason


def test_targets_on_a_line_leave_a_scan_turning_about_it():
    line = np.linspace([0, 0, 1], [9, 5, 2], 6) ** [[1], [1], [1], [1], [1], [1]]
    line[1:5] += np.array([[0.31], [-0.42], [0.17], [0.55]]) * (line[5] - line[0]) / 10
    scan = register(np.concatenate([HALL, line]), scanned(line)[0])

    assert scan.status == "collinear" and "pick a target beside it" in scan.reason


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


@pytest.mark.parametrize("seed", range(8))
def test_a_scan_of_another_site_overlaps_nothing(seed):
    scene = target_scene(60, 15, 0, seed=seed)
    scan = register(scene.control.xyz, scene.targets.xyz, sigma=0.002)

    assert scan.status == "no overlap"


def test_names_that_do_not_fit_are_told_from_distances_that_do():
    targets, _ = scanned(HALL)
    names = [f"P{row + 1}" for row in range(len(HALL))]
    shuffled = [names[(3 * row + 1) % 8] for row in range(8)]
    scan = register_scans(
        listed("control", HALL, names), [listed("scan", targets, shuffled)], Settings(matching=Matching.NAMES)
    ).scans[0]

    assert scan.status == "misfit"
    assert "by their distances 8 of 8 do" in scan.reason


def test_names_that_are_not_in_the_control_list_are_counted():
    scan = register_scans(
        listed("control", HALL, prefix="P"),
        [listed("scan", scanned(HALL)[0], prefix="T")],
        Settings(matching=Matching.NAMES),
    ).scans[0]

    assert scan.status == "no overlap" and "0 have the name of a control point" in scan.reason


def test_one_bad_scan_does_not_stop_the_others():
    good, _ = scanned(HALL)
    mirrored = scanned(HALL, heading=100)[0][:, [1, 0, 2]]
    registration = register_scans(listed("control", HALL), [listed("bad", mirrored), listed("good", good)])

    assert [scan.status for scan in registration.scans] == ["mirrored", "registered"]


def test_scans_of_one_name_and_too_short_control_lists_are_refused():
    targets = listed("scan", scanned(HALL)[0])
    with pytest.raises(InputError, match="called scan"):
        register_scans(listed("control", HALL), [targets, targets])
    with pytest.raises(InputError, match="2 control points"):
        register_scans(listed("control", HALL[:2]), [targets])


@pytest.mark.parametrize("seed", range(40))
def test_a_nearly_regular_hall_is_never_labelled_wrong_even_if_sigma_is_too_small(seed):
    random = np.random.default_rng(seed)
    control = COLUMNS + random.normal(0, random.choice([0.0, 0.003, 0.01, 0.03]), COLUMNS.shape)
    seen = random.choice(len(control), random.integers(4, 10), replace=False)
    targets, _ = scanned(control[seen], heading=random.uniform(0, 360), noise=0.002, seed=seed)
    targets[0] += random.choice([0.0, 0.01, 0.1]) * np.array([0.6, 0.8, 0.0])
    scan = register(control, targets, sigma=0.001, model=Model([0, 2][seed % 2]))

    truth = {str(row + 1): f"P{number + 1}" for row, number in enumerate(seen)}
    assert not scan.registered or labels(scan).items() <= truth.items()
