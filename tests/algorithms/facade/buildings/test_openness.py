"""The side of a wall on which the open air is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.facade.buildings.openness import even_points, sides_of

from .sites import level, upright

NORTH = np.array([0.0, 1.0])
WALL = (-10.0, 0.0, 0.0, 6.0)
"""Start and stop along (-1, 0), foot and top."""


def sides(xyz):
    return sides_of(even_points(xyz, 0.2), NORTH, 0.0, WALL)


def test_a_ceiling_along_the_wall_is_a_room():
    covered, held = sides(np.concatenate([level(0, 0.3, 10, 5, 2.7), level(0, -5, 10, 0, 0)]))
    assert covered == pytest.approx((1, 0), abs=0.05)
    assert held[0] == pytest.approx(held[1], rel=0.15)


def test_the_crown_of_a_tree_is_no_ceiling():
    crown = np.random.default_rng(0).uniform((2, 0.5, 2), (8, 4, 5.9), (20000, 3))
    assert sides(crown)[0] == pytest.approx((0, 0))


def test_neither_is_a_balcony():
    assert sides(level(2, 0, 8, 1.2, 3.0))[0] == pytest.approx((0, 0))


def test_walls_count_little_and_the_street_counts_much():
    street, house = level(0, -6, 10, -0.7, 0.0), upright((5, 0.7), (5, 6), 0, 6)
    held = sides(np.concatenate([street, house]))[1]
    assert held[1] > 5 * held[0]


@given(st.integers(1, 300), st.integers(0, 2**32 - 1))
def test_every_point_is_in_a_cube_and_every_cube_holds_a_point(count, seed):
    xyz = np.random.default_rng(seed).uniform(-3, 3, (count, 3))
    even = even_points(xyz, 0.2)
    gaps = np.abs(xyz[:, None] - even[None]).max(axis=2)
    assert np.all(gaps.min(axis=1) <= 0.1 + 1e-9) and np.all(gaps.min(axis=0) <= 0.1 + 1e-9)
