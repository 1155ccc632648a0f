"""Density rasters with walls that are known."""

import numpy as np
from affine import Affine
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.walls.height_gate import Heights

GRID = Affine(0.1, 0, 1000.0, 0, -0.1, 2000.0)


def wall_tower_and_beam():
    """Return a floor with a straight wall, a round tower and a beam as dense, and the pixels of each."""
    density = np.random.default_rng(0).normal(3.0, 0.3, (200, 300))
    occupied = np.zeros(density.shape)
    top = np.full(density.shape, 70.0)
    y, x = np.mgrid[:200, :300]
    wall = (np.abs(y - 30) < 2) & (x > 20) & (x < 280)
    tower = np.abs(np.hypot(x - 150, y - 120) - 40) < 3
    beam = (np.abs(y - 60) < 2) & (x > 20) & (x < 280)
    density[wall | tower | beam] = 60.0
    occupied[wall | tower] = 1.5
    top[wall], top[tower], top[beam] = 72.5, 71.9, 74.0
    ground = np.full(density.shape, 70.0)
    return DensityRaster(density, sheets(occupied, top, ground), GRID, None), wall, tower, beam


def sheets(occupied, top, ground):
    """Return the heights of walls without foliage or ceilings."""
    spread, hanging = np.zeros(ground.shape), np.full(ground.shape, np.nan)
    return Heights(occupied, ground.copy(), top, ground, spread, hanging)


def field(width, building):
    """Return a flat field of pixels with a building of `building` pixels square, or none, and its walls."""
    density = np.random.default_rng(0).normal(3.0, 0.3, (width, width))
    ground = np.zeros(density.shape)
    occupied, top = ground.copy(), ground.copy()
    wall = np.zeros(density.shape, bool)
    wall[100 : 100 + building, 100 : 100 + building] = True
    wall[101 : 99 + building, 101 : 99 + building] = False
    density[wall], occupied[wall], top[wall] = 60.0, 2.0, 2.5
    return DensityRaster(density, sheets(occupied, top, ground), GRID, None), wall
