"""The pixels of a site, and the tiles that belong to it."""

from types import SimpleNamespace

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.site_plan.density.grid import Grid, make_grid, site_tiles
from ichnograph.algorithms.site_plan.density.settings import SiteSettings


def store(counts):
    """Return what `site_tiles` asks of a store of tiles of 10 m, in lattice steps of 10 micrometres."""
    return SimpleNamespace(counts=lambda: counts, edge=1_000_000, stray_count=0)


def test_edges_of_pixels_are_multiples_of_their_size():
    grid = make_grid(np.array([123_456, -5]), np.array([150_000, 20_000]), 10_000, 1)
    assert (grid.column, grid.row, grid.width, grid.height) == (11, -2, 6, 6)
    assert grid.corner == (110_000, -20_000)
    assert grid.shape == (6, 6)


def test_the_transform_begins_at_the_upper_left_corner():
    transform = Grid(11, -2, 6, 5, 10_000).transform
    assert transform * (0, 0) == pytest.approx((1.1, 0.3))
    assert transform * (6, 5) == pytest.approx((1.7, -0.2))


def test_a_raster_that_is_too_large_is_refused_with_its_size():
    with pytest.raises(InputError, match=r"10001 x 10001 pixels .*PIXEL_SIZE"):
        make_grid(np.zeros(2, int), np.full(2, 100_000_000), 10_000, 0)
    small = SiteSettings(most_pixels=3)
    with pytest.raises(InputError, match="more than 3"):
        make_grid(np.zeros(2, int), np.full(2, 10_000), 10_000, 0, small)


def test_tiles_of_few_points_far_away_are_left_out_and_counted():
    keys, stray = site_tiles(store({(0, 0): 100_000, (1, 0): 500, (50, 0): 50}))
    assert keys == [(0, 0), (1, 0)]
    assert stray == 50


def test_a_part_of_a_grid_holds_the_pixels_that_an_area_touches():
    grid = Grid(11, -2, 6, 5, 10_000)
    part = grid.part((125_000, -9_000), (139_999, 0))
    assert part == Grid(12, -1, 2, 2, 10_000)
    assert grid.part((0, 0), (10**6, 10**6)) == Grid(11, 0, 6, 3, 10_000)
    assert grid.overlap(Grid(15, 1, 9, 9, 10_000)) == Grid(15, 1, 2, 2, 10_000)
    assert grid.overlap(Grid(90, 90, 9, 9, 10_000)).shape == (0, 0)


def test_the_pixels_of_a_part_are_found_in_the_whole():
    grid = Grid(11, -2, 6, 5, 10_000)
    assert grid.slices(Grid(12, -1, 2, 3, 10_000)) == (slice(1, 4), slice(1, 3))
    assert grid.slices(Grid(12, -1, 2, 3, 10_000), finer=4) == (slice(4, 16), slice(4, 12))


def test_the_points_of_a_tile_lie_in_the_pixels_around_it():
    assert Grid(0, 0, 50, 50, 30_000).around((1, 0), 100_000) == Grid(3, 0, 4, 4, 30_000)
