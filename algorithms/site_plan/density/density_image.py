"""The density image of a cloud, with the heights that separate walls from floors.

Mueller et al. 2012, section 2.1: the cloud is thinned to a minimum distance and each point spreads over the
pixels around it. The heights are read from all points on the way.
"""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Optional

import numpy as np
from affine import Affine
from rasterio.crs import CRS

from ...clouds.cloud import Cloud, names_of
from ...clouds.thinning.thinning import tile_edge
from ...clouds.tiles.lattice import LATTICE, to_lattice
from ...clouds.tiles.lattice_points import limits_of
from ...clouds.tiles.tile_store import sort_here, stray_warning
from ...clouds.tiles.tiles import SortedTiles, Sorter, Tile
from ...errors import InputError
from ...progress import Progress
from ..walls.height_gate import Heights
from .bands import Bands, occupied_bins
from .ceiling import hanging_height
from .grid import Grid, make_grid, site_tiles
from .ground import LowestSurface, at_pixels, ground_surface, lowest_cells
from .height_range import HeightRange, cut
from .settings import DensitySettings, GroundSettings, HeightWindowSettings
from .spread import spread_of
from .windows import filled_bands


@dataclass(frozen=True)
class DensityImage:
    """A density image; arrays of float32, shape (rows, columns), the top row first.

    Attributes
    ----------
    density : ndarray
        Points per pixel, spread by inverse distance; nan where no point contributes.
    occupied : ndarray
        Occupied height in metres: that of the bins in the window of heights that hold a point.
    base, top : ndarray
        Height of the lowest and the highest point in metres; nan where the pixel holds none.
    ground : ndarray
        Height of the local ground in metres, or of the cut above it.
    spread : ndarray
        Share of the pixel over which the points in the window are spread; nan where they are few.
    hanging : ndarray
        Height in metres that points fill right below a ceiling; nan without one.
    transform : Affine
        From (column, row) to world coordinates.
    crs : CRS or None
    points_in, points_kept : int
        Points before and after thinning.
    warnings : tuple of str
    window : HeightWindowSettings
        The heights above the ground in which walls were looked for.
    """

    density: np.ndarray
    occupied: np.ndarray
    base: np.ndarray
    top: np.ndarray
    ground: np.ndarray
    spread: np.ndarray
    hanging: np.ndarray
    transform: Affine
    crs: CRS
    points_in: int
    points_kept: int
    warnings: tuple[str, ...]
    window: HeightWindowSettings = field(default_factory=HeightWindowSettings)

    @property
    def heights(self) -> Heights:
        """The bands of heights."""
        return Heights(self.occupied, self.base, self.top, self.ground, self.spread, self.hanging)


def density_image(
    cloud: Cloud,
    spacing: float = 0.05,
    pixel_size: float = 0.10,
    neighbourhood: int = 1,
    progress: Progress = Progress(),
    heights: HeightRange = HeightRange(),
    settings: DensitySettings = DensitySettings(),
    sort: Sorter = sort_here,
) -> DensityImage:
    """Compute the density image of a cloud.

    Parameters
    ----------
    cloud : Cloud
        One site.
    spacing : float
        Minimum distance between the points that are counted, in metres.
    pixel_size : float
        Metres.
    neighbourhood : int
        A point spreads over (2 * neighbourhood + 1) squared pixels; 0 gives the plain histogram.
    progress : Progress
        Reports and cancels.
    heights : HeightRange
        Points outside are left out. The ground is looked for in what is left, unless it is the ground
        that the range is counted from; above that, the cut replaces it.
    settings : DensitySettings
    sort : Sorter
        Where the points are sorted and looked at.

    Raises
    ------
    InputError
        If no point is left, all points have the same position, most lie far from each other, or
        the raster would be too large.
    """
    chosen = cloud, spacing, pixel_size, neighbourhood, progress, heights, settings, sort
    with sort_and_image(*chosen) as (image, _points):
        return image


@dataclass(frozen=True)
class SortedPoints:
    """The points of a site by tile, for as long as `sort_and_image` is open.

    Attributes
    ----------
    store : SortedTiles
    keys : list of tuple of int
        The tiles of the site.
    grid : Grid
        The pixels of the density image.
    """

    store: SortedTiles
    keys: list[tuple[int, int]]
    grid: Grid


