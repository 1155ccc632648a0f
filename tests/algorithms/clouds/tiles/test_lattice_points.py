"""Coordinates on the lattice do not depend on the origin from which they are read."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.tiles.lattice import LATTICE
from ichnograph.algorithms.clouds.tiles.lattice_points import limits_of, on_lattice


@given(
    x=st.integers(-(10**9), 10**9),
    east=st.integers(-7_000_000, 7_000_000),
    other=st.integers(-7_000_000, 7_000_000),
)
def test_steps_are_the_same_from_any_origin(x, east, other):
    # Half a step is the worst case: a tie must be rounded to the same side from everywhere.
    metres = x * LATTICE / 2
    assert on_lattice(metres, east) == on_lattice(metres - (other - east), other)


def test_coordinates_with_seven_digits_keep_every_step():
    assert on_lattice(0.12345, 7_000_000) == pytest.approx(7_000_000.12345 / LATTICE, abs=0.4)


def test_limits_are_the_smallest_and_the_largest_of_each_axis():
    low, high = limits_of(np.array([[3, -1, 5], [2, 7, 5]], np.int32))

    assert (list(low), list(high)) == ([2, -1, 5], [3, 7, 5])
