"""Closing joins faces, leaves doors open, fills the inside of walls and not the inside of rooms."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.walls.closing import bridge_corners, close_gaps


def two_faces(gap):
    """Two lines, `gap` pixels between them."""
    walls = np.zeros((gap + 22, 60), bool)
    walls[10, 10:50] = walls[11 + gap, 10:50] = True
    return walls


@pytest.mark.parametrize("gap", [1, 2, 3, 4, 5, 6, 7, 8])
def test_a_gap_up_to_the_width_is_closed(gap):
    closed = close_gaps(two_faces(gap), 0.1, gap * 0.1)
    assert closed[10 : 12 + gap, 15:45].all()


@pytest.mark.parametrize("gap", [2, 3, 4, 5, 6, 7, 8])
def test_a_wider_gap_stays_open(gap):
    closed = close_gaps(two_faces(gap), 0.1, gap * 0.1 - 0.11)
    np.testing.assert_array_equal(closed, two_faces(gap))


def test_closing_keeps_every_wall_pixel_up_to_the_edge_of_the_raster():
    walls = np.random.default_rng(0).random((50, 50)) < 0.2
    assert close_gaps(walls, 0.1, 0.5)[walls].all()


def test_a_gap_of_0_closes_nothing():
    np.testing.assert_array_equal(close_gaps(two_faces(1), 0.1, 0.0), two_faces(1))


def test_a_door_in_which_the_ground_was_seen_stays_open():
    walls = np.zeros((40, 60), bool)
    walls[18:23, 5:55] = True
    walls[18:23, 25:30] = False
    ground = np.zeros(walls.shape, bool)
    assert close_gaps(walls, 0.1, 0.8, ground)[20, 25:30].all()
    ground[:, 25:30] = True
    np.testing.assert_array_equal(close_gaps(walls, 0.1, 0.8, ground), walls)


def test_one_pixel_of_ground_does_not_break_a_face():
    walls = np.zeros((30, 60), bool)
    walls[10:13, 5:55] = True
    walls[11, 30] = False
    ground = ~walls
    assert close_gaps(walls, 0.1, 0.8, ground)[11, 30]


def test_the_corner_of_a_room_stays_sharp_where_the_ground_was_seen():
    room = np.zeros((60, 60), bool)
    room[10, 10:50] = room[10:50, 10] = True
    inside = np.zeros(room.shape, bool)
    inside[11:50, 11:50] = True
    np.testing.assert_array_equal(close_gaps(room, 0.1, 0.8, inside)[inside], room[inside])


def test_the_inside_of_a_thick_wall_is_filled_and_the_inside_of_a_room_is_not():
    walls = np.zeros((70, 70), bool)
    for low, high in ((10, 60), (22, 48)):
        walls[low, low : high + 1] = walls[high, low : high + 1] = True
        walls[low : high + 1, low] = walls[low : high + 1, high] = True
    ground = np.zeros(walls.shape, bool)
    ground[23:48, 23:48] = True
    filled = close_gaps(walls, 0.1, 0.8, ground)
    assert filled[16, 12:58].all()
    assert not filled[23:48, 23:48].any()


def ring(size):
    """Return the four faces of a square body, so many pixels apart."""
    walls = np.zeros((size + 20, size + 20), bool)
    walls[10 : 12 + size, 10 : 12 + size] = True
    walls[11 : 11 + size, 11 : 11 + size] = False
    return walls


def test_the_inside_of_a_column_is_filled_in_a_slice_and_that_of_a_cabin_is_not():
    assert close_gaps(ring(7), 0.1, 0.4)[10:19, 10:19].all()
    assert not close_gaps(ring(12), 0.1, 0.4)[13:21, 13:21].any()


def test_a_small_room_in_a_slice_is_not_filled_because_wider_gaps_are_closed():
    assert not close_gaps(ring(15), 0.1, 0.8)[15:20, 15:20].any()


def test_pixels_that_touch_at_a_corner_are_joined_through_the_denser_neighbour():
    walls = np.eye(4, dtype=bool)
    density = np.triu(np.full((4, 4), 2.0)) + np.tril(np.full((4, 4), 1.0), -1)
    joined = bridge_corners(walls, density)
    assert joined.sum() == 7
    assert (joined & (density == 1.0)).sum() == 0