@contextmanager
def sort_and_image(
    cloud: Cloud,
    spacing: float = 0.05,
    pixel_size: float = 0.10,
    neighbourhood: int = 1,
    progress: Progress = Progress(),
    heights: HeightRange = HeightRange(),
    settings: DensitySettings = DensitySettings(),
    sort: Sorter = sort_here,
) -> Iterator[tuple[DensityImage, SortedPoints]]:
    """Compute the density image as `density_image` does, and keep the sorted points for a further pass.

    Yields
    ------
    image : DensityImage
    points : SortedPoints
    """
    with sort(cloud, tile_edge(spacing), False, progress.part(0.0, 0.45)) as store:
        keys, stray = site_tiles(store, settings.site)
        if stray > store.point_count / 2:
            raise InputError(
                f"{names_of(cloud.sources)}: {stray} of {store.point_count} points lie far from each "
                "other; check that the coordinates are metres, or remove what is not the site."
            )
        if heights.is_limited and not heights.above_ground:
            keys = cut(store, keys, heights, cloud, progress.part(0.45, 0.5))
        low, high, surface = _survey(store, keys, to_lattice(pixel_size), settings, progress.part(0.5, 0.6))
        if (low == high).all():
            raise InputError(f"{names_of(cloud.sources)}: all points have the same position; is it a scan?")
        grid = make_grid(low[:2], high[:2], to_lattice(pixel_size), neighbourhood + 1, settings.site)
        is_cut = math.isfinite(heights.low) and not heights.above_ground
        ground = ground_surface(surface, is_cut, settings.ground)
        below = at_pixels(ground, surface.grid, grid)
        if heights.is_limited and heights.above_ground:
            keys = cut(store, keys, heights, cloud, progress.part(0.6, 0.65), grid, below)
            below += max(heights.low, 0.0)
        chosen = spacing, neighbourhood, settings, progress.part(0.65, 1.0)
        bands, kept = filled_bands(store, keys, grid, below, *chosen)
        warnings = (
            *cloud.warnings,
            *stray_warning(cloud, stray, store.point_count),
            *_doubts(high - low, spacing, pixel_size),
        )
        image = _image(bands, cloud.crs, store.point_count, kept, warnings)
        yield image, SortedPoints(store, keys, grid)


def _doubts(size: np.ndarray, spacing: float, pixel_size: float) -> Iterator[str]:
    """Yield what the user may not have meant."""
    if (size[:2] < to_lattice(1.0)).all():
        yield "The points lie within a metre; check that the coordinates are metres, not degrees."
    if spacing > pixel_size:
        yield f"SPACING {spacing:g} m is wider than PIXEL_SIZE {pixel_size:g} m, so walls have gaps."


def _survey(
    store: SortedTiles, keys: list[tuple[int, int]], pixel: int, settings: DensitySettings, progress: Progress
) -> tuple[np.ndarray, np.ndarray, LowestSurface]:
    """Return the smallest and largest x, y, z of the site, and its lowest surface.

    A site too large for pixels of `pixel` lattice steps is refused at once.
    """
    columns, rows = np.array(keys).T
    low = np.array([columns.min(), rows.min()]) * store.edge
    high = np.array([columns.max() + 1, rows.max() + 1]) * store.edge - 1
    make_grid(low, high, pixel, 0, settings.site)
    cells = make_grid(low, high, to_lattice(settings.ground.cell_m), 0, settings.site)
    surface = LowestSurface(cells)
    jobs = dict.fromkeys(sorted(keys), (settings.ground,))
    least, most = [], []
    for key, (lowest, highest, *found) in store.each(_seen, jobs, progress, "Finding the ground"):
        surface.put(key, *found)
        least.append(lowest)
        most.append(highest)
    return np.min(least, axis=0), np.max(most, axis=0), surface


def _seen(tile: Tile, settings: GroundSettings) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the smallest and largest x, y, z of a tile, and the cells of its lowest surface."""
    low, high = limits_of(tile.xyz)
    corner = np.array([*tile.corner, 0])
    return low + corner, high + corner, *lowest_cells(tile, settings)


def _image(
    bands: Bands, crs: Optional[CRS], points_in: int, kept: int, warnings: tuple[str, ...]
) -> DensityImage:
    window = bands.settings.window
    counts = occupied_bins(bands.bits, window.bins)

    def top_down(band: np.ndarray, valid: np.ndarray) -> np.ndarray:
        return np.where(valid, band, np.nan).astype(np.float32)[::-1]

    held = np.isfinite(bands.base)
    pixel_size = bands.grid.step * LATTICE
    heights = window.lowest_m, window.bin_m, pixel_size
    hanging = hanging_height(bands.bits, held, *heights, bands.settings.ceiling)
    return DensityImage(
        density=top_down(bands.density, bands.density > 0),
        occupied=top_down(counts * window.bin_m, bands.density > 0),
        base=top_down(bands.base, held),
        top=top_down(bands.top, held),
        ground=bands.ground[::-1].astype(np.float32),
        spread=spread_of(bands.parts, bands.settings.spread)[::-1],
        hanging=hanging[::-1],
        transform=bands.grid.transform,
        crs=crs,
        points_in=points_in,
        points_kept=kept,
        warnings=warnings,
        window=window,
    )
