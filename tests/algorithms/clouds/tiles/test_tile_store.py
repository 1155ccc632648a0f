"""A store gives back all points by tile, in the order of the cloud."""

import tempfile
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.settings import TileSettings
from ichnograph.algorithms.clouds.tiles.lattice import LATTICE
from ichnograph.algorithms.clouds.tiles.tile_store import TileStore, fill, sort_here, stray_warning
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.progress import Progress

ORIGIN = np.array([600_000.0, 5_000_000.0, 0.0])
ON_DISK = TileSettings(memory_bytes=0)
XYZ = np.random.default_rng(4).uniform([-9, -9, 0], [9, 9, 3], (200, 3)).round(4)


def points_of(store):
    """Return the coordinates that a store holds, in the order of the cloud."""
    tiles = [store.tile(key) for key in store.counts()]
    order = np.argsort(np.concatenate([tile.index for tile in tiles]))
    corners = [np.tile([*tile.corner, 0], (len(tile.xyz), 1)) for tile in tiles]
    return ((np.concatenate([tile.xyz for tile in tiles]) + np.concatenate(corners)) * LATTICE)[order]


@pytest.mark.parametrize("pieces", [1, 7, 200])
@pytest.mark.parametrize("memory", [0, 900, 10**6], ids=["on disk", "partly on disk", "in memory"])
def test_all_points_come_back_however_they_arrive(pieces, memory):
    with TileStore(4.0, TileSettings(memory_bytes=memory), is_numbered=True) as store:
        for part in np.array_split(XYZ, pieces):
            store.add(part, ORIGIN)
        assert store.point_count == sum(store.counts().values()) == 200
        np.testing.assert_allclose(points_of(store), XYZ + ORIGIN, rtol=0, atol=1e-8)


def test_a_tile_holds_its_points_in_the_order_of_the_cloud():
    with TileStore(4.0, is_numbered=True) as store:
        for part in np.array_split(XYZ, 3):
            store.add(part, ORIGIN)
        for key, tile in store.tiles(list(store.counts()), Progress(), "Reading"):
            inside = np.floor((XYZ[:, :2] + ORIGIN[:2]) / 4.0 + 1e-9).astype(int)
            np.testing.assert_array_equal(tile.index, np.flatnonzero((inside == key).all(axis=1)))
            assert tile.xyz[:, :2].min() >= 0 and tile.xyz[:, :2].max() < tile.edge


@pytest.mark.parametrize("memory", [0, 1300, 10**6], ids=["on disk", "partly on disk", "in memory"])
def test_rows_that_are_not_kept_are_gone(memory):
    with TileStore(100.0, TileSettings(memory_bytes=memory), is_numbered=True) as store:
        for part in np.array_split(XYZ, 3):
            store.add(part, np.zeros(3))
        key = max(store.counts(), key=store.counts().get)
        before = store.tile(key)
        rows = np.arange(0, len(before.xyz), 3)
        store.keep(key, rows)
        assert store.counts()[key] == len(rows)
        np.testing.assert_array_equal(store.tile(key).index, before.index[rows])
        np.testing.assert_array_equal(store.tile(key).xyz, before.xyz[rows])


def test_a_point_takes_12_bytes_and_a_file_is_made_only_beyond_the_budget(monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "none"))
    with TileStore(4.0, TileSettings(memory_bytes=200 * 12)) as store:
        store.add(XYZ, ORIGIN)
        assert len(store.tile(next(iter(store.counts()))).index) == 0
        with pytest.raises(InputError, match="temporary file"):
            store.add(XYZ, ORIGIN)


def test_points_for_which_the_temporary_folder_has_no_room_are_refused_at_once():
    with TileStore(4.0, TileSettings(memory_bytes=12 * 10**18)) as store:
        store.expect(10**18)
        with pytest.raises(InputError, match=r"take up to 12\d+\.\d GB; free some space, or set TMPDIR"):
            store.expect(2 * 10**18)


def test_stray_points_are_counted_and_left_out():
    stray = np.array([[0, 0, 30_000.0], [2e9, 0, 0]])
    with TileStore(4.0) as store:
        store.add(np.concatenate([XYZ, stray]), ORIGIN)
        assert (store.point_count, store.stray_count, sum(store.counts().values())) == (202, 2, 200)
    with TileStore(4.0, TileSettings(max_height_m=1.0)) as store:
        store.add(XYZ, ORIGIN)
        assert store.stray_count == (XYZ[:, 2] >= 1).sum()


def cloud(path: Path, heights):
    np.savetxt(path, np.column_stack([np.arange(len(heights)), np.zeros(len(heights)), heights]), "%.3f")
    return open_cloud([path])


def test_a_cloud_of_which_too_much_is_stray_is_refused(tmp_path):
    with TileStore(4.0) as store, pytest.raises(InputError, match="2 of 100 points lie more than 20 km high"):
        fill(store, cloud(tmp_path / "a.xyz", [0.5] * 98 + [1e6] * 2), Progress())


def test_one_stray_point_in_a_hundred_is_a_warning(tmp_path):
    site = cloud(tmp_path / "a.xyz", [0.5] * 99 + [1e6])
    with TileStore(4.0) as store:
        fill(store, site, Progress())
        assert stray_warning(site, store.stray_count, store.point_count) == (
            "a.xyz: 1 of 100 points lie far away from the site and are left out.",
        )
    assert stray_warning(site, 0, 100) == ()


def test_a_store_that_is_not_open_says_so():
    with pytest.raises(ValueError, match="not open"):
        TileStore(4.0).add(XYZ, ORIGIN)


def test_a_full_temporary_disk_is_one_sentence():
    if not Path("/dev/full").exists():
        pytest.skip("this system has no device that is always full")
    with TileStore(4.0, ON_DISK) as store, Path("/dev/full").open("r+b", buffering=0) as full:
        store._open_file = full
        with pytest.raises(InputError, match=r"temporary file of the points cannot be written .* set TMPDIR"):
            store.add(XYZ, ORIGIN)


def test_a_temporary_folder_that_is_missing_is_one_sentence(monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "none"))
    with (
        TileStore(4.0, ON_DISK) as store,
        pytest.raises(InputError, match="temporary file of the points cannot be written"),
    ):
        store.add(XYZ, ORIGIN)


def test_points_can_be_left_out_by_a_rule_of_each_tile(tmp_path):
    with sort_here(cloud(tmp_path / "a.xyz", range(9)), 4.0, False, Progress()) as store:
        jobs = {key: (limit,) for limit, key in enumerate(sorted(store.counts()), start=1)}
        found = dict(store.keep_where(lowest, jobs, Progress(), "Cutting"))
        assert found == {(0, 0): 4, (1, 0): 4, (2, 0): 1}
        assert store.counts() == {(0, 0): 1, (1, 0): 2, (2, 0): 1}


def lowest(tile, count):
    """Return the lowest rows of a tile, and how many it had."""
    return np.sort(np.argsort(tile.xyz[:, 2])[:count]), len(tile.xyz)
