"""The ground is wide and smooth, and follows slopes, terraces and storeys."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.tiles.tiles import Tile
from ichnograph.algorithms.site_plan.density.grid import Grid
from ichnograph.algorithms.site_plan.density.ground import LowestSurface, ground_surface, lowest_cells
from ichnograph.algorithms.site_plan.density.settings import GroundSettings


def ground_under(heights, clear=None):
    """Return the ground under the lowest surfaces of cells."""
    surface = LowestSurface(Grid(0, 0, *heights.shape[::-1], step=50_000))
    surface.height = heights
    surface.clear = np.ones(heights.shape, bool) if clear is None else clear
    return ground_surface(surface)


def level(height=0.0, size=40):
    return np.full((size, size), height)


def test_the_ground_of_a_slope_is_the_slope():
    slope = 0.1 * np.arange(40.0) * np.ones((40, 1))
    np.testing.assert_allclose(ground_under(slope), slope)


def test_cells_that_do_not_divide_a_tile_are_refused():
    tile = Tile((0, 0), np.zeros((1, 3), np.int32), np.zeros(1, np.int64), 400_000)
    with pytest.raises(ValueError, match="cell_m"):
        lowest_cells(tile, GroundSettings(cell_m=0.35))


def test_a_terrace_keeps_its_own_height_up_to_the_edge():
    terraces = level()
    terraces[:, 20:] = 3.0
    np.testing.assert_array_equal(ground_under(terraces), terraces)


@pytest.mark.parametrize(("rows", "columns"), [(1, 30), (3, 30), (3, 3)])
def test_the_top_of_a_wall_or_a_table_is_no_ground(rows, columns):
    surface = level()
    surface[10 : 10 + rows, 5 : 5 + columns] = 0.8
    np.testing.assert_array_equal(ground_under(surface), level())


def test_the_underside_of_a_crown_is_no_ground():
    surface = level()
    surface[10:26, 10:26] = np.random.default_rng(0).uniform(2.0, 2.6, (16, 16))
    np.testing.assert_array_equal(ground_under(surface), level())


def test_a_crown_cut_level_is_no_ground_as_it_is_not_clear_above():
    surface, clear = level(), np.ones((40, 40), bool)
    surface[10:26, 10:26] = 2.2
    clear[10:26, 10:26] = False
    np.testing.assert_array_equal(ground_under(surface, clear), level())


def test_cells_without_points_take_the_nearest_ground():
    surface = level(71.3)
    surface[15:25, :] = np.nan
    np.testing.assert_array_equal(ground_under(surface), level(71.3))


def test_reflections_below_the_floor_are_no_ground():
    surface = level()
    surface[10:12, 10:12] = -2.5
    np.testing.assert_array_equal(ground_under(surface), level())


def test_a_site_narrower_than_any_square_has_a_ground_too():
    np.testing.assert_array_equal(ground_under(level(5.0, size=3)), level(5.0, size=3))
