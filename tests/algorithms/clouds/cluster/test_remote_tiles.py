"""Tiles on a cluster are those of a store on one computer."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.cluster.sorting import sort_on_cluster
from ichnograph.algorithms.clouds.settings import ClusterSettings
from ichnograph.algorithms.clouds.tiles.tile_store import sort_here
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.cluster.jobs import higher, highest, points_in


@pytest.fixture
def stores(cluster, tmp_path):
    """Return the same cloud, sorted on this computer and on the cluster."""
    np.savetxt(tmp_path / "a.xyz", np.random.default_rng(0).uniform(0, 20, (500, 3)), "%.4f")
    cloud = open_cloud([tmp_path / "a.xyz"])
    settings = ClusterSettings(block_tiles=2)
    with (
        sort_here(cloud, 4.0, True, Progress()) as here,
        sort_on_cluster(cluster.address, cloud, 4.0, True, Progress(), settings) as there,
    ):
        yield here, there


def assert_same(one, other):
    np.testing.assert_array_equal(one.xyz, other.xyz)
    np.testing.assert_array_equal(one.index, other.index)
    assert (one.corner, one.edge) == (other.corner, other.edge)


def test_tiles_come_one_by_one_or_in_a_row_as_they_are_on_one_computer(stores):
    here, there = stores
    assert there.counts() == here.counts()
    assert (there.edge, there.point_count, there.stray_count) == (here.edge, 500, 0)
    keys = sorted(here.counts(), reverse=True)
    assert_same(there.tile(keys[3]), here.tile(keys[3]))
    fetched = list(there.tiles(keys, Progress(), "Reading"))
    assert [key for key, _ in fetched] == keys
    for key, tile in fetched:
        assert_same(tile, here.tile(key))


def test_points_are_left_out_and_remain_so(stores):
    jobs = {(0, 0): (900_000,), (1, 0): (2_000_000,), (4, 4): (0,)}
    found = [dict(store.keep_where(higher, jobs, Progress(), "Cutting")) for store in stores]
    assert found[0] == found[1]
    here, there = stores
    assert there.counts() == here.counts()
    assert there.counts()[1, 0] == 0
    for key, tile in there.tiles(list(here.counts()), Progress(), "Reading"):
        assert_same(tile, here.tile(key))


def test_work_is_done_on_tiles_and_on_several_of_them_where_they_are(stores):
    keys = sorted(stores[0].counts())
    jobs = {key: (key[0],) for key in keys}
    parts = [(keys[:7], ("a",)), (keys[5:], ("b",))]
    each = [dict(store.each(highest, jobs, Progress(), "Reading")) for store in stores]
    assert each[0] == each[1]
    several = [list(store.on_parts(points_in, parts, Progress(), "Reading")) for store in stores]
    assert several[0] == several[1]
