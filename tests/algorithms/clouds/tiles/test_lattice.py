"""Coordinates on the lattice do not depend on the origin from which they are read."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.tiles.lattice import LATTICE, tiles_of, to_lattice


def test_a_step_is_10_micrometres():
    assert to_lattice(1.0) == 100_000
    assert to_lattice(0.05) == 5_000
    assert to_lattice(LATTICE) == 1


def test_a_point_lies_in_its_tile_and_right_of_its_corner():
    xyz = np.array([[0.0, 0.0, -1.5], [4.0, 3.99999, 0.0], [-0.00001, -4.0, 2.0]])
    tile, steps = tiles_of(xyz, np.array([0, 0, 0]), to_lattice(4.0))
    np.testing.assert_array_equal(tile, [[0, 0], [1, 0], [-1, -1]])
    np.testing.assert_array_equal(steps, [[0, 0, -150_000], [0, 399_999, 0], [399_999, 0, 200_000]])


@given(
    x=st.integers(-(10**9), 10**9),
    east=st.integers(-7_000_000, 7_000_000),
    other=st.integers(-7_000_000, 7_000_000),
)
def test_tile_and_steps_are_the_same_from_any_origin(x, east, other):
    # Half a step is the worst case: a tie must be rounded to the same side from everywhere.
    metres = x * LATTICE / 2
    edge = to_lattice(4.0)
    found = []
    for origin in (east, other):
        point = np.array([[metres - (origin - east), 0.0, 0.0]])
        found.append(tiles_of(point, np.array([origin, 0, 0]), edge))
    np.testing.assert_array_equal(found[0][0], found[1][0])
    np.testing.assert_array_equal(found[0][1], found[1][1])


def test_coordinates_with_seven_digits_keep_every_step():
    tile, steps = tiles_of(np.array([[0.12345, 0.0, 0.0]]), np.array([7_000_000, 0, 0]), to_lattice(4.0))
    assert (tile[0, 0] * 4.0, steps[0, 0] * LATTICE) == (7_000_000, pytest.approx(0.12345, abs=1e-12))
