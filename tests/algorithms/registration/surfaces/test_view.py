"""What a scanner saw in each direction."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.surfaces.view import view_of
from ichnograph.tests.algorithms.registration.surfaces.rooms import ROOM, frame, room, surfaces_in

STATION = ROOM / 2


@pytest.fixture(scope="module")
def view():
    return view_of(surfaces_in(frame(), room(), STATION))


def judged(view, place, normal):
    return int(view.judged(np.array([place], float), np.array([normal], float))[0])


def test_what_lies_on_a_wall_that_was_seen_and_faces_the_same_way_was_seen(view):
    assert judged(view, (0.03, 2.2, 1.4), (1, 0, 0)) == 1
    assert judged(view, (0.03, 2.2, 1.4), (0, 1, 0)) == 0


def test_the_scanner_saw_through_what_stands_before_the_wall(view):
    assert judged(view, (1.0, 2.2, 1.4), (1, 0, 0)) == -1
    assert judged(view, (1.0, 2.2, 1.4), (0, 1, 0)) == -1


def test_a_shift_less_than_a_wall_is_wide_shows_where_surfaces_are_parallel(view):
    assert judged(view, (0.2, 2.2, 1.4), (1, 0, 0)) == -1
    assert judged(view, (0.2, 2.2, 1.4), (0, 1, 0)) == 0


def test_what_a_wall_hides_is_neither_seen_nor_seen_through(view):
    assert judged(view, (-1.0, 2.2, 1.4), (1, 0, 0)) == 0


def test_nothing_is_known_where_nothing_was_seen():
    open_room = view_of(surfaces_in(frame(), room(omit=("-x",)), STATION))

    assert judged(open_room, (0.0, 2.2, 1.4), (1, 0, 0)) == 0
    assert judged(open_room, (1.0, 2.2, 1.4), (1, 0, 0)) == 0


def test_of_two_surfaces_in_one_direction_the_nearer_one_was_seen():
    screen = room((1.0, 0.0, 0.0), (0.0, 5.0, 3.0), omit=("+x", "-y", "+y", "-z", "+z"))
    view = view_of(surfaces_in(frame(), room() + screen, STATION))

    assert judged(view, (1.0, 2.2, 1.4), (1, 0, 0)) == 1
    assert judged(view, (0.0, 2.2, 1.4), (1, 0, 0)) == 0
