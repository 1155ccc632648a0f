"""What is seen in an opening gives its depth, its kind and its use."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import OPENING, RECESS
from ichnograph.algorithms.facade.openings.content import DOOR, PASSAGE, fill_regions
from ichnograph.algorithms.facade.openings.content import WINDOW as A_WINDOW
from ichnograph.algorithms.facade.openings.regions import find_regions
from ichnograph.tests.algorithms.facade.openings.scenes import STEP, WINDOW, pane, reveal, states_of, wall

GATE = (1.0, -1.0, 2.2, 2.1)


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
    assert opening_of(wall(step), pane(step, -0.3)).use == DOOR
    assert opening_of(wall(parapet), pane(parapet, -0.3)).use == A_WINDOW


def test_a_niche_has_a_step_on_all_sides_and_a_wall_that_bends_has_not():
    left, bottom, right, top = WINDOW
    bending = wall(WINDOW)
    u, v, _ = bending.T
    bending[(u > left) & (u < right + 0.3) & (v > bottom) & (v < top + 0.3), 2] = -0.014
    niche = opening_of(wall(WINDOW), pane(WINDOW, -0.025))
    bend = opening_of(bending, pane(WINDOW, -0.025))

    assert (niche.bent, bend.bent) == (0, 2)


def test_the_polygon_is_the_hole_within_two_pixels():
    found = opening_of(wall(WINDOW), pane(WINDOW))
    assert found.polygon.bounds == pytest.approx(WINDOW, abs=2 * 1.5 * STEP)


def test_the_points_inside_are_those_of_the_content():
    content = pane(WINDOW)
    main = wall(WINDOW)
    found = opening_of(main, content)

    assert np.isin(found.inside, np.arange(len(main), len(main) + len(content))).all()
    assert len(found.inside) > 0.8 * len(content)
