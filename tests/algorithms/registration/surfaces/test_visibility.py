"""Whether surfaces could have been seen from a position."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.surfaces.visibility import hidden_share
from ichnograph.tests.algorithms.registration.surfaces.rooms import EDGE, cells_on, room
from ichnograph.tests.scenes.surface_rooms import box


def hidden(station, faces, error=0.002):
    centres, normals = cells_on(faces, error=error)
    return hidden_share(np.asarray(station, float), centres, normals, np.full(len(centres), EDGE))


def test_an_empty_room_hides_nothing_from_a_scanner_in_it():
    assert hidden((1, 4, 1.6), room()) == 0


def test_walls_hide_a_room_from_the_next_one():
    assert hidden((-3, 2, 1.6), room()) > 0.5


def test_as_much_is_hidden_as_lies_behind_something():
    # From twice its height, a table of 2 m hides four times its area of a floor of 12 m.
    floor, table = box((-6, -6, 0), (6, 6, 5))[4:5], box((-1, -1, 1), (1, 1, 6))[4:5]

    assert hidden((0, 0, 2), floor + table) == pytest.approx(16 / (144 + 4), abs=0.05)


def test_a_long_floor_does_not_hide_itself_although_it_is_not_even():
    floor = box((-20, -20, 0), (20, 20, 3))[4:5]

    assert hidden((0, 0, 1.6), floor, error=0.005) == 0
