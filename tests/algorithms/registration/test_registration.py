"""Registering scans: which target is which, by distances and by names, one scan and several."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import GRID, HALL, labels, listed, scanned
from ichnograph.tests.scenes.targets import target_scene

BY_NAMES = Settings(matching=Matching.NAMES)
SIGMA = 0.003
ANNEX = HALL[:6] * [1.1, 0.8, 0.9] + [14.0, 3.0, 0.4]
TOWER = HALL[2:8] * [0.9, 1.2, 1.3] + [26.0, 5.0, 2.0]


def register(control, targets, **chosen):
    points = listed("control", control, prefix="P")
    return register_scans(points, [listed("scan", targets)], Settings(**chosen)).scans[0]


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


def test_wrong_names_are_found_out_and_told():
    targets, _ = scanned(HALL, noise=0.001)
    names = [f"P{row + 1}" for row in range(8)]
    wrong = [*names[:2], "P6", *names[3:5], "P3", *names[6:]]
    scan = register_scans(listed("control", HALL, names), [listed("scan", targets, wrong)], BY_NAMES).scans[0]

    assert scan.registered
    assert labels(scan) == {name: name for name in names if name not in ("P3", "P6")}
    told = " ".join(scan.warnings)
    assert "Target P6 of scan lies" in told and "from P3: its name is wrong" in told
    assert {item.target for item in scan.correspondences if not item.used} == {"P3", "P6"}


def test_names_that_contradict_the_distances_are_told():
    targets, _ = scanned(HALL)
    names = [f"P{row + 1}" for row in range(8)]
    scan = register_scans(
        listed("control", HALL, names), [listed("scan", targets, [*names[:6], "P8", "P7"])]
    ).scans[0]

    assert labels(scan)["P8"] == "P7"
    assert any("P8 is P7" in warning for warning in scan.warnings)


def test_an_outlier_is_rejected_and_listed_and_does_not_become_a_control_point():
    targets, _ = scanned(HALL, noise=0.001)
    targets[4] += [0.0, 0.03, 0.0]
    registration = register_scans(listed("control", HALL, prefix="P"), [listed("scan", targets)])
    (scan,) = registration.scans

    (out,) = [item for item in scan.correspondences if not item.used]
    assert (out.target, out.control) == ("5", "P5")
    assert out.length == pytest.approx(0.03, abs=0.004)
    assert scan.unmatched == ()
    assert len(registration.points) == len(HALL)


def test_noise_larger_than_sigma_says_is_told_and_nothing_rejected():
    targets, _ = scanned(HALL, noise=0.009)
    scan = register(HALL, targets, tolerance=0.08)

    assert len(labels(scan)) == 8
    assert scan.test.probability < 0.001
    assert any("SIGMA" in warning for warning in scan.warnings)


def test_control_points_at_one_place_are_used_once():
    control = np.concatenate([HALL, HALL[2:3] + 0.004])
    registration = register_scans(listed("control", control, prefix="P"), [listed("scan", scanned(HALL)[0])])

    assert len(labels(registration.scans[0])) == 8
    assert any("P3 and P9" in warning or "P9 and P3" in warning for warning in registration.warnings)


def test_a_scale_that_the_model_lacks_is_told():
    targets, _ = scanned(HALL * 3, scale=1.0004)
    scan = register(HALL * 3, targets, sigma=0.003)

    assert scan.scale_test.significant
    assert scan.scale_test.deviation == pytest.approx(400, abs=40)
    assert "model with scale" in scan.scale_test.advice
    assert any("differs from 1 by +400 ppm" in warning for warning in scan.warnings)


def several_scans():
    """Three scans: one of the surveyed hall and the annex, one of annex and tower, one of the tower only."""
    place = {"a": np.concatenate([HALL, ANNEX]), "b": np.concatenate([ANNEX, TOWER]), "c": TOWER}
    return {
        name: scanned(places, heading=50 + 70 * number, noise=0.001, seed=number)
        for number, (name, places) in enumerate(place.items())
    }


def test_the_order_of_scans_is_found():
    seen = several_scans()
    scans = [listed(name, seen[name][0]) for name in "cba"]
    registration = register_scans(listed("control", HALL + GRID, prefix="P"), scans)

    assert [scan.round for scan in registration.scans] == [3, 2, 1]
    for scan in registration.scans:
        expected = seen[scan.name][1]
        assert np.abs(scan.matrix[:3, 3] - expected[:3, 3] - GRID).max() < 0.01
    appended = [point for point in registration.points if not point.surveyed]
    assert len(appended) == len(ANNEX) + len(TOWER)
    assert {point.origin for point in appended} == {"a", "b"}
    assert all(len(point.scans) == 2 for point in appended)


def test_surveyed_points_never_move_unless_they_have_a_standard_deviation():
    seen = several_scans()
    scans = [listed(name, xyz) for name, (xyz, _) in seen.items()]
    control = listed("control", HALL + GRID)
    held = register_scans(control, scans)
    moved = register_scans(control, scans, Settings(control_sigma=0.002))

    for point, given_place in zip(held.points, HALL + GRID):
        assert np.array_equal(point.position, given_place)
        assert not point.covariance.any()
    shifts = [np.abs(point.position - place).max() for point, place in zip(moved.points, HALL + GRID)]
    assert 0 < max(shifts) < 0.004
    assert all(0 < np.sqrt(point.covariance[0, 0]) < 0.002 for point in moved.points[: len(HALL)])


def test_scans_share_names_of_targets_that_were_not_surveyed():
    seen = several_scans()
    names = {
        "a": [f"P{n}" for n in range(8)] + [f"A{n}" for n in range(6)],
        "b": [f"A{n}" for n in range(6)] + [f"T{n}" for n in range(6)],
        "c": [f"T{n}" for n in range(6)],
    }
    scans = [listed(name, seen[name][0], names[name]) for name in "cab"]
    registration = register_scans(listed("control", HALL, names["a"][:8]), scans, BY_NAMES)

    assert all(scan.registered for scan in registration.scans)
    assert labels(registration.scans[0]) == {f"T{n}": f"b:T{n}" for n in range(6)}


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


def test_an_appended_point_never_takes_the_name_of_a_surveyed_one():
    names = [*map(str, range(1, 8)), "scan:9"]
    targets, _ = scanned(np.concatenate([HALL, ANNEX]), noise=0.001)
    registration = register_scans(listed("control", HALL, names), [listed("scan", targets)])

    known = [point.name for point in registration.points]
    assert len(known) == len(set(known)) == len(HALL) + len(ANNEX)
    assert "scan:9'" in known


def test_outliers_never_leave_a_scan_of_the_block_without_support():
    # Seen by two scans each, these points carry the second scan; blunders make all of them suspicious.
    places = np.concatenate([HALL, ANNEX])
    first, _ = scanned(places, noise=0.002, seed=1)
    second, _ = scanned(ANNEX, heading=200, noise=0.002, seed=2)
    second[:2] += [[0.012, 0, 0], [0, -0.012, 0]]
    registration = register_scans(
        listed("control", HALL), [listed("a", first), listed("b", second)], Settings(sigma=0.001)
    )

    for scan in registration.registered:
        assert len(labels(scan)) >= 3


@pytest.mark.parametrize("model", [Model.SIMILARITY, Model.LEVELLED_SCALE])
@pytest.mark.parametrize("scale", [0.9996, 1.0005])
def test_a_model_with_scale_takes_the_scale_of_a_projection(model, scale):
    site = HALL * 6
    scan = register(site, scanned(site, scale=scale, noise=0.002)[0], model=model)

    assert len(labels(scan)) == 8
    assert scan.scale == pytest.approx(scale, abs=1e-4)


@pytest.mark.parametrize("model", [Model.RIGID, Model.LEVELLED])
def test_a_model_without_scale_names_that_of_a_projection(model):
    site = HALL * 25
    scan = register(site, scanned(site, scale=0.9996, noise=0.002)[0], model=model)

    assert scan.status == "scale"
    assert "model with scale" in scan.reason
