"""What workers do gives the tiles that a store on one computer holds."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.cluster.tasks import (
    Call,
    HeldTiles,
    Run,
    block_of,
    each,
    first_of,
    kept_of,
    on_part,
    part_of,
    plugin_version,
    second_of,
    sort_run,
    subset,
    summary_of,
)
from ichnograph.algorithms.clouds.tiles.tile_store import sort_here
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.scripts.house import ROOT

EDGE = 400_000


def cloud_of(folder, *parts):
    paths = [folder / f"{number}.xyz" for number in range(len(parts))]
    for path, points in zip(paths, parts):
        np.savetxt(path, points, "%.4f")
    return open_cloud(paths)


def runs_of(cloud, is_numbered=True):
    return [Run(s, s.path.stat().st_size, cloud.origin, EDGE, is_numbered) for s in cloud.sources]


def random_points(seed):
    return np.random.default_rng(seed).uniform([0, 0, 0], [9, 9, 3], (300, 3)).round(4)


@pytest.mark.parametrize("is_numbered", [True, False])
def test_the_sorted_runs_of_files_make_the_tiles_of_the_cloud(tmp_path, is_numbered):
    cloud = cloud_of(tmp_path, random_points(0), random_points(1))
    sorted_runs = [sort_run(run) for run in runs_of(cloud, is_numbered)]
    parts = [part_of(run, summary_of(run).counts) for run in sorted_runs]
    block = block_of(parts, [0, 300], EDGE)
    with sort_here(cloud, 4.0, is_numbered, Progress()) as store:
        assert block.keys() == store.counts().keys()
        for key, tile in block.items():
            np.testing.assert_array_equal(tile.xyz, store.tile(key).xyz)
            np.testing.assert_array_equal(tile.index, store.tile(key).index)
            assert (tile.corner, tile.edge) == (store.tile(key).corner, EDGE)


def test_a_summary_counts_points_with_those_in_no_tile(tmp_path):
    cloud = cloud_of(tmp_path, np.array([[1.0, 1.0, 0.0], [1.0, 5.0, 0.0], [1.0, 1.0, 30_000.0]]))
    found = summary_of(sort_run(runs_of(cloud)[0]))
    assert (found.point_count, found.stray_count, found.counts) == (3, 1, {(0, 0): 1, (0, 1): 1})


def test_what_the_reader_of_a_file_says_comes_back(tmp_path):
    cloud = cloud_of(tmp_path, random_points(0))
    assert summary_of(sort_run(runs_of(cloud)[0])).messages == ("Reading 0.xyz",)


def test_a_file_that_a_worker_does_not_find_is_one_sentence(tmp_path):
    (run,) = runs_of(cloud_of(tmp_path, random_points(0)))
    with pytest.raises(InputError, match=r"a worker finds another file than this computer as .*0\.xyz; keep"):
        sort_run(replace(run, size=17))
    run.source.path.unlink()
    with pytest.raises(InputError, match=r"SCHEDULER: a worker does not find .*0\.xyz; keep the"):
        sort_run(run)


def block(tmp_path):
    cloud = cloud_of(tmp_path, random_points(0))
    run = sort_run(runs_of(cloud)[0])
    return block_of([part_of(run, summary_of(run).counts)], [0], EDGE)


def higher(tile, limit):
    return np.flatnonzero(tile.xyz[:, 2] >= limit), "seen"


def test_points_are_left_out_without_touching_the_block_that_they_were_in(tmp_path):
    before = block(tmp_path)
    copy = pickle.dumps(before)
    left, found = kept_of(before, Call(higher, {(0, 0): (150_000,)}))
    assert pickle.dumps(before) == copy
    assert found == [((0, 0), (len(left[0, 0].xyz), "seen"))]
    assert left[0, 0].xyz[:, 2].min() >= 150_000
    np.testing.assert_array_equal(left[1, 1].xyz, before[1, 1].xyz)


def test_functions_are_called_for_each_tile_or_for_several(tmp_path):
    tiles = block(tmp_path)
    assert each(tiles, Call(count, {(1, 0): (5,), (0, 0): (0,)})) == [
        ((1, 0), len(tiles[1, 0].xyz) + 5),
        ((0, 0), len(tiles[0, 0].xyz)),
    ]
    some = subset(tiles, [(0, 0), (2, 2)])
    assert on_part([some, subset(tiles, [(1, 1)])], Call(asked, ("x",))) == ([(0, 0), (2, 2), (1, 1)], "x")


def count(tile, more):
    return len(tile.xyz) + more


def asked(tiles, progress, keys, argument):
    assert [tiles.tile(key).key for key in keys] == keys == list(tiles.counts())
    return keys, argument


def test_held_tiles_are_worked_on_by_the_thread_of_the_task(tmp_path):
    assert HeldTiles(block(tmp_path)).cores == 1


def test_pairs_can_be_taken_apart_on_a_worker():
    assert (first_of((1, 2)), second_of((1, 2))) == (1, 2)


def test_the_version_is_that_of_the_metadata():
    assert f"version={plugin_version()}\n" in (ROOT / "metadata.txt").read_text(encoding="utf-8")
