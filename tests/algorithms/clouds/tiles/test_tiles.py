"""Tiles are worked on one by one or several together, wherever they are."""

import numpy as np
from ichnograph.algorithms.clouds.tiles.tile_store import TileStore
from ichnograph.algorithms.clouds.tiles.tiles import Tile, by_block
from ichnograph.algorithms.progress import Progress


def tile(column, row, count=3):
    edge = 400_000
    return Tile((column * edge, row * edge), np.arange(3 * count).reshape(-1, 3), np.arange(count) + 7, edge)


def test_a_tile_knows_its_column_and_row():
    assert tile(-3, 12).key == (-3, 12)


def test_some_points_of_a_tile_keep_their_numbers():
    some = tile(0, 0).subset(np.array([0, 2]))
    assert some.xyz.tolist() == [[0, 1, 2], [6, 7, 8]]
    assert some.index.tolist() == [7, 9]


def test_tiles_of_a_block_are_found_on_both_sides_of_zero():
    keys = [(-1, 0), (0, 0), (1, 1), (2, 0)]
    assert by_block(keys, 2) == {(-1, 0): [(-1, 0)], (0, 0): [(0, 0), (1, 1)], (1, 0): [(2, 0)]}
    assert by_block(keys, None) == {(0, 0): keys}


def fill(store, *columns):
    store.add(np.array([[4.0 * column + 1, 1.0, 0.0] for column in columns]), np.zeros(3))


def test_work_on_each_tile_gets_its_own_arguments():
    with TileStore(4.0) as store:
        fill(store, 0, 0, 2)
        jobs = {(0, 0): ("a",), (2, 0): ("b",)}
        found = store.each(lambda tile, letter: letter * len(tile.xyz), jobs, Progress(), "Reading")
        assert dict(found) == {(0, 0): "aa", (2, 0): "b"}


def test_work_on_several_tiles_reports_the_progress_of_the_whole():
    fractions = []
    progress = Progress(lambda fraction, _: fractions.append(fraction))

    def columns(tiles, progress, keys, more):
        return [key[0] + more for key, _ in tiles.tiles(keys, progress, "Reading")]

    with TileStore(4.0) as store:
        fill(store, 0, 1, 2)
        parts = [([(0, 0), (1, 0)], (10,)), ([(2, 0)], (20,))]
        assert list(store.on_parts(columns, parts, progress, "Reading")) == [[10, 11], [22]]
    assert fractions == [0.0, 0.25, 0.5]
