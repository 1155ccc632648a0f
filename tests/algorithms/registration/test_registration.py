"""Registering scans: which target is which, by distances and by names, one scan and several."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import (
    GRID,
    HALL,
    labels,
    listed,
    register,
    scanned,
    several_scans,
)
from ichnograph.tests.scenes.targets import target_scene

BY_NAMES = Settings(matching=Matching.NAMES)
SIGMA = 0.003


@pytest.mark.parametrize("model", Model)
def test_targets_find_their_points_in_every_model(model):
    scale = 0.37 if model is Model.UNKNOWN_SCALE else 1.0002 if model.scaled else 1.0
    tilt = 0.0 if model.levelled else 1.5
    targets, matrix = scanned(HALL, tilt=tilt, scale=scale, noise=0.001)
    order = [5, 2, 7, 0, 3, 6, 1, 4]
    scan = register(HALL + GRID, targets[order], model=model)

    assert labels(scan) == {str(row + 1): f"P{number + 1}" for row, number in enumerate(order)}
    matrix[:3, 3] += GRID
    placed = targets @ scan.matrix[:3, :3].T + scan.matrix[:3, 3]
    assert np.abs(placed - HALL - GRID).max() < 0.004
    assert scan.scale == pytest.approx(scale, abs=2e-4) if model.scaled else scan.scale == 1.0
    assert len(scan.estimates) == model.unknowns


def test_targets_that_are_no_control_points_are_left_without_one():
    scene = target_scene(30, 12, 6, seed=3)
    scan = register_scans(scene.control, [scene.targets], Settings(sigma=0.002)).scans[0]

    assert labels(scan) == {target: point for target, point in scene.truth.items() if point}
    assert set(scan.unmatched) == {target for target, point in scene.truth.items() if not point}


@pytest.mark.parametrize("model", [Model.LEVELLED, Model.LEVELLED_SCALE])
@pytest.mark.parametrize("matching", Matching)
def test_two_targets_suffice_when_levelled(model, matching):
    targets, matrix = scanned(HALL[[1, 4]])
    control = listed("control", HALL[: 4 + 1], names=list("abcde"))
    chosen = Settings(model=model, matching=matching)
    scan = register_scans(control, [listed("scan", targets, "be")], chosen).scans[0]

    assert labels(scan) == {"b": "b", "e": "e"}
    assert np.allclose(scan.matrix, matrix, atol=1e-9)


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY])
def test_large_coordinates_change_nothing(model):
    targets, _ = scanned(HALL, noise=0.002)
    near = register(HALL, targets, model=model)
    far = register(HALL + 7_000_000.0, targets, model=model)
    both = register(HALL + 7_000_000.0, targets + 7_000_000.0, model=model)

    for one, other in zip(near.correspondences, far.correspondences):
        assert np.abs(one.residual - other.residual).max() < 1e-8
    for one, other in zip(far.correspondences, both.correspondences):
        assert np.abs(one.residual - other.residual).max() < 1e-8
    for one, other in zip(near.estimates[3:], far.estimates[3:]):
        assert one.value == pytest.approx(other.value, abs=1e-7)
        assert one.std == pytest.approx(other.std, rel=1e-5)


@settings(max_examples=20, deadline=None)
@given(seed=strategies.integers(0, 2**32 - 1))
def test_the_order_of_rows_and_scans_does_not_matter(seed):
    random = np.random.default_rng(seed)
    seen = several_scans()
    control = listed("control", HALL + GRID, prefix="P")
    scans = [listed(name, xyz, prefix="t") for name, (xyz, _) in seen.items()]
    shuffled = [_shuffled(scans[number], random) for number in random.permutation(3)]

    one = register_scans(control, scans)
    other = register_scans(_shuffled(control, random), shuffled)

    by_name = {scan.name: scan for scan in other.scans}
    for scan in one.scans:
        assert np.array_equal(scan.matrix, by_name[scan.name].matrix)
        assert labels(scan) == labels(by_name[scan.name])


def _shuffled(points, random):
    order = random.permutation(len(points.names))
    return listed(points.name, points.xyz[order], [points.names[row] for row in order])


def test_the_same_input_gives_the_same_bytes():
    scene = target_scene(50, 15, 8, seed=1)
    results = [register_scans(scene.control, [scene.targets]).scans[0] for _ in range(2)]

    assert results[0].matrix.tobytes() == results[1].matrix.tobytes()
    assert [item.residual.tobytes() for item in results[0].correspondences] == [
        item.residual.tobytes() for item in results[1].correspondences
    ]


@pytest.mark.parametrize("model", [Model.SIMILARITY, Model.LEVELLED_SCALE])
@pytest.mark.parametrize("scale", [0.9996, 1.0005])
def test_a_model_with_scale_takes_the_scale_of_a_projection(model, scale):
    site = HALL * 6
    scan = register(site, scanned(site, scale=scale, noise=0.002)[0], model=model)

    assert len(labels(scan)) == 8
    assert scan.scale == pytest.approx(scale, abs=1e-4)


def test_one_bad_scan_does_not_stop_the_others():
    good, _ = scanned(HALL)
    mirrored = scanned(HALL, heading=100)[0][:, [1, 0, 2]]
    registration = register_scans(listed("control", HALL), [listed("bad", mirrored), listed("good", good)])

    assert [scan.status for scan in registration.scans] == ["mirrored", "registered"]


def test_a_scan_without_targets_is_refused_beside_the_others():
    good, _ = scanned(HALL)
    scans = [listed("empty", np.empty((0, 3))), listed("good", good)]
    registration = register_scans(listed("control", HALL), scans)

    assert [scan.registered for scan in registration.scans] == [False, True]
    assert "0 targets" in registration.scans[0].reason


def test_exact_targets_do_not_pay_for_the_errors_of_the_survey():
    survey = HALL + np.random.default_rng(4).normal(0, 0.0015, HALL.shape)
    targets, _ = scanned(HALL, noise=0.0001)
    own = np.tile(np.eye(3) * 0.0001**2, (8, 1, 1))
    exact = replace(listed("exact", targets), covariances=own)
    registration = register_scans(listed("control", survey), [exact])

    assert all(item.used for item in registration.scans[0].correspondences)
    assert registration.settings.control_sigma == registration.settings.sigma
    assert "set CONTROL_SIGMA" in registration.warnings[0]


def test_scans_of_one_name_and_too_short_control_lists_are_refused():
    targets = listed("scan", scanned(HALL)[0])
    with pytest.raises(InputError, match="called scan"):
        register_scans(listed("control", HALL), [targets, targets])
    with pytest.raises(InputError, match="2 control points"):
        register_scans(listed("control", HALL[:2]), [targets])
