"""The attributes of walls that are known as pixels."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters, extract_wall_pixels
from ichnograph.algorithms.site_plan.walls.wall import describe_walls
from ichnograph.tests.algorithms.site_plan.rasters import GRID, wall_tower_and_beam


def walls_of(raster):
    image = extract_wall_pixels(raster.density, raster.heights, raster.transform.a, WallParameters())
    return describe_walls(image, raster.heights, raster.transform)


def test_each_wall_has_its_attributes():
    raster, wall, tower, _beam = wall_tower_and_beam()
    straight, round_tower = walls_of(raster)
    assert (straight.kind, round_tower.kind) == ("straight", "curved")
    assert straight.length == pytest.approx(25.9, abs=0.2)
    assert straight.azimuth == pytest.approx(90.0, abs=0.1)
    assert round_tower.azimuth is None
    assert round_tower.length == pytest.approx(2 * np.pi * 4.0, rel=0.02)
    assert (straight.z_base, straight.z_top, straight.height) == pytest.approx((70.0, 72.5, 2.5))
    assert round_tower.z_top == pytest.approx(71.9)
    assert straight.density == pytest.approx(60.0)
    assert straight.outline.area == pytest.approx(0.01 * wall.sum(), rel=1e-6)
    assert round_tower.outline.area == pytest.approx(0.01 * tower.sum(), rel=0.02)


@pytest.mark.parametrize("angle", [0, 20, 45, 70, 90, 110, 135, 160])
def test_the_azimuth_turns_clockwise_from_north(angle):
    y, x = np.mgrid[:200, :200]
    east, north = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    along = (x - 100) * east - (y - 100) * north
    across = (x - 100) * north + (y - 100) * east
    density = np.where((np.abs(along) < 80) & (np.abs(across) < 2.2), 50.0, 2.0)
    (wall,) = walls_of(DensityRaster(density, None, GRID, None))
    assert wall.azimuth == pytest.approx(angle, abs=0.5)
    assert wall.length == pytest.approx(16.0, rel=0.02)
    assert (wall.z_base, wall.z_top, wall.height) == (None, None, None)
