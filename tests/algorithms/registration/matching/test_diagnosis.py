"""Why nothing matches: mirrored lists, other units, tilted scans, a scale, wrong names."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import GRID, HALL, listed, register, scanned
from ichnograph.tests.scenes.targets import target_scene


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
        assert f"the coordinates of {what} are in {unit}" in result.reason


def test_a_scan_with_y_up_fits_no_levelled_model():
    targets, _ = scanned(HALL)
    scan = register(HALL, targets[:, [0, 2, 1]] * [1, 1, -1], model=Model.LEVELLED)

    assert scan.status == "tilted" and "90.00 degrees" in scan.reason


@pytest.mark.parametrize("seed", range(8))
def test_a_scan_of_another_site_overlaps_nothing(seed):
    scene = target_scene(60, 15, 0, seed=seed)
    scan = register(scene.control.xyz, scene.targets.xyz, sigma=0.002)

    assert scan.status == "no overlap"


def test_wrong_names_are_distinguished_from_wrong_distances():
    targets, _ = scanned(HALL)
    names = [f"P{row + 1}" for row in range(len(HALL))]
    shuffled = [names[(3 * row + 1) % 8] for row in range(8)]
    scan = register_scans(
        listed("control", HALL, names), [listed("scan", targets, shuffled)], Settings(matching=Matching.NAMES)
    ).scans[0]

    assert scan.status == "misfit"
    assert "by their distances 8 of 8 do" in scan.reason


@pytest.mark.parametrize("model, with_scale", [(Model.RIGID, 1), (Model.LEVELLED, 3)])
@pytest.mark.parametrize("scale", [0.97, 1.01, 4.0])
def test_right_names_with_a_scale_lead_to_a_model_that_has_it(model, with_scale, scale):
    targets = scanned(HALL, scale=scale, noise=0.001)[0]
    names = [f"P{row + 1}" for row in range(8)]
    control, chosen = listed("control", HALL, names), Settings(matching=Matching.NAMES, model=model)
    scan = register_scans(control, [listed("scan", targets, names)], chosen).scans[0]

    assert scan.status == "scale"
    assert f"MODEL={with_scale}" in scan.reason and "correct the names" not in scan.reason
    followed = Settings(matching=Matching.NAMES, model=Model(with_scale))
    assert register_scans(control, [listed("scan", targets, names)], followed).scans[0].registered


def test_a_scale_error_over_a_few_metres_is_not_laid_to_the_projection():
    targets = scanned(HALL * 0.7, scale=0.9996)[0]
    targets[0] += 0.02
    scan = register(HALL * 0.7, targets, sigma=0.0005, tolerance=0.0008)

    assert "projection" not in scan.reason + " ".join(scan.warnings)


@pytest.mark.parametrize("model", [Model.RIGID, Model.LEVELLED])
def test_a_model_without_scale_names_that_of_a_projection(model):
    site = HALL * 25
    scan = register(site, scanned(site, scale=0.9996, noise=0.002)[0], model=model)

    assert scan.status == "scale"
    assert "model with scale" in scan.reason
