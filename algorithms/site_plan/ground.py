"""The local ground: the surface that heights of walls are counted from."""

import numpy as np
from numba import njit
from scipy import ndimage

from ..clouds.tiles import LATTICE, Tile, to_lattice
from .grid import Grid

CELL = 0.5
"""Edge of a ground cell in metres: wider than most walls are thick, so that ground is seen beside them."""

LAYER = 0.1
"""Height of the layers that are searched for the lowest surface, in metres."""

SUPPORT = 0.01
"""Share of a cell's points that a surface must hold; single points below ground are reflections."""

STEEPEST = 0.7
"""Steepest ground (rise / run): what rises faster above its surroundings is not ground."""

PIT = 1.0
"""A cell this far (m) below nearly all its surroundings is no ground but a reflection."""


def lowest_surface(tile: Tile, ground: Grid, surface: np.ndarray) -> None:
    """Write the height of the lowest supported layer of each ground cell of a tile.

    Parameters
    ----------
    tile : Tile
        Points.
    ground : Grid
        Grid of `CELL`; rows of `surface` count from the bottom.
    surface : ndarray of float64, shape (height, width)
        Metres; changed in place.
    """
    x0, y0 = (tile.corner[i] - ground.corner[i] for i in (0, 1))
    cells = (tile.xyz[:, 1] + y0) // ground.step * ground.width + (tile.xyz[:, 0] + x0) // ground.step
    names, cell = np.unique(cells, return_inverse=True)
    z = tile.xyz[:, 2].astype(np.int64)
    surface.flat[names] = _lowest(cell.ravel(), z, len(names), to_lattice(LAYER), SUPPORT) * LATTICE


@njit(nogil=True, cache=True)
def _lowest(cell, z, cells, layer, support):
    """Mean height of the lowest layer that, with the next, holds its share of the cell's points."""
    low = z.min()
    layers = (z.max() - low) // layer + 2
    counts = np.zeros((cells, layers), np.int32)
    sums = np.zeros((cells, layers))
    for i in range(len(z)):
        level = (z[i] - low) // layer
        counts[cell[i], level] += 1
        sums[cell[i], level] += z[i]
    out = np.empty(cells)
    for c in range(cells):
        needed = max(2.0, support * counts[c].sum())
        level = 0
        while level < layers - 1 and counts[c, level] + counts[c, level + 1] < needed:
            level += 1
        if level == layers - 1:
            level = 0
        while counts[c, level] == 0:
            level += 1
        out[c] = sums[c, level] / counts[c, level]
    return out


def ground_surface(surface: np.ndarray) -> np.ndarray:
    """Return the ground under every cell.

    The lower envelope of the lowest surfaces by cones of slope `STEEPEST`: a wall's top, a table
    or a crown cannot lift the ground above what is seen beside it, and cells without points are
    filled from their surroundings.

    Parameters
    ----------
    surface : ndarray of float64, shape (rows, columns)
        Height of the lowest surface in metres; inf where there is no point.
    """
    seen = np.isfinite(surface)
    filled = np.where(seen, surface, np.nanmax(surface[seen]))
    usual = ndimage.percentile_filter(filled, 25, size=7, mode="nearest")
    heights = np.where(seen & (surface > usual - PIT), surface, np.inf)
    _envelope(heights, STEEPEST * CELL)
    return heights


@njit(nogil=True, cache=True)
def _envelope(heights, rise):
    """Lower each cell to its neighbours' height plus `rise` per step; two sweeps, as a chamfer distance."""
    rows, columns = heights.shape
    diagonal = rise * np.sqrt(2.0)
    for sweep in range(2):
        back = sweep == 1
        for r in range(rows):
            row = rows - 1 - r if back else r
            behind = row + 1 if back else row - 1
            for c in range(columns):
                column = columns - 1 - c if back else c
                before = column + 1 if back else column - 1
                value = heights[row, column]
                if 0 <= before < columns:
                    value = min(value, heights[row, before] + rise)
                if 0 <= behind < rows:
                    value = min(value, heights[behind, column] + rise)
                    if column > 0:
                        value = min(value, heights[behind, column - 1] + diagonal)
                    if column < columns - 1:
                        value = min(value, heights[behind, column + 1] + diagonal)
                heights[row, column] = value


def at_pixels(heights: np.ndarray, ground: Grid, grid: Grid) -> np.ndarray:
    """Interpolate the ground to the pixel centres of `grid`, bilinearly; rows count from the bottom."""
    rows = _positions(ground.row, ground.step, grid.row, grid.height, grid.step)
    columns = _positions(ground.column, ground.step, grid.column, grid.width, grid.step)
    where = np.meshgrid(rows, columns, indexing="ij")
    return ndimage.map_coordinates(heights, where, np.float32, order=1, mode="nearest")


def _positions(first: int, step: int, start: int, count: int, pixel: int) -> np.ndarray:
    centres = (np.arange(count) + 0.5 + start) * pixel
    return centres / step - first - 0.5
