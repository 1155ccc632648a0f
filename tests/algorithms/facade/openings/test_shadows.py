"""What a car hides beside a door is not part of the door."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.openings.regions import find_regions
from ichnograph.tests.algorithms.facade.openings.scenes import STEP, pane, states_of, wall

DOOR, SHADOW = (2.0, -0.1, 3.2, 2.3), (0.8, -0.1, 2.0, 0.8)
SECOND = 4.2, -0.1, 5.2, 2.3


def boxes(*parts):
    states = states_of(*parts)
    return [tuple(states.grid.edges(region.box)) for region in find_regions(states)]


def within_pixels(box):
    left, _, right, top = box
    return pytest.approx((left, 0.0, right, top), abs=3 * STEP)


def test_the_shadow_of_a_car_beside_a_door_is_left_out():
    (found,) = boxes(wall(DOOR, SHADOW), pane(DOOR, -0.3))
    assert found == within_pixels(DOOR)


def test_a_shadow_that_joins_two_doors_divides_them():
    between = (3.2, -0.1, 4.2, 0.8)
    first, second = boxes(wall(DOOR, SECOND, between), pane(DOOR, -0.3), pane(SECOND, -0.3))
    assert (first, second) == (within_pixels(DOOR), within_pixels(SECOND))


def test_a_low_door_beside_a_high_one_is_kept_if_something_is_seen_in_it():
    gate = (0.8, -0.1, 2.0, 1.2)
    found = boxes(wall(DOOR, gate), np.concatenate([pane(DOOR, -0.3), pane(gate, -0.3)]))
    assert min(left for left, *_ in found) == pytest.approx(gate[0], abs=3 * STEP)
