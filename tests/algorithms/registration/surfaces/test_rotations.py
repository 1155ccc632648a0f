"""Rotations that the directions of surfaces allow."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.surfaces.rotations import directions_of, rotations_between
from ichnograph.tests.algorithms.registration.surfaces.rooms import ROOM, frame, room, surfaces_in
from scipy.spatial.transform import Rotation

FIRST = directions_of(surfaces_in(frame(), room(), ROOM / 2))


def off(rotations, matrix):
    """Return how far the nearest of rotations is from that of a matrix, degrees."""
    turns = [Rotation.from_matrix(rotation.T @ matrix[:3, :3]).magnitude() for rotation in rotations]
    return np.degrees(min(turns))


def test_a_room_has_six_directions_with_the_shares_of_its_surface():
    size = ROOM[0] * ROOM[1], ROOM[0] * ROOM[2], ROOM[1] * ROOM[2]
    expected = np.sort(np.repeat(size, 2))[::-1] / (2 * sum(size))

    assert len(FIRST.normals) == 6
    assert np.sort(FIRST.shares)[::-1] == pytest.approx(expected, abs=0.03)


@pytest.mark.parametrize("tilt", [(0.0, 0.0), (3.0, -20.0), (90.0, 0.0)])
def test_the_rotation_of_a_scan_is_among_24_whatever_its_tilt(tilt):
    matrix = frame(40, ROOM / 2, tilt)
    other = directions_of(surfaces_in(matrix, room(), ROOM / 2))
    found = rotations_between(FIRST, other, levelled=False)

    assert len(found) == 24
    assert off(found, matrix) < 0.1


def test_levelled_scans_have_four_headings_in_a_room():
    matrix = frame(40, ROOM / 2)
    other = directions_of(surfaces_in(matrix, room(), ROOM / 2))
    found = rotations_between(FIRST, other, levelled=True)

    assert len(found) == 4
    assert off(found, matrix) < 0.1
    assert all(rotation[2, 2] == pytest.approx(1) for rotation in found)


def test_surfaces_that_all_face_one_way_fix_no_rotation():
    floor = room(omit=("-x", "+x", "-y", "+y", "+z"))
    other = directions_of(surfaces_in(frame(), floor, ROOM / 2))

    assert rotations_between(FIRST, other, levelled=False) == []
    assert rotations_between(FIRST, other, levelled=True) == []
