"""The accumulators of the bands of a density image, filled tile by tile."""

from copy import copy

import numpy as np

from ...clouds.tiles.lattice import LATTICE
from ...clouds.tiles.tiles import Tile
from ...kernels import kernel
from .grid import Grid
from .settings import DensitySettings
from .spread import count_in_parts

ALL_BINS = 64
"""Number of bins that a word notes: up to 6.7 m above the local ground, for the ceiling."""


class Bands:
    """Accumulators of the bands; rows count from the bottom."""

    def __init__(self, grid: Grid, ground: np.ndarray, settings: DensitySettings) -> None:
        self.grid, self.settings = grid, settings
        self.ground = ground
        self.density = np.zeros(grid.shape)
        self.bits = np.zeros(grid.shape, np.uint64)
        parts = settings.spread.parts
        self.parts = np.zeros((grid.height * parts, grid.width * parts), np.uint8)
        self.base = np.full(grid.shape, np.inf, np.float32)
        self.top = np.full(grid.shape, -np.inf, np.float32)

    def part(self, grid: Grid) -> "Bands":
        """Return the bands of some of the pixels."""
        if grid == self.grid:
            return self
        part = copy(self)
        part.grid, part.ground = grid, self.ground[self.grid.slices(grid)]
        for name, finer in self._arrays():
            whole = getattr(self, name)
            setattr(part, name, np.ascontiguousarray(whole[self.grid.slices(grid, finer)]))
        return part

    def paste(self, part: "Bands") -> None:
        """Take over the bands of some of the pixels; the ground remains."""
        for name, finer in self._arrays():
            getattr(self, name)[self.grid.slices(part.grid, finer)] = getattr(part, name)

    def _arrays(self) -> tuple[tuple[str, int], ...]:
        """Return the names of what is filled, with the rows and columns of a pixel."""
        parts = self.settings.spread.parts
        return ("density", 1), ("bits", 1), ("parts", parts), ("base", 1), ("top", 1)

    def spread(self, tile: Tile, kept: np.ndarray, neighbourhood: int) -> None:
        """Spread the kept points of a tile; the sum of their weights depends on the order of the tiles."""
        x0, y0 = (tile.corner[i] - self.grid.corner[i] for i in (0, 1))
        chosen = tile.xyz[kept]
        _spread(self.density, chosen, x0, y0, self.grid.step, neighbourhood)
        window, step = self.settings.window, self.grid.step
        limits = window.lowest_m, window.highest_m, self.settings.spread.parts
        count_in_parts(self.parts, self.ground, chosen, x0, y0, step, LATTICE, *limits)

    def stack(self, tile: Tile) -> None:
        """Note the heights of all points of a tile, in any order; at once for tiles that share no pixel."""
        x0, y0 = (tile.corner[i] - self.grid.corner[i] for i in (0, 1))
        window, step = self.settings.window, self.grid.step
        heights = (self.ground, self.bits, self.base, self.top)
        _stack(*heights, tile.xyz, x0, y0, step, LATTICE, window.lowest_m, ALL_BINS, window.bin_m)


@kernel
def _spread(density: np.ndarray, xyz: np.ndarray, x0: int, y0: int, step: int, neighbourhood: int) -> None:
    """Add each point with weights inverse to the distances from the pixel centres, of sum 1."""
    width = 2 * neighbourhood + 1
    weights = np.empty((width, width))
    for i in range(len(xyz)):
        column, row = int((xyz[i, 0] + x0) / step), int((xyz[i, 1] + y0) / step)
        # Of integers, so that it does not depend on where the grid begins.
        x = (xyz[i, 0] + x0 - column * step) / step - 0.5
        y = (xyz[i, 1] + y0 - row * step) / step - 0.5
        if x == 0.0 and y == 0.0:
            density[row, column] += 1.0
            continue
        for r in range(width):
            for c in range(width):
                weights[r, c] = 1.0 / np.hypot(x - (c - neighbourhood), y - (r - neighbourhood))
        weights /= weights.sum()
        for r in range(width):
            for c in range(width):
                density[row + r - neighbourhood, column + c - neighbourhood] += weights[r, c]


@kernel
def _stack(
    ground: np.ndarray,
    bits: np.ndarray,
    base: np.ndarray,
    top: np.ndarray,
    xyz: np.ndarray,
    x0: int,
    y0: int,
    step: int,
    lattice: float,
    low: float,
    bins: int,
    bin_height: float,
) -> None:
    """Note the bin above ground of each point, and the lowest and the highest point of a pixel."""
    for i in range(len(xyz)):
        # Exact: integers up to 2^53 are floats, and a quotient below a whole number is not rounded up to it.
        column, row = int((xyz[i, 0] + x0) / step), int((xyz[i, 1] + y0) / step)
        z = xyz[i, 2] * lattice
        base[row, column] = min(base[row, column], z)
        top[row, column] = max(top[row, column], z)
        level = (z - ground[row, column] - low) / bin_height
        if 0 <= level < bins:
            bits[row, column] |= np.uint64(1) << np.uint64(level)


def occupied_bins(bits: np.ndarray, count: int) -> np.ndarray:
    """Count the lowest bins that hold a point, and the one or two empty ones between two that do.

    A distant wall is hit by scan lines farther apart than a bin is high.
    """
    one, two = np.uint64(1), np.uint64(2)
    bits = bits & np.uint64((1 << count) - 1)
    between = (bits << one) & (bits >> one)
    between |= ((bits << one) & (bits >> two)) | ((bits << two) & (bits >> one))
    return _count_bits(bits | between, count)


@kernel
def _count_bits(bits: np.ndarray, count: int) -> np.ndarray:
    """Count those of the lowest bits that are set."""
    counts = np.zeros(bits.shape, np.uint64)
    for row in range(bits.shape[0]):
        for column in range(bits.shape[1]):
            word = bits[row, column]
            for k in range(count):
                counts[row, column] += (word >> np.uint64(k)) & np.uint64(1)
    return counts
