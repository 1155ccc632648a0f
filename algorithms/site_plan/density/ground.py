"""The local ground: the surface that heights of walls are counted from."""

import numpy as np
from numba import njit
from scipy import ndimage

from ...clouds.thinning.tiles import LATTICE, Tile, to_lattice
from ...geometry.linked_parts import label_linked
from .grid import Grid

CELL = 0.5
"""Edge of a ground cell in metres: wider than most walls are thick, so that ground is seen beside them."""

LAYER = 0.1
"""Height of the layers that are searched for the lowest surface, in metres."""

SUPPORT = 0.01
"""Share of a cell's points that a surface must hold; single points below ground are reflections."""

ENOUGH = 5
"""Number of points that is support in any case; under a crown the ground is seen by a few."""

STEEPEST = 0.7
"""Steepest ground (rise / run) from cell to cell; a higher step parts two surfaces."""

CLEARANCE = 5
"""Number of layers above the lowest two that tell whether it is clear above."""

PIT = 1.0
"""A cell this far (m) below nearly all its surroundings is no ground but a reflection."""

PATCH = 4
"""Ground is a surface that holds a smooth square of this many cells, 2 m; a table does not."""

SMOOTH = 0.15
"""Largest change of the rise from cell to cell to cell on smooth ground, metres; crowns are rougher."""


ROOM, LEFT = 1.0, 0.05
"""A surface is a ceiling that more than this share of the cells lie farther below than this (m)."""


class LowestSurface:
    """The lowest supported layer of points in each ground cell.

    Attributes
    ----------
    grid : Grid
        Cells of `CELL`; rows of the arrays count from the bottom.
    height : ndarray of float64, shape (rows, columns)
        Metres; nan where there is no point.
    clear : ndarray of bool, shape (rows, columns)
        Whether there are fewer points right above the layer than in it, as above a ground.
    """

    def __init__(self, grid: Grid) -> None:
        self.grid = grid
        self.height = np.full(grid.shape, np.nan)
        self.clear = np.zeros(grid.shape, bool)

    def add(self, tile: Tile) -> None:
        """Fill in the cells of a tile."""
        side = tile.edge // self.grid.step
        column, row = ((tile.corner[i] - self.grid.corner[i]) // self.grid.step for i in (0, 1))
        place = slice(row, row + side), slice(column, column + side)
        counts, sums = _layers(tile.xyz, self.grid.step, side, to_lattice(LAYER))
        self.height[place], self.clear[place] = _lowest(counts, sums, SUPPORT, ENOUGH, CLEARANCE)
        self.height[place] *= LATTICE


@njit(nogil=True, cache=True)
def _layers(xyz, step, side, layer):
    """Count the points of each cell by layer, and sum their heights."""
    low, high = xyz[:, 2].min(), xyz[:, 2].max()
    layers = np.int64(high - low) // layer + 2
    counts = np.zeros((side, side, layers), np.int32)
    sums = np.zeros((side, side, layers))
    for i in range(len(xyz)):
        column, row, level = xyz[i, 0] // step, xyz[i, 1] // step, np.int64(xyz[i, 2] - low) // layer
        counts[row, column, level] += 1
        sums[row, column, level] += xyz[i, 2]
    return counts, sums


@njit(nogil=True, cache=True)
def _lowest(counts, sums, support, enough, clearance):
    """Return the mean height of the lowest layer that, with the next, has support, and if it is clear."""
    rows, columns, layers = counts.shape
    height = np.full((rows, columns), np.nan)
    clear = np.zeros((rows, columns), np.bool_)
    for row in range(rows):
        for column in range(columns):
            cell = counts[row, column]
            total = cell.sum()
            if total == 0:
                continue
            needed = min(max(2.0, support * total), enough)
            level = 0
            while level < layers - 1 and cell[level] + cell[level + 1] < needed:
                level += 1
            if level == layers - 1:
                level = 0
            while cell[level] == 0:
                level += 1
            height[row, column] = sums[row, column, level] / cell[level]
            above = cell[level + 2 : level + 2 + clearance].sum()
            clear[row, column] = above <= cell[level : level + 2].sum()
    return height, clear


def ground_surface(surface: LowestSurface, below: bool = False) -> np.ndarray:
    """Return the height of the ground under every cell; float64, shape (rows, columns), metres.

    Cells whose lowest surfaces pass into one another are one surface, and it is ground if it is
    somewhere wide, smooth and clear above: terraces and storeys stay apart from each other, and the
    top of a wall, a table or the underside of a crown is never ground. If there is none, the largest
    surface is ground. Every other cell takes the height of the nearest ground, or its own if that is
    a little lower.

    With `below`, the points below some height were left out, and the ground may be among them. What
    many cells lie far below is then a ceiling, and they, in which walls begin, show the ground.
    """
    seen = np.isfinite(surface.height)
    filled = np.where(seen, surface.height, surface.height[seen].max())
    usual = ndimage.percentile_filter(filled, 10, size=7, mode="nearest")
    sound = seen & (filled > usual - PIT)
    heights = np.where(sound, surface.height, np.nan)
    surfaces = surfaces_of(heights, STEEPEST * CELL)
    ground = wide_parts(surfaces, _is_smooth(heights) & surface.clear, PATCH)
    if not ground.any():
        ground = surfaces == np.bincount(surfaces[sound]).argmax()
    if below:
        deeper = sound & (heights < _beside(heights, ground) - ROOM)
        if np.count_nonzero(deeper) > LEFT * np.count_nonzero(sound):
            ground = deeper
    beside = _beside(heights, ground)
    return np.where(sound, np.fmin(heights, beside), beside)


def _beside(heights: np.ndarray, ground: np.ndarray) -> np.ndarray:
    """Return the height of the nearest ground."""
    nearest = ndimage.distance_transform_edt(~ground, return_distances=False, return_indices=True)
    return heights[tuple(nearest)]


def surfaces_of(surface: np.ndarray, step: float) -> np.ndarray:
    """Label the cells that pass into one another without a higher step; cells without a height are 0."""
    number = np.arange(surface.size).reshape(surface.shape)
    first, second = [], []
    for one, other in (
        ((slice(None), slice(1, None)), (slice(None), slice(-1))),
        ((slice(1, None),), (slice(-1),)),
    ):
        linked = np.abs(surface[one] - surface[other]) <= step
        first.append(number[one][linked])
        second.append(number[other][linked])
    labels = label_linked(np.concatenate(first), np.concatenate(second), surface.size) + 1
    return np.where(np.isfinite(surface), labels.reshape(surface.shape), 0)


def _is_smooth(surface: np.ndarray) -> np.ndarray:
    """Tell the cells at which the surface bends little; what is not known does not bend."""
    smooth = np.ones(surface.shape, bool)
    for axis in (0, 1):
        bend = np.diff(surface, 2, axis=axis)
        inner = (slice(1, -1), slice(None)) if axis == 0 else (slice(None), slice(1, -1))
        smooth[inner] &= ~(np.abs(bend) > SMOOTH)
    return smooth


def wide_parts(labels: np.ndarray, smooth: np.ndarray, patch: int) -> np.ndarray:
    """Tell the cells of surfaces that hold a smooth square of `patch` cells."""
    low = ndimage.minimum_filter(np.where(smooth, labels, 0), patch, mode="constant", cval=0)
    high = ndimage.maximum_filter(labels, patch, mode="constant", cval=0)
    wide = np.unique(labels[(low == high) & (low > 0)])
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
