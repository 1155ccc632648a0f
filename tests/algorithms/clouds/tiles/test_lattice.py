"""Coordinates on the lattice do not depend on the origin from which they are read."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.tiles.lattice import LATTICE, on_lattice, to_lattice


def test_a_step_is_10_micrometres():
    assert to_lattice(1.0) == 100_000
    assert to_lattice(0.05) == 5_000
    assert to_lattice(LATTICE) == 1


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
