"""A plan that shows every fate a pixel can have."""

import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.site_plan.density.density_image import DensityImage
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.results import SitePlan
from ichnograph.algorithms.site_plan.rooms.rooms import find_rooms
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import extract_walls
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from rasterio.crs import CRS

GRID = Affine(0.1, 0, 412_300.0, 0, -0.1, 5_812_700.0)


def site():
    """Return a floor with a house and a cupboard, a scrap, a block, a faint wall, a low one, and a bush."""
    shape = (150, 200)
    density = np.full(shape, 3.0)
    occupied, top = np.zeros(shape), np.full(shape, 70.0)
    spread, hanging = np.full(shape, 0.2), np.full(shape, np.nan)

    def build(rows, columns, dense, high):
        density[rows, columns], occupied[rows, columns], top[rows, columns] = dense, high, 70 + high

    for outer, size in ((20, 80), (24, 72)):
        inner = slice(outer + 1, outer + size - 1)
        build(slice(outer, outer + size), slice(outer, outer + size), 60.0, 2.0)
        build(inner, inner, 3.0 if outer == 24 else 0.0, 0.0)
    density[density == 0] = np.nan
    density[145:, :10] = np.nan
    build(slice(120, 122), slice(30, 33), 60.0, 2.0)
    build(slice(40, 52), slice(140, 152), 60.0, 2.0)
    build(slice(130, 132), slice(100, 160), 1.0, 2.0)
    build(slice(110, 112), slice(100, 160), 60.0, 0.3)
    build(slice(70, 84), slice(150, 164), 60.0, 2.0)
    spread[70:84, 150:164] = 0.9
    house = slice(24, 96)
    hanging[house, house] = np.where(occupied[house, house] > 1, 1.0, 0.0)
    build(slice(40, 46), slice(40, 50), 60.0, 2.0)
    ground = np.full(shape, 70.0)
    base = np.where(np.isnan(density), np.nan, ground)
    bands = (band.astype(np.float32) for band in (density, occupied, base, top, ground, spread, hanging))
    return DensityImage(*bands, GRID, CRS.from_epsg(25833), 1_000_000, 50_000, ("A warning of the cloud.",))


@pytest.fixture(scope="session")
def plan():
    image = site()
    settings = SitePlanSettings(with_rooms=True, wall_parameters=WallParameters(threshold_steps=5))
    found = extract_walls(DensityRaster.of(image), settings.wall_parameters)
    return SitePlan(
        **vars(found),
        settings=settings,
        density=image,
        pixel_walls=found.walls,
        foliage=0,
        storey=None,
        axes=None,
        rooms=find_rooms([wall.outline for wall in found.walls]),
    )
