"""Within a tile, points are chosen greedily, none closer than the reach to a chosen one."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.thinning.neighbour_table import _by_hash, choose
from scipy.spatial import cKDTree

NO_SEEDS = np.empty((0, 3), np.int64)


def points(seed, count=300, size=400):
    return np.random.default_rng(seed).integers(0, size, (count, 3)).astype(np.int32)


@settings(deadline=None, max_examples=30)
@given(seed=st.integers(0, 1000), reach=st.integers(1, 150))
def test_chosen_points_keep_their_distance_and_all_others_are_near_one(seed, reach):
    xyz = points(seed)
    kept = choose(xyz, NO_SEEDS, (0, 0), reach)
    chosen = xyz[kept]
    assert len(cKDTree(chosen).query_pairs(reach * (1 - 1e-9))) == 0
    others = np.delete(xyz, kept, axis=0)
    if len(others):
        assert cKDTree(chosen).query(others)[0].max() < reach


@given(
    hashes=st.lists(st.one_of(st.integers(0, 3), st.integers(0, 2**64 - 1)), max_size=200),
)
def test_hashes_are_sorted_stably_even_where_they_are_equal(hashes):
    hashes = np.array(hashes, np.uint64)
    np.testing.assert_array_equal(_by_hash(hashes), np.argsort(hashes, kind="stable"))


def test_points_exactly_at_the_reach_are_both_chosen():
    xyz = np.array([[0, 0, 0], [100, 0, 0]], np.int32)
    assert sorted(choose(xyz, NO_SEEDS, (0, 0), 100)) == [0, 1]
    assert len(choose(xyz, NO_SEEDS, (0, 0), 101)) == 1


@pytest.mark.parametrize("seed", [(-50, 0, 0), (450, 200, 200)])
def test_points_near_a_chosen_one_of_another_tile_are_left_out(seed):
    xyz = points(1)
    kept = choose(xyz, np.array([seed], np.int64), (0, 0), 100)
    assert np.linalg.norm(xyz[kept] - np.array(seed), axis=1).min() >= 100


def test_the_choice_depends_on_where_points_are_and_not_on_their_order():
    xyz = points(2)
    shuffled = np.random.default_rng(3).permutation(len(xyz))
    first = {tuple(point) for point in xyz[choose(xyz, NO_SEEDS, (7, 9), 80)]}
    second = {tuple(point) for point in xyz[shuffled][choose(xyz[shuffled], NO_SEEDS, (7, 9), 80)]}
    assert first == second
