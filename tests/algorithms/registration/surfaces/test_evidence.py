"""Patches that agree with a pose, and patches that contradict it."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.surfaces.evidence import Evidence, Stood, evidence_for, into
from ichnograph.algorithms.registration.surfaces.motions import searched
from ichnograph.tests.algorithms.registration.surfaces.rooms import ROOM, frame, pose, room, surfaces_in

FIRST, SECOND = frame(20, ROOM * [0.3, 0.4, 0.5]), frame(150, ROOM * [0.7, 0.6, 0.5])


def scan(matrix, faces=None):
    return searched(surfaces_in(matrix, faces or room(), matrix[:3, 3]))


@pytest.fixture(scope="module")
def first():
    return Stood("first", scan(FIRST), pose(FIRST))


def test_at_the_right_pose_all_patches_agree(first):
    found = evidence_for(pose(SECOND), scan(SECOND), [first])

    assert found.agreeing > 150
    assert found.contradicting == 0
    assert found.scans == ("first",)


def test_half_a_metre_off_many_patches_contradict(first):
    found = evidence_for(pose(SECOND, (0.5, 0.0, 0.0)), scan(SECOND), [first])

    assert found.contradicting > 10
    assert found.weight(10) < 100


def test_a_room_next_door_says_nothing(first):
    beside = frame(150, ROOM * [1.5, 0.5, 0.5] + [0.2, 0, 0])
    found = evidence_for(pose(beside), scan(beside, room(ROOM * [1, 0, 0] + [0.2, 0, 0])), [first])

    assert found.agreeing == found.contradicting == 0
    assert found.scans == ()


def test_a_patch_counts_once_however_many_scans_saw_it(first):
    again = Stood("again", first.scan, first.pose)
    own = scan(SECOND)
    once, twice = (evidence_for(pose(SECOND), own, others) for others in ([first], [first, again]))

    assert once.agreeing < twice.agreeing < 2 * once.agreeing


def test_the_direction_that_fewest_patches_face_is_that_of_a_corridor():
    normals = np.repeat([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], [40, 40, 2], axis=0)
    fewest, direction = Evidence(82, 0, normals, ("a",)).across()

    assert fewest == pytest.approx(2)
    assert np.abs(direction) == pytest.approx([1, 0, 0])


def test_places_of_the_control_frame_in_a_scan():
    places = np.array([[1.0, 2.0, 3.0], [4.0, 0.0, 1.0]])

    assert pose(FIRST).apply(into(places, pose(FIRST))) == pytest.approx(places)
