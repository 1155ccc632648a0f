"""Solid that is given back to rooms before a face, and partitions between two faces."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.division.explaining import fill_between, give_back

ROOM, WARDROBE, WALL, OUTSIDE = range(4)
SIDES = np.array([[ROOM, WARDROBE], [WARDROBE, WALL], [WALL, -1]])


def given_back(unseen, tall):
    """Return what is room of a room, a wardrobe before a wall, and what lies behind; faces are 2 m long."""
    is_room = np.array([True, False, False, False])
    costs = np.array([-9.0, unseen, 9.0])
    found = give_back(is_room, costs, SIDES, np.full(3, 2.0), np.full(3, 0.01), np.array(tall))
    return found.tolist()


@pytest.mark.parametrize("unseen, given", [(0.15, True), (0.5, False)])
def test_the_less_was_left_unseen_the_sooner_it_is_given_back(unseen, given):
    assert given_back(unseen, [0.0, 1.0, 0.0]) == [True, given, False, False]


def test_without_a_tall_face_behind_nothing_is_given_back():
    assert given_back(0.01, [0.0, 0.0, 0.0]) == [True, False, False, False]


def test_a_face_in_front_that_is_as_good_stays():
    assert given_back(0.05, [1.0, 1.0, 0.0]) == [True, False, False, False]


LEFT, CORE, RIGHT = range(3)
AROUND_CORE = np.array([[LEFT, CORE], [CORE, RIGHT], [CORE, LEFT], [CORE, RIGHT]])


def is_filled(closed, seen=0.2, thickness=0.1, length=2.0, beyond=True):
    """Return whether the core between two faces becomes solid, of which a share was seen as room."""
    is_room = np.array([True, True, beyond, False])
    areas = np.array([9.0, length * thickness, 9.0])
    costs = np.array([-9.0, -seen * areas[CORE], -9.0])
    lengths = np.array([length, length, thickness, thickness])
    full = np.array([*closed, 0.0, 0.0])
    cost = 0.06 * lengths * (1 - 0.95 * full)
    found = fill_between(is_room, costs, areas, AROUND_CORE, lengths, cost, full)
    return found.tolist() == [True, False, beyond, False]


def test_a_partition_whose_core_noise_has_filled_becomes_solid():
    assert is_filled([1.0, 1.0])


@pytest.mark.parametrize("seen, filled", [(0.0, True), (0.4, True), (0.8, False)])
def test_what_was_mostly_seen_between_two_faces_remains_room(seen, filled):
    assert is_filled([1.0, 1.0], seen=seen) == filled


@pytest.mark.parametrize("closed", [[1.0, 0.0], [0.0, 0.0]])
def test_one_face_alone_shows_no_partition(closed):
    assert not is_filled(closed)


@pytest.mark.parametrize("thickness, filled", [(0.03, False), (0.1, True), (0.5, False)])
def test_faces_of_a_partition_are_as_far_apart_as_partitions_are_thick(thickness, filled):
    assert is_filled([1.0, 1.0], thickness=thickness) == filled


@pytest.mark.parametrize("length, filled", [(0.2, False), (0.4, True)])
def test_partitions_are_not_as_short_as_clutter(length, filled):
    assert is_filled([1.0, 1.0], length=length) == filled


def test_pieces_of_one_partition_are_as_long_as_they_are_together():
    is_room = np.array([True, True, True, True, False])
    first, second = CORE, 3
    sides = np.array([[LEFT, first], [first, RIGHT], [LEFT, second], [second, RIGHT], [first, second]])
    lengths, closed = np.array([0.25, 0.25, 0.25, 0.25, 0.1]), np.array([1.0, 1.0, 1.0, 1.0, 0.0])
    cost = 0.06 * lengths * (1 - 0.95 * closed)
    areas = np.array([9.0, 0.025, 9.0, 0.025])
    found = fill_between(is_room, np.array([-9.0, 0, -9.0, 0]), areas, sides, lengths, cost, closed)
    assert found.tolist() == [True, False, True, False, False]


def test_a_face_doubled_by_two_passes_is_not_filled_before_a_wall():
    assert not is_filled([1.0, 1.0], beyond=False)


def test_of_many_partitions_all_become_solid():
    count = 400
    rooms, cores = np.arange(count + 1), count + 1 + np.arange(count)
    is_room = np.append(np.ones(2 * count + 1, bool), False)
    areas = np.append(np.full(count + 1, 9.0), np.full(count, 0.2))
    sides = np.concatenate([np.stack([rooms[:-1], cores], 1), np.stack([cores, rooms[1:]], 1)])
    lengths, full = np.full(2 * count, 2.0), np.ones(2 * count)
    cost = 0.06 * lengths * 0.05
    found = fill_between(
        is_room, np.append(np.full(count + 1, -9.0), np.full(count, -0.04)), areas, sides, lengths, cost, full
    )
    assert found[rooms].all() and not found[cores].any()
