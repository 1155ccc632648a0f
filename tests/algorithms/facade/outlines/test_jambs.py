"""Points between a wall and what lies behind it: jambs, or mixed laser spots."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.outlines.jambs import is_plumb
from ichnograph.tests.algorithms.facade.samples import at, lattice

WALL = at(lattice(-0.5, -0.5, 0.0, 1.0, 0.01))


def jamb(slope):
    """Points from the end of the wall into the hole, the further the deeper they are."""
    generator = np.random.default_rng(0)
    depth, v = generator.uniform(0.01, 0.1, 400), generator.uniform(0, 1, 400)
    return np.column_stack([0.002 + slope * depth + generator.normal(0, 0.001, 400), v, -depth])


def test_points_of_a_jamb_at_right_angles_are_kept():
    assert is_plumb(jamb(0.0), WALL).mean() > 0.9


@pytest.mark.parametrize("slope", [0.2, 0.7])
def test_mixed_points_and_splayed_jambs_are_not(slope):
    assert is_plumb(jamb(slope), WALL).mean() < 0.05


def test_a_few_points_are_no_jamb():
    assert not is_plumb(jamb(0.0)[:4], WALL).any()
