"""A floor that crosses the wall divides what is above it from what is below; a rail does not."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.openings.floors import divide_at_floors
from ichnograph.algorithms.facade.openings.regions import find_regions
from ichnograph.tests.algorithms.facade.openings.scenes import STEP, pane, states_of, wall
from ichnograph.tests.algorithms.facade.samples import lattice

DOORS = 2.0, 0.0, 3.2, 3.8
LEVEL = 1.9


def level(near, far):
    """Return points of a level surface over the width of the doors, between two depths."""
    u, w = lattice(DOORS[0], near, DOORS[2], far, STEP / 2).T
    return np.column_stack([u, np.full(len(u), LEVEL), w])


def boxes(*parts):
    states = states_of(wall(DOORS), pane(DOORS, -0.3), *parts)
    return [tuple(states.grid.edges(part.box)) for part in divide_at_floors(find_regions(states), states)]


def test_a_door_and_the_one_above_its_landing_come_apart_at_the_landing():
    below, above = boxes(level(-0.3, 0.8))
    assert below[3] == pytest.approx(LEVEL, abs=0.25)
    assert above[1] == below[3]
    assert above[3] == pytest.approx(DOORS[3], abs=2.5 * STEP)


@pytest.mark.parametrize("span", [(0.1, 0.15), (-0.3, 0.02), (0.1, 0.8)], ids=["rail", "transom", "awning"])
def test_what_is_only_before_or_behind_the_wall_divides_nothing(span):
    assert len(boxes(level(*span))) == 1
