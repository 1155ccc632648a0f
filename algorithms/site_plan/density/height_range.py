"""The heights between which a site is looked at: a storey, or a slice."""

import math
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...clouds.cloud import Cloud, names_of
from ...clouds.tiles.lattice import LATTICE
from ...clouds.tiles.tiles import SortedTiles, Tile
from ...errors import InputError
from ...progress import Progress
from .grid import Grid


@dataclass(frozen=True)
class HeightRange:
    """Points below `low`, or not below `high`, are left out.

    Attributes
    ----------
    low, high : float
        Metres; infinite where there is no limit.
    above_ground : bool
        Whether they are counted from the local ground, not from the coordinates' zero.

    Raises
    ------
    InputError
        If `low` is not below `high`.
    """

    low: float = -math.inf
    high: float = math.inf
    above_ground: bool = False

    def __post_init__(self) -> None:
        if not self.low < self.high:
            raise InputError(f"ZMIN {self.low:g} m is not below ZMAX {self.high:g} m; correct one of them.")

    @property
    def is_limited(self) -> bool:
        """Whether any point may be left out."""
        return math.isfinite(self.low) or math.isfinite(self.high)


def cut(
    store: SortedTiles,
    keys: list[tuple[int, int]],
    heights: HeightRange,
    cloud: Cloud,
    progress: Progress,
    grid: Optional[Grid] = None,
    ground: Optional[np.ndarray] = None,
) -> list[tuple[int, int]]:
    """Leave out the points of a site that lie outside a range of heights.

    Parameters
    ----------
    store : SortedTiles
        All points.
    keys : list of tuple of int
        The tiles of the site.
    heights : HeightRange
        The range.
    cloud : Cloud
        Where the points come from, for messages.
    progress : Progress
        Reports and cancels.
    grid : Grid, optional
        Pixels of `ground`.
    ground : ndarray of float, shape (rows, columns), optional
        Height of the local ground in metres, if heights are counted from it; rows count from the
        bottom.

    Returns
    -------
    list of tuple of int
        The tiles that still hold points.

    Raises
    ------
    InputError
        If no point is left.
    """
    jobs: dict[tuple[int, int], tuple[object, ...]] = dict.fromkeys(sorted(keys), (heights,))
    if ground is not None and grid is not None:
        for key in jobs:
            part = grid.around(key, store.edge)
            jobs[key] = heights, part, ground[grid.slices(part)]
    left, reach = [], []
    for key, (count, *limits) in store.keep_where(_within, jobs, progress, "Cutting by height"):
        reach += limits
        if count:
            left.append(key)
    if not left:
        above = "" if ground is None else " above the ground"
        raise InputError(
            f"{names_of(cloud.sources)}: no point lies from ZMIN {heights.low:g} to ZMAX {heights.high:g} m"
            f"{above}; the heights reach from {min(reach):.2f} to {max(reach):.2f} m{above}."
        )
    return sorted(left)


def _within(
    tile: Tile, heights: HeightRange, grid: Optional[Grid] = None, ground: Optional[np.ndarray] = None
) -> tuple[np.ndarray, tuple[int, float, float]]:
    """Return the rows within the range, how many they are, and the lowest and highest of all points."""
    z = tile.xyz[:, 2] * LATTICE
    if ground is not None and grid is not None:
        z = z - ground[_pixels(tile, grid)]
    rows = np.flatnonzero((z >= heights.low) & (z < heights.high))
    return rows, (len(rows), z.min(), z.max())


def _pixels(tile: Tile, grid: Grid) -> tuple[np.ndarray, np.ndarray]:
    """Return the row and the column of each point, rows counted from the bottom."""
    xy = tile.xyz[:, :2].astype(np.int64) + tile.corner
    column, row = ((xy - grid.corner[:2]) // grid.step).T
    return row, column
