"""The bands of a density image in windows, each from all the points that reach it.

A window takes the points of its pixels, and those around that spread into them, in the order in which the
whole would. So it holds the same numbers as the whole does there, and windows need not be added up.
"""

import math
from collections.abc import Iterator
from contextlib import nullcontext
from threading import Lock
from typing import Any, Optional

import numpy as np

from ...clouds.thinning.thinning import deciding, thin_tiles
from ...clouds.tiles.tiles import Key, SortedTiles, Tile, Tiles, by_block
from ...progress import Progress
from .bands import Bands
from .grid import Grid
from .settings import DensitySettings


def filled_bands(
    store: SortedTiles,
    keys: list[Key],
    grid: Grid,
    ground: np.ndarray,
    spacing: float,
    neighbourhood: int,
    settings: DensitySettings,
    progress: Progress,
) -> tuple[Bands, int]:
    """Return the bands of all pixels, and the number of points after thinning.

    Parameters
    ----------
    store : SortedTiles
    keys : list of tuple of int
        The tiles of the site.
    grid : Grid
        The pixels.
    ground : ndarray of float, shape (rows, columns)
        Height of the local ground in metres; rows count from the bottom.
    spacing : float
        Minimum distance between the points that are counted, in metres.
    neighbourhood : int
        Pixels around its own over which a point spreads.
    settings : DensitySettings
    progress : Progress
    """
    parts: list[tuple[list[Key], tuple[Any, ...]]] = []
    among = set(keys)
    for window, near in windows(grid, keys, store.edge, store.block_side, neighbourhood):
        around = _reached(grid, near, store.edge, neighbourhood)
        chosen = near, window, around, ground[grid.slices(around)], spacing, neighbourhood, settings
        parts.append((deciding(near, among), chosen))
    whole: Optional[Bands] = None
    kept: dict[Key, int] = {}
    for bands, counts in store.on_parts(_fill, parts, progress, "Thinning"):
        kept.update(counts)
        if bands.grid == grid:
            whole = bands
            continue
        whole = whole or Bands(grid, ground, settings)
        whole.paste(bands)
    return whole or Bands(grid, ground, settings), sum(kept.values())


def windows(
    grid: Grid, keys: list[Key], edge: int, side: Optional[int], neighbourhood: int
) -> Iterator[tuple[Grid, list[Key]]]:
    """Yield parts of a grid that do not overlap, with the tiles whose points reach them.

    Parameters
    ----------
    grid : Grid
    keys : list of tuple of int
        The tiles.
    edge : int
        Of a tile, lattice steps.
    side : int or None
        Tiles along a window; None for all in one.
    neighbourhood : int
        Pixels around its own over which a point spreads.
    """
    if side is None:
        yield grid, list(keys)
        return
    size, reach = side * edge, (neighbourhood + 1) * grid.step
    blocks = by_block(keys, side)
    blocks_away = math.ceil(reach / size)
    far = range(-blocks_away, blocks_away + 1)
    for column, row in sorted({(column + x, row + y) for column, row in blocks for x in far for y in far}):
        # A pixel belongs to the block that holds its lower left corner.
        low = [-(-number * size // grid.step) * grid.step for number in (column, row)]
        high = [-(-(number + 1) * size // grid.step) * grid.step - 1 for number in (column, row)]
        window = grid.part(low, high)
        near = [
            key
            for x in far
            for y in far
            for key in blocks.get((column + x, row + y), ())
            if all(low[i] - reach < (key[i] + 1) * edge and key[i] * edge <= high[i] + reach for i in (0, 1))
        ]
        if near and window.width and window.height:
            yield window, near


def _reached(grid: Grid, keys: list[Key], edge: int, neighbourhood: int) -> Grid:
    """Return the pixels over which points of tiles may spread."""
    margin = (neighbourhood + 1) * grid.step
    low, high = np.min(keys, axis=0) * edge - margin, (np.max(keys, axis=0) + 1) * edge + margin
    return grid.part([int(value) for value in low], [int(value) for value in high])


def _fill(
    tiles: Tiles,
    progress: Progress,
    keys: list[Key],
    near: list[Key],
    window: Grid,
    around: Grid,
    ground: np.ndarray,
    spacing: float,
    neighbourhood: int,
    settings: DensitySettings,
) -> tuple[Bands, dict[Key, int]]:
    """Thin the tiles `keys`; return the bands of a window, and what remains in each tile of `near`."""
    bands, reaching = Bands(around, ground, settings), set(near)
    # A pixel wider than a tile may lie in two that are taken at once.
    guard = Lock() if around.step > tiles.edge else nullcontext()

    def stack(tile: Tile) -> None:
        if tile.key in reaching:
            with guard:
                bands.stack(tile)

    kept = {}
    for tile, rows in thin_tiles(tiles, keys, spacing, progress, beside=stack):
        if tile.key in reaching:
            bands.spread(tile, rows, neighbourhood)
            kept[tile.key] = len(rows)
    return bands.part(around.overlap(window)), kept
