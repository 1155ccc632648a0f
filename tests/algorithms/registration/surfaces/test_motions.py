"""Motions between two scans, found without a start value."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.registration.settings import Model
from ichnograph.algorithms.registration.surfaces.motions import (
    Anchors,
    Motion,
    balanced,
    likely_motions,
    searched,
    settled,
)
from ichnograph.tests.scenes.scanned_rooms import (
    ALONG,
    CORRIDOR,
    FURNISHED,
    STATIONS,
    matrix_of,
    surfaces_from,
)


def two(faces, stations, **chosen):
    return [searched(surfaces_from(faces, place, number, **chosen)) for number, place in enumerate(stations)]


def truth(stations):
    return np.linalg.inv(matrix_of(stations[0])) @ matrix_of(stations[1], 1)


def off(pose, matrix):
    return np.linalg.norm(pose.apply(np.zeros((1, 3)))[0] - matrix[:3, 3])


@pytest.fixture(scope="module")
def furnished():
    return two(FURNISHED, STATIONS)


@pytest.fixture(scope="module")
def corridor():
    return two(CORRIDOR, ALONG, reach=20.0)


@pytest.mark.parametrize("model", [Model.LEVELLED, Model.RIGID])
def test_the_motion_of_a_scan_is_among_the_likely_ones(furnished, model):
    motions = likely_motions(*furnished, model)

    assert min(off(motion.pose, truth(STATIONS)) for motion in motions) < 0.4


def test_a_motion_settles_where_surfaces_meet(furnished):
    near = min(
        likely_motions(*furnished, Model.LEVELLED), key=lambda motion: off(motion.pose, truth(STATIONS))
    )
    pose = settled(near, *furnished, Model.LEVELLED)

    assert off(pose, truth(STATIONS)) < 0.01
    assert np.allclose(pose.rotation, truth(STATIONS)[:3, :3], atol=0.002)


def test_a_target_on_a_point_fixes_the_shift_along_a_corridor(corridor):
    target, point = np.array([1.0, 0.5, 0.2]), np.array([-3.0, 0.7, 0.3])
    point = truth(ALONG)[:3, :3] @ target + truth(ALONG)[:3, 3]
    anchors = Anchors(target[None], np.array([point, point + [0.0, 0.0, 9.0]]))
    found = [
        motion for motion in likely_motions(*corridor, Model.LEVELLED, anchors) if motion.target is not None
    ]
    poses = [settled(motion, *corridor, Model.LEVELLED) for motion in found]

    assert min(off(pose, truth(ALONG)) for pose in poses) < 0.02


def test_a_scan_does_not_move_along_a_corridor_while_it_settles(corridor):
    start = likely_motions(*corridor, Model.LEVELLED)[0].pose
    pose = settled(Motion(start), *corridor, Model.LEVELLED)
    along = matrix_of(ALONG[0])[:3, :3].T[:, 0]

    assert abs((pose.position - start.position) @ along) < 0.4


def test_each_direction_weighs_nearly_alike():
    normals = np.repeat(np.eye(3), [90, 9, 9], axis=0)
    weights = balanced(normals, np.ones(len(normals)))

    assert weights[:90].sum() / weights[90:99].sum() < 2.5
    assert balanced(normals, 2 * np.ones(len(normals))) == pytest.approx(2 * weights)


def test_the_search_can_be_cancelled(furnished):
    with pytest.raises(CancelledError):
        likely_motions(*furnished, Model.RIGID, progress=Progress(is_cancelled=lambda: True))
