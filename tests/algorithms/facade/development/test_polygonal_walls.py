"""The sides of a bay or a tower follow each other along corners."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.development.polygonal_walls import find_sides
from ichnograph.algorithms.facade.elevation import Plane

from .towers import BAY, ground, sides

SOUTH = Plane(np.array([0.0, -1.0, 0.0]), np.array([4.8, -0.8, 2.0]), 0.002, 100)
DISTANCE = 0.05


def test_a_wall_with_a_canted_bay_has_five_sides():
    chain = find_sides(np.concatenate([sides(BAY), ground(-2, -6, 12, -1)]), SOUTH, DISTANCE)
    assert chain.main == 2
    np.testing.assert_allclose(chain.corners[1:-1], np.array(BAY)[1:-1], atol=0.02)
    np.testing.assert_allclose(chain.corners[[0, -1]], np.array(BAY)[[0, -1]], atol=0.3)


def test_above_a_bay_the_wall_may_go_on():
    wall = sides([(0, 0), (9.6, 0)], top=5.6)
    above = wall[(wall[:, 0] > 3) & (wall[:, 0] < 6.6) & (wall[:, 2] > 5)]
    chain = find_sides(np.concatenate([sides(BAY), above]), None, DISTANCE)
    np.testing.assert_allclose(chain.corners[1:-1], np.array(BAY)[1:-1], atol=0.02)


def test_behind_the_side_of_a_bay_the_wall_may_go_on():
    (foot, _), (right, _) = BAY[4], BAY[-1]
    behind = sides([(foot - 0.7, 0), (right, 0)])
    chain = find_sides(np.concatenate([sides(BAY), behind]), SOUTH, DISTANCE)
    np.testing.assert_allclose(chain.corners[1:-1], np.array(BAY)[1:-1], atol=0.02)


def test_an_oblique_wall_that_meets_a_facade_amid_it_does_not_cut_it():
    beside = sides([(4, 0), (7, -3)])
    assert find_sides(np.concatenate([sides([(0, 0), (8, 0)]), beside]), None, DISTANCE) is None


def test_the_main_side_is_the_wanted_one():
    other = Plane(np.array([0.0, -1.0, 0.0]), np.array([1.5, 0.0, 2.0]), 0.002, 100)
    assert find_sides(sides(BAY), other, DISTANCE).main == 0


def test_the_corner_of_a_building_ends_the_chain():
    assert find_sides(sides([(0, 6), (0, 0), (8, 0), (8, 6)]), None, DISTANCE) is None


@pytest.mark.parametrize("count", [6, 8])
def test_polygonal_towers_are_followed_around(count):
    turns = np.radians(180 + np.arange(-1.5, 2.0) * 360 / count)
    corners = 3 * np.column_stack([np.sin(turns), np.cos(turns)])[::-1]
    chain = find_sides(sides(corners), None, DISTANCE)
    assert len(chain.corners) == 4
    assert {round(float(x), 1) for x in np.linalg.norm(chain.corners[1:-1], axis=1)} == {3.0}


def test_a_flat_wall_has_no_sides():
    assert find_sides(sides([(0, 0), (8, 0)]), None, DISTANCE) is None
