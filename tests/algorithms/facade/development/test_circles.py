"""The circle of a round tower is found among other walls, and flat walls have none."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.development.circles import find_circle

from .towers import ground, round_wall, sides


@pytest.mark.parametrize(("radius", "seen"), [(1.2, 150), (3.2, 120), (8.0, 100)])
def test_centre_and_radius_are_those_of_the_tower(radius, seen):
    wall = round_wall((3.0, 4.0), radius, 180 - seen / 2, 180 + seen / 2)
    circle = find_circle(wall)
    assert circle.radius == pytest.approx(radius, abs=0.01)
    np.testing.assert_allclose(circle.centre, (3.0, 4.0), atol=0.015)
    assert circle.azimuth == pytest.approx(180, abs=3)


def test_a_tower_is_found_beside_the_flat_walls_and_the_street():
    tower = round_wall((0.0, 0.0), 2.5, 100, 250)
    walls = sides([(-8, 2), (-2.4, 0.7)]), sides([(2.4, 0.7), (7, 2)])
    circle = find_circle(np.concatenate([tower, *walls, ground(-8, -8, 8, -2.6)]))
    assert circle.radius == pytest.approx(2.5, abs=0.01)


def test_a_whole_tower_is_a_circle_too():
    assert find_circle(round_wall((0, 0), 2.0, 0, 360)).radius == pytest.approx(2.0, abs=0.01)


def test_flat_walls_and_rooms_have_no_circle():
    assert find_circle(sides([(0, 0), (9, 0)])) is None
    assert find_circle(sides([(0, 0), (6, 0), (6, 5), (0, 5), (0, 0)])) is None


def test_of_a_shallow_arc_no_radius_is_claimed():
    assert find_circle(round_wall((0, 0), 6.0, 170, 200)) is None
