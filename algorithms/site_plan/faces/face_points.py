"""The points of the walls' faces: those near the outlines of pixels, thinned to voxels.

A voxel counts once however many points it holds, so that a face counts by its area, not by how near the
scanner stood. Its position is the mean of its points, so that thinning costs no accuracy.
"""

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ...clouds.tiles.lattice import LATTICE, to_lattice
from ...clouds.tiles.tiles import Tile
from ...kernels import kernel
from ...progress import Progress
from ..density.density_image import DensityImage, SortedPoints
from ..density.grid import Grid
from .settings import FacePointSettings

SQUARE = 0.25
"""Edge of the squares of the index of voxels, metres."""

ROUNDING = 1e-3
"""Larger than the rounding of heights in a band of float32, metres."""


@dataclass(frozen=True)
class FacePoints:
    """Voxels near walls, sorted by squares of `SQUARE`.

    Attributes
    ----------
    xy : ndarray of float64, shape (n, 2)
        Mean of the voxel's points, metres, relative to the origin.
    level : ndarray of int64, shape (n,)
        Number of the voxel's level above the local ground.
    count : ndarray of int64, shape (n,)
        Number of its points.
    square : ndarray of int64, shape (n,)
        Square of the voxel, increasing; row * `columns` + column, both from 0 at the origin.
    columns : int
        Number of squares from west to east, with a free one at either side.
    levels : int
        Number of levels that hold a voxel.
    flat : bool
        Whether they are of a horizontal slice.
    """

    xy: np.ndarray
    level: np.ndarray
    count: np.ndarray
    square: np.ndarray
    columns: int
    levels: int
    flat: bool = False

    def near(self, xy: np.ndarray) -> np.ndarray:
        """Return the rows of the voxels in the squares of points (n, 2) and the squares around them."""
        column, row = np.floor(xy.T / SQUARE).astype(np.int64) + 1
        centres = np.unique(row * self.columns + column)
        around = np.arange(-1, 2)
        squares = np.unique(centres[:, None, None] + around[:, None] * self.columns + around)
        first = np.searchsorted(self.square, squares)
        length = np.searchsorted(self.square, squares, "right") - first
        starts = np.repeat(first - np.r_[0, np.cumsum(length)[:-1]], length)
        return starts + np.arange(length.sum())


def face_points(xy: np.ndarray, level: np.ndarray, count: np.ndarray, flat: bool = False) -> FacePoints:
    """Sort voxels; `xy` must not be negative."""
    column, row = np.floor(xy.T / SQUARE).astype(np.int64) + 1
    columns = int(column.max(initial=0)) + 2
    square = row * columns + column
    order = np.lexsort((xy[:, 1], xy[:, 0], level, square))
    return FacePoints(
        xy[order], level[order], count[order], square[order], columns, len(np.unique(level)), flat
    )


def gather_face_points(
    points: SortedPoints,
    image: DensityImage,
    walls: np.ndarray,
    progress: Progress = Progress(),
    settings: FacePointSettings = FacePointSettings(),
) -> FacePoints:
    """Gather the voxels near wall pixels, in one pass over the points; relative to the image's lower left.

    Parameters
    ----------
    points : SortedPoints
        Of the site.
    image : DensityImage
        Of the same points.
    walls : ndarray of bool, shape (rows, columns)
        Wall pixels, the top row first.
    progress : Progress
        Reports and cancels.
    settings : FacePointSettings
    """
    grid = points.grid
    reach = round(to_lattice(settings.reach_m) / grid.step) + 0.5
    near = (ndimage.distance_transform_edt(~walls) <= reach)[::-1]
    ground = image.ground[::-1]
    flat = bool(np.mean(image.occupied[walls] > 0) < settings.seen_share)
    low, high = _window(image, walls, flat, settings)
    window = low, high, (high - low) / settings.levels

    jobs = {}
    for key in sorted(points.keys):
        part = grid.around(key, points.store.edge)
        own = grid.slices(part)
        jobs[key] = part, near[own], ground[own], window, grid.corner, to_lattice(settings.voxel_m)
    gathered = dict(points.store.each(_gather, jobs, progress, "Gathering the points of the faces"))
    xy, level, count = (np.concatenate(parts) for parts in zip(*(gathered[key] for key in jobs)))
    return face_points(xy, level, count, flat)


def _gather(
    tile: Tile,
    grid: Grid,
    near: np.ndarray,
    ground: np.ndarray,
    window: tuple[float, float, float],
    origin: tuple[int, int],
    voxel: int,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the voxels of a tile near wall pixels; `near` and `ground` are those of the pixels `grid`."""
    x0, y0 = (tile.corner[i] - grid.corner[i] for i in (0, 1))
    level = _levels(near, ground, tile.xyz, x0, y0, grid.step, LATTICE, *window)
    return _voxels(tile, level, np.subtract(tile.corner, origin), voxel)


def _window(
    image: DensityImage, walls: np.ndarray, flat: bool, settings: FacePointSettings
) -> tuple[float, float]:
    """Return the lowest and the highest height above the ground at which faces are looked for, metres."""
    if not flat:
        return image.window.lowest_m, image.window.highest_m
    low, high = (band[walls] - image.ground[walls] for band in (image.base, image.top))
    # The bands are rounded to float32.
    return float(np.nanmin(low)) - ROUNDING, float(np.nanpercentile(high, settings.top_percentile)) + ROUNDING


@kernel
def _levels(
    near: np.ndarray,
    ground: np.ndarray,
    xyz: np.ndarray,
    x0: int,
    y0: int,
    step: int,
    lattice: float,
    low: float,
    high: float,
    level_height: float,
) -> np.ndarray:
    """Return the level of each point above the ground, -1 where it is not used."""
    level = np.full(len(xyz), -1, np.int64)
    for i in range(len(xyz)):
        column, row = (xyz[i, 0] + x0) // step, (xyz[i, 1] + y0) // step
        if near[row, column]:
            height = xyz[i, 2] * lattice - ground[row, column]
            if low <= height < high:
                level[i] = np.int64((height - low) / level_height)
    return level


def _voxels(
    tile: Tile, level: np.ndarray, offset: np.ndarray, edge: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return mean positions (m), levels and numbers of points of the voxels of a tile."""
    used = level >= 0
    xyz, level = tile.xyz[used].astype(np.int64), level[used]
    across = tile.edge // edge + 1
    key = (level * across + xyz[:, 1] // edge) * across + xyz[:, 0] // edge
    voxel, member, count = np.unique(key, return_inverse=True, return_counts=True)
    # Sums of integers do not depend on the order of the points.
    sums = [np.bincount(member, xyz[:, axis], len(voxel)) for axis in (0, 1)]
    xy = (np.column_stack(sums) / count[:, None] + offset) * LATTICE
    return xy, voxel // across**2, count
