"""Solid that is given back to rooms, for a face behind it was seen."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.division.explaining import give_back

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
