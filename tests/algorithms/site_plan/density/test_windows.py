"""Windows of a density image hold the same bytes as the whole does there."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.cluster.tasks import HeldTiles
from ichnograph.algorithms.clouds.tiles.tile_store import TileStore
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.site_plan.density.grid import Grid, make_grid
from ichnograph.algorithms.site_plan.density.settings import DensitySettings
from ichnograph.algorithms.site_plan.density.windows import filled_bands, windows


class Blocks(TileStore):
    """Tiles that are worked on by blocks, of which each sees no more than it asked for."""

    block_side = 2

    def on_parts(self, work, parts, progress, message):
        for keys, arguments in parts:
            held = HeldTiles({key: self.tile(key) for key in keys})
            yield work(held, Progress(), keys, *arguments)


def bands_of(kind, points, step, neighbourhood):
    with kind(4.0) as store:
        store.add(points, np.array([412_300.0, 5_812_700.0, 0.0]))
        keys = list(store.counts())
        low, high = np.min(keys, axis=0) * store.edge, (np.max(keys, axis=0) + 1) * store.edge
        grid = make_grid(low, high, step, neighbourhood + 1)
        ground = np.random.default_rng(1).uniform(-0.2, 0.2, grid.shape).astype(np.float32)
        return filled_bands(store, keys, grid, ground, 0.3, neighbourhood, DensitySettings(), Progress())


@settings(max_examples=15, deadline=None)
@given(
    seed=st.integers(0, 1000),
    step=st.sampled_from([10_000, 7_000, 33_333, 500_000, 1_000_000]),
    neighbourhood=st.integers(0, 2),
    gap=st.floats(0, 40),
)
def test_an_image_in_windows_is_the_same_bytes_as_in_one(seed, step, neighbourhood, gap):
    points = np.random.default_rng(seed).uniform(-1, 1, (3000, 3)) * (14.0, 9.0, 3.0)
    points[points[:, 0] > 3, 0] += gap
    whole, kept = bands_of(TileStore, points, step, neighbourhood)
    parts, kept_in_parts = bands_of(Blocks, points, step, neighbourhood)
    assert kept_in_parts == kept
    for name in ("density", "bits", "parts", "base", "top", "ground"):
        assert getattr(parts, name).tobytes() == getattr(whole, name).tobytes(), name


@pytest.mark.parametrize("step", [10_000, 33_333, 1_500_000])
def test_every_pixel_that_points_reach_is_in_one_window(step):
    keys = [(0, 0), (1, 0), (2, 0), (9, 7)]
    grid = make_grid(np.array([0, 0]), np.array([4_000_000, 3_200_000]), step, 2)
    seen = np.zeros(grid.shape, int)
    for window, near in windows(grid, keys, 400_000, 2, 1):
        assert near
        seen[grid.slices(window)] += 1
    assert seen.max() == 1
    for key in keys:
        reached = grid.part([k * 400_000 - step for k in key], [(k + 1) * 400_000 + step - 1 for k in key])
        assert seen[grid.slices(reached)].all()


def test_a_grid_that_is_not_divided_is_one_window():
    grid = Grid(0, 0, 50, 50, 10_000)
    assert list(windows(grid, [(0, 0)], 400_000, None, 1)) == [(grid, [(0, 0)])]
