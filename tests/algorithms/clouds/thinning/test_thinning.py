"""Thinning keeps a minimum distance, misses nobody, and depends on nothing but the points."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.thinning.thinning import deciding, thin_cloud, thin_tiles
from ichnograph.algorithms.clouds.tiles.tile_store import TileStore
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from scipy.spatial import cKDTree

ORIGIN = np.array([412_300.0, 5_812_700.0, 0.0])


def cloud_of(*parts, origin=ORIGIN):
    """Return a cloud whose chunks are `parts`, in metres about `origin`."""
    chunks = [np.asarray(part, float).reshape(-1, 3) for part in parts]
    source = SimpleNamespace(path=SimpleNamespace(name="scan.laz"))
    return SimpleNamespace(
        positions=lambda progress: iter(chunks),
        expected_points=0,
        origin=origin,
        warnings=(),
        sources=(source,),
    )


def scattered(count, seed=0, size=(9.0, 6.0, 3.0)):
    """Random points at millimetres, as in a file, over several tiles."""
    points = np.random.default_rng(seed).uniform(-1, 1, (count, 3)) * size
    return points.round(3)


def test_no_two_kept_points_are_closer_than_the_spacing():
    points = scattered(40_000)
    kept = points[thin_cloud(cloud_of(points), 0.25).kept]
    nearest = cKDTree(kept).query(kept, k=2)[0][:, 1]
    assert nearest.min() >= 0.25 - 1e-9


def test_every_dropped_point_is_closer_than_the_spacing_to_a_kept_one():
    points = scattered(40_000)
    kept = points[thin_cloud(cloud_of(points), 0.25).kept]
    assert cKDTree(kept).query(points)[0].max() < 0.25


def test_points_exactly_the_spacing_apart_are_all_kept_at_grid_coordinates():
    x, y = np.meshgrid(np.arange(200) * 0.05, np.arange(200) * 0.05)
    points = np.column_stack([x.ravel(), y.ravel(), np.full(x.size, 71.3)])
    assert len(thin_cloud(cloud_of(points), 0.05).kept) == x.size


def test_a_slope_keeps_no_stripes_where_it_crosses_the_layers_of_a_grid():
    x, y = np.meshgrid(np.arange(0, 8, 0.01), np.arange(0, 2, 0.01))
    points = np.column_stack([x.ravel(), y.ravel(), 0.1 * x.ravel()])
    kept = points[thin_cloud(cloud_of(points), 0.05).kept]
    counts = np.histogram(kept[:, 0], bins=np.arange(0, 8.01, 0.1))[0]
    assert counts.std() < 0.1 * counts.mean()


def test_duplicates_leave_one_point():
    assert thin_cloud(cloud_of(np.zeros((100, 3))), 0.05).kept.tolist() == [0]


@settings(max_examples=15, deadline=None)
@given(cuts=st.lists(st.integers(0, 3000), max_size=5), seed=st.integers(0, 5))
def test_the_result_does_not_depend_on_how_the_cloud_is_cut(cuts, seed):
    points = scattered(3000, seed)
    whole = thin_cloud(cloud_of(points), 0.4).kept
    parts = np.split(points, sorted(cuts))
    np.testing.assert_array_equal(thin_cloud(cloud_of(*parts), 0.4).kept, whole)


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000))
def test_the_result_does_not_depend_on_the_order_of_the_points(seed):
    points = scattered(3000)
    order = np.random.default_rng(seed).permutation(len(points))
    kept = {tuple(p) for p in points[thin_cloud(cloud_of(points), 0.4).kept]}
    shuffled = points[order]
    assert {tuple(p) for p in shuffled[thin_cloud(cloud_of(shuffled), 0.4).kept]} == kept


def test_the_result_does_not_depend_on_the_local_origin():
    points = scattered(5000)
    moved = cloud_of(points + [300.0, -200.0, 0.0], origin=ORIGIN - [300.0, -200.0, 0.0])
    np.testing.assert_array_equal(thin_cloud(moved, 0.3).kept, thin_cloud(cloud_of(points), 0.3).kept)


def test_coordinates_finer_than_the_lattice_do_not_depend_on_the_local_origin_either():
    points = np.random.default_rng(3).uniform(-4, 4, (20_000, 3)).round(6)
    moved = cloud_of(points + [300.0, -200.0, 0.0], origin=ORIGIN - [300.0, -200.0, 0.0])
    np.testing.assert_array_equal(thin_cloud(moved, 0.2).kept, thin_cloud(cloud_of(points), 0.2).kept)


def test_a_spacing_wider_than_a_tile_holds_too():
    points = scattered(4000, size=(40.0, 40.0, 1.0))
    kept = points[thin_cloud(cloud_of(points), 9.0).kept]
    assert cKDTree(kept).query(kept, k=2)[0][:, 1].min() >= 9.0 - 1e-9
    assert cKDTree(kept).query(points)[0].max() < 9.0


def test_a_few_absurd_points_are_left_out_with_a_warning():
    points = np.concatenate([scattered(1000), [[0.0, 0.0, 1e12], [1e13, 0.0, 0.0]]])
    thinned = thin_cloud(cloud_of(points), 0.4)
    assert thinned.kept.max() < 1000
    assert "2 of 1002 points" in thinned.warnings[0]


def test_geocentric_coordinates_are_refused():
    with pytest.raises(InputError, match=r"scan\.laz.*geocentric"):
        thin_cloud(cloud_of(scattered(100) + [0, 0, 4_900_000.0]), 0.05)


def test_cancelling_stops_the_work():
    with pytest.raises(CancelledError):
        thin_cloud(cloud_of(scattered(100)), 0.05, Progress(is_cancelled=lambda: True))


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 1000), own=st.sets(st.tuples(st.integers(-4, 3), st.integers(-4, 3)), min_size=1))
def test_the_choice_in_some_tiles_depends_on_no_more_than_the_tiles_that_decide_it(seed, own):
    with TileStore(4.0, is_numbered=True) as store:
        # Sparse enough for a choice to depend on that in the next tile, and that on the one after.
        store.add(scattered(400, seed, size=(15.0, 15.0, 0.1)), np.zeros(3))
        among = set(store.counts())
        own &= among
        needed = deciding(own, among)
        assert own <= {*needed} <= among

        whole = chosen(store, list(among), own)
        assert chosen(store, needed, own) == whole


def chosen(store, keys, own):
    """Return the numbers of the points chosen in the tiles `own` when `keys` are thinned."""
    return {
        tile.key: tile.index[rows].tolist()
        for tile, rows in thin_tiles(store, keys, 3.5, Progress())
        if tile.key in own
    }


def test_the_choice_in_a_tile_depends_on_tiles_three_columns_and_a_row_away_at_most():
    every = {(column, row) for column in range(-8, 8) for row in range(-8, 8)}
    far = [
        np.abs(np.array(deciding([key], every)) - key).max(axis=0) for key in ((0, 0), (1, 0), (0, 1), (1, 1))
    ]
    np.testing.assert_array_equal(far, [(0, 0), (1, 0), (2, 1), (3, 1)])
