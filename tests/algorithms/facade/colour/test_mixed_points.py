"""Points at the border of a coloured detail belong to the side that they resemble."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.colour.appearance import Appearance
from ichnograph.algorithms.facade.colour.mixed_points import divide_at_half
from ichnograph.tests.algorithms.facade.colour.panel import (
    GREEN,
    LINKED,
    MESH,
    PANEL,
    POINTS,
    STEP,
    WHITE,
    painted,
    reflecting,
)

LINKS = MESH.neighbours(LINKED)


@pytest.mark.parametrize("relative", [None, reflecting()], ids=["colour", "intensity"])
def test_points_at_the_border_join_the_side_that_they_resemble(relative):
    looks = Appearance(painted(), relative, 0.06)
    grown = ((POINTS > (0.97, 0.47)) & (POINTS < (1.63, 1.33))).all(axis=1)
    np.testing.assert_array_equal(divide_at_half(MESH, LINKS, looks, grown, STEP, 30.0), PANEL)


def test_specks_beyond_the_border_do_not_belong_to_the_detail():
    rgb = painted()
    speck = ((POINTS > (1.62, 0.8)) & (POINTS < (1.66, 0.84))).all(axis=1) & (POINTS[:, 0] > 1.64)
    rgb[speck] = GREEN
    divided = divide_at_half(MESH, LINKS, Appearance(rgb), PANEL, STEP, 30.0)
    assert not divided[speck].any()


def test_a_border_between_similar_colours_is_left_as_it_is():
    looks = Appearance(painted(panel=WHITE - 10))
    grown = ((POINTS > (0.97, 0.47)) & (POINTS < (1.63, 1.33))).all(axis=1)
    np.testing.assert_array_equal(divide_at_half(MESH, LINKS, looks, grown, STEP, 30.0), grown)
