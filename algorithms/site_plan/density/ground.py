"""The local ground: the surface that heights of walls are counted from."""

import numpy as np
from scipy import ndimage

from ...clouds.tiles.lattice import LATTICE, to_lattice
from ...clouds.tiles.tiles import Key, Tile
from ...geometry.linked_parts import label_linked
from ...kernels import kernel
from .grid import Grid
from .settings import GroundSettings


class LowestSurface:
    """The lowest supported layer of points in each ground cell.

    Attributes
    ----------
    grid : Grid
        The ground cells; rows of the arrays count from the bottom.
    height : ndarray of float64, shape (rows, columns)
        Metres; nan without points.
    clear : ndarray of bool, shape (rows, columns)
        Whether there are fewer points right above the layer than in it, as above a ground.
    """

    def __init__(self, grid: Grid) -> None:
        self.grid = grid
        self.height = np.full(grid.shape, np.nan)
        self.clear = np.zeros(grid.shape, bool)

    def put(self, key: Key, height: np.ndarray, clear: np.ndarray) -> None:
        """Fill in the cells of a tile, as `lowest_cells` returns them."""
        side = len(height)
        row, column = key[1] * side - self.grid.row, key[0] * side - self.grid.column
        cells = slice(row, row + side), slice(column, column + side)
        self.height[cells], self.clear[cells] = height, clear


def lowest_cells(tile: Tile, settings: GroundSettings) -> tuple[np.ndarray, np.ndarray]:
    """Return `height` and `clear` of the cells of a tile; see `LowestSurface`.

    Raises
    ------
    ValueError
        If a cell would reach into the next tile.
    """
    step = to_lattice(settings.cell_m)
    side, rest = divmod(tile.edge, step)
    if rest:
        raise ValueError(f"cell_m: cells of {settings.cell_m} m do not divide a tile into whole cells.")
    counts, sums = _layers(tile.xyz, step, side, to_lattice(settings.layer_m))
    support = settings.support_share, settings.support_points
    height, clear = _lowest(counts, sums, *support, settings.clearance_layers)
    return height * LATTICE, clear


@kernel
def _layers(xyz: np.ndarray, step: int, side: int, layer: int) -> tuple[np.ndarray, np.ndarray]:
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


@kernel
def _lowest(
    counts: np.ndarray, sums: np.ndarray, support: float, enough: int, clearance: int
) -> tuple[np.ndarray, np.ndarray]:
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


def ground_surface(
    surface: LowestSurface, below: bool = False, settings: GroundSettings = GroundSettings()
) -> np.ndarray:
    """Return the height of the ground under every cell; float64, shape (rows, columns), metres.

    Cells whose lowest surfaces pass into one another are one surface, and it is ground if it is
    somewhere wide, smooth and clear above: terraces and storeys are separated from each other, and the
    top of a wall, a table or the underside of a crown is never ground. Without such a surface, the
    largest one is ground. Every other cell takes the height of the nearest ground, or its own if that is
    a little lower.

    With `below`, the points below some height were left out, and the ground may be among them. A surface
    that many cells lie far below is then a ceiling. Walls begin in those cells, so they show the ground.
    """
    seen = np.isfinite(surface.height)
    filled = np.where(seen, surface.height, surface.height[seen].max())
    usual = ndimage.percentile_filter(
        filled, settings.usual_percentile, size=settings.usual_cells, mode="nearest"
    )
    sound = seen & (filled > usual - settings.pit_m)
    heights = np.where(sound, surface.height, np.nan)
    surfaces = surfaces_of(heights, settings.steepest * settings.cell_m)
    level = _is_smooth(heights, settings.smooth_m) & surface.clear
    ground = wide_parts(surfaces, level, settings.patch_cells)
    if not ground.any():
        ground = surfaces == np.bincount(surfaces[sound]).argmax()
    if below:
        deeper = sound & (heights < _beside(heights, ground) - settings.room_m)
        if np.count_nonzero(deeper) > settings.room_share * np.count_nonzero(sound):
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


def _is_smooth(surface: np.ndarray, bend_m: float) -> np.ndarray:
    """Return the cells at which the surface bends little; where it is unknown it counts as straight."""
    smooth = np.ones(surface.shape, bool)
    for axis in (0, 1):
        bend = np.diff(surface, 2, axis=axis)
        inner = (slice(1, -1), slice(None)) if axis == 0 else (slice(None), slice(1, -1))
        smooth[inner] &= ~(np.abs(bend) > bend_m)
    return smooth


def wide_parts(labels: np.ndarray, smooth: np.ndarray, patch: int) -> np.ndarray:
    """Return the cells of surfaces that hold a smooth square of `patch` cells."""
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
