"""Parts of a facade that are set back have outlines of their own."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.openings.parts import part_outlines
from ichnograph.tests.algorithms.facade.openings.scenes import STEP, states_of, wall
from ichnograph.tests.algorithms.facade.samples import at, lattice, without

STOREY = 0.0, 4.1, 6.0, 6.0


def test_a_storey_set_back_has_the_area_of_its_wall_with_its_windows():
    storey = at(without(lattice(*STOREY, STEP), 2.0, 4.6, 3.0, 5.6), -0.8)
    (outline,) = part_outlines(states_of(wall(), storey))

    assert outline.bounds == pytest.approx(STOREY, abs=3 * STEP)
    assert outline.area == pytest.approx(6.0 * 1.9, rel=0.05)


def test_a_facade_of_one_plane_has_no_other_parts():
    assert part_outlines(states_of(wall())) == []


def test_specks_are_left_out():
    storey = at(lattice(*STOREY, STEP), -0.8)
    rng = np.random.default_rng(0)
    few = rng.choice(len(storey), len(storey) - 500, replace=False)
    assert len(part_outlines(states_of(wall(), storey[few]))) == 1
