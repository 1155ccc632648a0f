"""Cells of a grid as one integer each."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.geometry.packed_cells import HALF_RANGE, packed, summed, unpacked

NUMBER = st.integers(-HALF_RANGE, HALF_RANGE - 1)


@given(st.lists(st.tuples(NUMBER, NUMBER, NUMBER), min_size=1))
def test_unpacking_returns_what_was_packed(cells):
    np.testing.assert_array_equal(unpacked(packed(np.array(cells))), cells)


def test_the_cell_above_has_the_next_number():
    below, above = packed(np.array([(5, -7, 3), (5, -7, 4)]))
    assert above == below + 1


def test_values_of_one_key_are_added():
    keys, sums = summed(np.array([7, 3, 7]), np.array([[1, 10], [2, 20], [4, 40]]))

    assert keys.tolist() == [3, 7]
    assert sums.tolist() == [[2, 20], [5, 50]]


def test_nothing_sums_to_nothing():
    keys, sums = summed(np.zeros(0, np.int64), np.zeros((0, 2)))

    assert (len(keys), sums.shape) == (0, (0, 2))
