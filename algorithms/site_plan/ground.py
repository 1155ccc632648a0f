"""The local ground: the surface that heights of walls are counted from."""

import numpy as np
from numba import njit
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..clouds.tiles import LATTICE, Tile, to_lattice
from .grid import Grid

CELL = 0.5
"""Edge of a ground cell in metres: wider than most walls are thick, so that ground is seen beside them."""

LAYER = 0.1
"""Height of the layers that are searched for the lowest surface, in metres."""

SUPPORT = 0.01
"""Share of a cell's points that a surface must hold; single points below ground are reflections."""

STEEPEST = 0.7
"""Steepest ground (rise / run) from cell to cell; a higher step parts two surfaces."""

PIT = 1.0
"""A cell this far (m) below nearly all its surroundings is no ground but a reflection."""

PATCH = 4
"""Ground is a surface that holds a square of this many cells: 2 m; wall tops, tables and cars do not."""


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
    side = tile.edge // ground.step
    column, row = ((tile.corner[i] - ground.corner[i]) // ground.step for i in (0, 1))
    lowest = _lowest(tile.xyz, ground.step, side, to_lattice(LAYER), SUPPORT) * LATTICE
    surface[row : row + side, column : column + side] = lowest


@njit(nogil=True, cache=True)
def _lowest(xyz, step, side, layer, support):
    """Mean height of the lowest layer that, with the next, holds its share of a cell's points."""
    low, high = xyz[:, 2].min(), xyz[:, 2].max()
    layers = np.int64(high - low) // layer + 2
    counts = np.zeros((side, side, layers), np.int32)
    sums = np.zeros((side, side, layers))
    for i in range(len(xyz)):
        column, row, level = xyz[i, 0] // step, xyz[i, 1] // step, np.int64(xyz[i, 2] - low) // layer
        counts[row, column, level] += 1
        sums[row, column, level] += xyz[i, 2]
    out = np.full((side, side), np.inf)
    for row in range(side):
        for column in range(side):
            cell = counts[row, column]
            total = cell.sum()
            if total == 0:
                continue
            needed = max(2.0, support * total)
            level = 0
            while level < layers - 1 and cell[level] + cell[level + 1] < needed:
                level += 1
            if level == layers - 1:
                level = 0
            while cell[level] == 0:
                level += 1
            out[row, column] = sums[row, column, level] / cell[level]
    return out


def ground_surface(surface: np.ndarray) -> np.ndarray:
    """Return the height of the ground under every cell.

    Cells whose lowest surfaces pass into one another are one surface, and it is ground if it is
    wide: terraces and storeys stay apart from each other, and the top of a wall or a table is
    never ground. Every other cell takes the height of the nearest ground, or its own if that is a little
    lower.

    Parameters
    ----------
    surface : ndarray of float64, shape (rows, columns)
        Height of the lowest surface in metres; inf where there is no point.
    """
    seen = np.isfinite(surface)
    filled = np.where(seen, surface, surface[seen].max())
    usual = ndimage.percentile_filter(filled, 25, size=7, mode="nearest")
    sound = seen & (surface > usual - PIT)
    ground = _wide_parts(_surfaces(np.where(sound, surface, np.inf)))
    if not ground.any():
        ground = sound
    nearest = ndimage.distance_transform_edt(~ground, return_distances=False, return_indices=True)
    heights = surface[tuple(nearest)]
    return np.where(sound, np.minimum(surface, heights), heights)


def _surfaces(surface: np.ndarray) -> np.ndarray:
    """Label the cells that pass into one another, from 1; cells without a height are 0."""
    number = np.arange(surface.size).reshape(surface.shape)
    first, second = [], []
    for one, other in (
        ((slice(None), slice(1, None)), (slice(None), slice(-1))),
        ((slice(1, None),), (slice(-1),)),
    ):
        with np.errstate(invalid="ignore"):
            linked = np.abs(surface[one] - surface[other]) <= STEEPEST * CELL
        first.append(number[one][linked])
        second.append(number[other][linked])
    first, second = np.concatenate(first), np.concatenate(second)
    links = coo_matrix((np.ones(len(first), bool), (first, second)), shape=(surface.size,) * 2)
    labels = connected_components(links, directed=False)[1].reshape(surface.shape) + 1
    return np.where(np.isfinite(surface), labels, 0)


def _wide_parts(labels: np.ndarray) -> np.ndarray:
    """Tell the cells of surfaces that hold a square of `PATCH` cells."""
    low = ndimage.minimum_filter(labels, PATCH, mode="constant", cval=0)
    high = ndimage.maximum_filter(labels, PATCH, mode="constant", cval=0)
    wide = np.unique(labels[(low == high) & (labels > 0)])
    return np.isin(labels, wide)


def at_pixels(heights: np.ndarray, ground: Grid, grid: Grid) -> np.ndarray:
    """Interpolate the ground to the pixel centres of `grid`, bilinearly; rows count from the bottom."""
    rows = _positions(ground.row, ground.step, grid.row, grid.height, grid.step)
    columns = _positions(ground.column, ground.step, grid.column, grid.width, grid.step)
    where = np.meshgrid(rows, columns, indexing="ij")
    return ndimage.map_coordinates(heights, where, np.float32, order=1, mode="nearest")


def _positions(first: int, step: int, start: int, count: int, pixel: int) -> np.ndarray:
    centres = (np.arange(count) + 0.5 + start) * pixel
    return centres / step - first - 0.5
