"""What is seen in an opening gives its depth, its kind and its use."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import OPENING, RECESS
from ichnograph.algorithms.facade.openings.content import DOOR, PASSAGE, fill_regions
from ichnograph.algorithms.facade.openings.content import WINDOW as A_WINDOW
from ichnograph.algorithms.facade.openings.regions import find_regions
from ichnograph.tests.algorithms.facade.openings.scenes import STEP, WINDOW, pane, reveal, states_of, wall
from ichnograph.tests.algorithms.facade.samples import lattice

GATE = (1.0, -1.0, 2.2, 2.1)


def ground(low=0.0, fall=0.0):
    """Return the ground up to 2 m before a wall, which falls by so much a metre."""
    u, w = lattice(0, 0, 6, 2, STEP).T
    return np.column_stack([u, low - fall * w, w])


def opening_of(*parts):
    states = states_of(*parts)
    (found,) = fill_regions(states, find_regions(states))
    return found


def test_a_pane_close_behind_makes_a_recess_of_its_depth():
    found = opening_of(wall(WINDOW), pane(WINDOW, -0.15))

    assert (found.kind, found.use) == (RECESS, A_WINDOW)
    assert found.depth == pytest.approx(-0.15)
    assert found.open_sides == ()


def test_a_hole_with_jambs_and_nothing_else_is_an_opening():
    assert opening_of(wall(WINDOW), reveal(WINDOW)).kind == OPENING


def test_a_door_stands_on_the_ground_and_a_passage_has_nothing_in_it():
    door = opening_of(wall(GATE), pane((1.0, 0.0, 2.2, 2.1), -0.3))
    passage = opening_of(wall(GATE), pane((1.0, 0.0, 2.2, 2.1), -2.5), reveal(GATE))

    assert (door.kind, door.use) == (RECESS, DOOR)
    assert (passage.kind, passage.use) == (OPENING, PASSAGE)
    assert door.open_sides == passage.open_sides == ("bottom",)


def test_a_door_may_stand_on_a_step_but_not_on_a_parapet():
    step, parapet = ((1.0, low, 2.2, low + 2.0) for low in (0.15, 0.5))
    assert opening_of(wall(step), pane(step, -0.3), ground()).use == DOOR
    assert opening_of(wall(parapet), pane(parapet, -0.3), ground()).use == A_WINDOW


def test_where_no_ground_was_seen_a_door_may_stand_on_a_threshold():
    door = (1.0, 0.02, 2.2, 2.1)
    found = opening_of(wall(door), pane(door, -0.3))
    assert (found.use, found.open_sides) == (DOOR, ())


@pytest.mark.parametrize("before", [
    [], [pane((0.9, 0.9, 2.3, 1.0), 0.2)], [pane((0.0, 0.0, 4.0, 0.8), 0.6), ground()], [ground()],
], ids=["nothing", "sill", "car", "ground"])  # fmt: skip
@pytest.mark.parametrize("foot", [0, 2], ids=["cropped", "hidden"])
def test_a_window_below_which_little_of_the_wall_was_seen_is_not_a_door(before, foot):
    window = (1.0, 1.0, 2.2, 2.8)
    upper = wall(window)
    upper = np.concatenate([upper[upper[:, 1] > 0.85], wall()[:foot]])
    assert opening_of(upper, pane(window), *before).use == A_WINDOW


def test_the_ground_before_a_door_may_fall():
    step = (1.0, 0.12, 2.2, 2.2)
    assert opening_of(wall(step), pane(step, -0.3), ground(fall=0.05)).use == DOOR


def test_a_niche_has_a_step_on_all_sides_and_a_wall_that_bends_has_not():
    left, bottom, right, top = WINDOW
    bending = wall(WINDOW)
    u, v, _ = bending.T
    bending[(u > left) & (u < right + 0.3) & (v > bottom) & (v < top + 0.3), 2] = -0.014
    niche = opening_of(wall(WINDOW), pane(WINDOW, -0.025))
    bend = opening_of(bending, pane(WINDOW, -0.025))

    assert (niche.bent, bend.bent) == (0, 2)


def test_what_is_set_back_a_hand_beside_a_niche_does_not_bend_into_it_however_far_apart_the_points():
    _, bottom, right, top = WINDOW
    main = wall(WINDOW)
    u, v, _ = main.T
    main[(u > right + 0.1) & (u < right + 0.3) & (v > bottom) & (v < top), 2] = -0.014
    assert opening_of(main, pane(WINDOW, -0.025)).bent == 0


def test_the_polygon_is_the_hole_within_two_pixels():
    found = opening_of(wall(WINDOW), pane(WINDOW))
    assert found.polygon.bounds == pytest.approx(WINDOW, abs=2 * 1.5 * STEP)


def test_the_points_inside_are_those_of_the_content():
    content = pane(WINDOW)
    main = wall(WINDOW)
    found = opening_of(main, content)

    assert np.isin(found.inside, np.arange(len(main), len(main) + len(content))).all()
    assert len(found.inside) > 0.8 * len(content)
