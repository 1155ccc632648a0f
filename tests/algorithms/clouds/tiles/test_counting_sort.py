"""Points are sorted by tile as a stable sort by tile would."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.tiles.counting_sort import sort_by_tile
from ichnograph.algorithms.clouds.tiles.lattice import to_lattice

EDGE = to_lattice(4.0)
NOWHERE = np.zeros(3, np.int64)


def sort(points, origin=NOWHERE, is_numbered=True):
    return sort_by_tile(np.asarray(points, float), np.asarray(origin), EDGE, 1e9, 20_000.0, is_numbered)


def test_a_point_lies_in_its_tile_and_right_of_its_corner():
    keys, starts, records = sort([[0.0, 0.0, -1.5], [4.0, 3.99999, 0.0], [-0.00001, -4.0, 2.0]])
    np.testing.assert_array_equal(keys, [[0, 0], [1, 0], [-1, -1]])
    np.testing.assert_array_equal(starts, [0, 1, 2, 3])
    np.testing.assert_array_equal(
        records, [[0, 0, -150_000, 0], [0, 399_999, 0, 1], [399_999, 0, 200_000, 2]]
    )


@given(seed=st.integers(0, 1000), count=st.integers(0, 300), size=st.sampled_from([3.0, 30.0, 3e6]))
def test_it_is_a_stable_sort(seed, count, size):
    points = np.random.default_rng(seed).uniform(-size, size, (count, 3)).round(3)
    points[:, 2] /= 1e3
    keys, starts, records = sort(points)
    tiles = np.floor(np.rint(points[:, :2] * 1e5) / EDGE).astype(int)
    assert (len(keys), starts[-1]) == (len(np.unique(tiles, axis=0)), count)
    for key, start, stop in zip(keys, starts, starts[1:]):
        inside = np.flatnonzero((tiles == key).all(axis=1))
        np.testing.assert_array_equal(records[start:stop, 3], inside)
        np.testing.assert_array_equal(records[start:stop, :2] + key * EDGE, np.rint(points[inside, :2] * 1e5))


@pytest.mark.parametrize("stray", [[0, 0, 20_000.0], [0, 0, -3e4], [1e9, 0, 0], [0, -2e9, 0]])
def test_stray_points_are_left_out(stray):
    _, starts, records = sort([[1, 1, 1], stray, [2, 2, 2]])
    np.testing.assert_array_equal(starts, [0, 2])
    np.testing.assert_array_equal(records[:, 3], [0, 2])


def test_heights_count_from_zero_not_from_the_origin():
    assert len(sort([[0, 0, 1.0]], [0, 0, 19_999])[2]) == 0
    assert sort([[0, 0, 1.0]], [0, 0, 7])[2][0, 2] == to_lattice(8.0)


def test_records_without_numbers_are_three_integers_wide():
    assert sort(np.zeros((5, 3)), is_numbered=False)[2].shape == (5, 3)
