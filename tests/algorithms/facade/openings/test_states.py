"""Each pixel of an elevation shows the wall, something behind it, something in front, or nothing."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.openings.states import BEHIND, EMPTY, FRONT, INNER, WALL
from ichnograph.algorithms.facade.planes.inner_face import Face
from ichnograph.tests.algorithms.facade.openings.scenes import STEP, WINDOW, pane, states_of, wall
from ichnograph.tests.algorithms.facade.samples import at, lattice, without

GLASS, CAR = (3.0, 1.2, 4.0, 2.4), (4.5, 0.0, 5.5, 1.0)


def state_at(states, u, v):
    return states.image.ravel()[states.grid.cells(np.array([(u, v)]))[0]]


def test_each_pixel_has_the_state_of_what_is_seen_in_it():
    states = states_of(wall(WINDOW, GLASS, CAR), pane(WINDOW), pane(CAR, 1.0))

    assert state_at(states, 0.5, 0.5) == WALL
    assert state_at(states, 1.5, 1.8) == BEHIND
    assert state_at(states, 3.5, 1.8) == EMPTY
    assert state_at(states, 5.0, 0.5) == FRONT


def test_the_wall_is_seen_even_where_a_car_from_another_station_is_before_it():
    states = states_of(wall(), pane(CAR, 1.0))
    assert state_at(states, 5.0, 0.5) == WALL


def test_the_inner_face_of_a_wall_is_not_seen_through_a_hole():
    hidden = (3.0, 0.0, 4.0, 3.0)
    room = at(lattice(0, 0, 6, 3, STEP), -0.4)
    states = states_of(wall(hidden), room, inner=Face(0.4, 0.9))

    assert state_at(states, 3.5, 1.5) == INNER


def test_points_far_behind_and_far_in_front_show_nothing():
    states = states_of(wall(WINDOW), pane(WINDOW, -9.0), pane(WINDOW, 7.0))
    assert state_at(states, 1.5, 1.8) == EMPTY


def test_a_room_as_deep_as_the_main_wall_is_seen_behind_the_window_of_a_bay():
    bay, window = (2.0, 0.5, 4.0, 3.5), (2.6, 1.2, 3.4, 2.6)
    front = at(without(lattice(*bay, STEP), *window), 0.6)
    states = states_of(wall(bay), front, pane(window, 0.0)[::3])

    assert state_at(states, 3.0, 1.9) in (BEHIND, EMPTY)
    assert BEHIND in states.image[states.grid.holds(states.grid.cells(pane(window)[:, :2]))]


def test_the_wall_between_pilasters_is_wall():
    frame, panel = (2.0, 0.5, 4.0, 3.5), (2.3, 0.8, 3.7, 3.2)
    pilasters = at(without(lattice(*frame, STEP), *panel), 0.1)
    states = states_of(np.concatenate([wall(frame), pane(panel, 0.0)]), pilasters)

    assert state_at(states, 3.0, 1.9) == WALL


def test_a_sill_hides_what_was_seen_behind_it_from_inside_and_a_railing_does_not():
    sill = (0.8, 1.2, 2.2, 1.35)
    bars = np.concatenate([pane((u, 1.35, u + 0.02, 2.4), 0.1) for u in np.arange(1.1, 2.0, 0.12)])
    hole = (1.0, 1.2, 2.0, 2.4)
    states = states_of(wall(hole), pane(hole, -0.3), pane(sill, 0.08), bars)

    assert state_at(states, 1.5, 1.27) == FRONT
    assert all(state_at(states, u, 1.8) == BEHIND for u in np.arange(1.1, 1.95, 0.02))


@pytest.mark.parametrize("right", [2.04, 2.08])
def test_a_sill_may_end_where_its_corner_with_the_jamb_is_chipped(right):
    hole, chip = (1.0, 1.2, 2.0, 2.4), (1.96, 1.2, right, 1.4)
    sill = (0.9, 1.2, right, 1.35)
    states = states_of(wall(hole, chip), pane(hole, -0.3), pane(chip, -0.3), pane(sill, 0.08))
    assert all(state_at(states, u, 1.27) == FRONT for u in np.arange(1.1, 1.9, 0.05))


BOX, SIGN, PIPE = (1.05, 1.2, 1.95, 1.4), (0.8, 1.7, 2.2, 1.9), (1.4, 0.5, 1.6, 3.0)
SHUTTERS = (1.0, 1.2, 1.18, 2.4), (1.82, 1.2, 2.0, 2.4)


@pytest.mark.parametrize("strips", [(BOX,), SHUTTERS, (BOX, *SHUTTERS), (PIPE,), (SIGN,)])
def test_a_strip_that_does_not_lie_on_the_wall_from_jamb_to_jamb_bounds_no_opening(strips):
    hole = (1.0, 1.2, 2.0, 2.4)
    states = states_of(wall(hole), pane(hole, -0.3), *(pane(strip, 0.1) for strip in strips))
    assert all(state_at(states, *uv) == BEHIND for uv in lattice(1.0, 1.2, 2.0, 2.4, 0.05))
