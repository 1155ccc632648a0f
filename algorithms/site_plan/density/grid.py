"""The pixels of a site: where they lie, and how far the site reaches."""

from dataclasses import dataclass

import numpy as np
from affine import Affine

from ...clouds.strays import stray_cells
from ...clouds.tiles.lattice import LATTICE
from ...clouds.tiles.tile_store import TileStore
from ...errors import InputError
from .settings import SiteSettings


@dataclass(frozen=True)
class Grid:
    """Square pixels whose edges are multiples of the pixel size.

    Attributes
    ----------
    column, row : int
        Number of the leftmost column and the lowest row, counted from the coordinates' origin.
    width, height : int
        Pixels.
    step : int
        Pixel size in lattice steps.
    """

    column: int
    row: int
    width: int
    height: int
    step: int

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.height, self.width

    @property
    def corner(self) -> tuple[int, int]:
        """Lower left corner in lattice steps."""
        return self.column * self.step, self.row * self.step

    @property
    def transform(self) -> Affine:
        """Affine transform from (column, row from the top) to world coordinates."""
        # Division by the lattice's reciprocal is exact where a multiplication by 1e-5 is not.
        per_metre = round(1 / LATTICE)
        left = self.column * self.step / per_metre
        top = (self.row + self.height) * self.step / per_metre
        size = self.step / per_metre
        return Affine(size, 0.0, left, 0.0, -size, top)


def site_tiles(
    store: TileStore, settings: SiteSettings = SiteSettings()
) -> tuple[list[tuple[int, int]], int]:
    """Separate the tiles of the site from those that hold stray points far away; see `clouds.strays`.

    Returns
    -------
    keys : list of tuple of int
        Tiles of the site.
    stray : int
        Number of points left out.
    """
    # Which part is the first of the largest must not depend on the order of the points.
    counts = dict(sorted(store.counts().items()))
    keys, held = np.array(list(counts)), np.array(list(counts.values()))
    stray = stray_cells(keys, held, store.edge * LATTICE, settings.strays)
    return [tuple(key) for key in keys[~stray].tolist()], int(held[stray].sum()) + store.stray_count


def make_grid(
    low: np.ndarray, high: np.ndarray, step: int, margin: int, settings: SiteSettings = SiteSettings()
) -> Grid:
    """Return the grid that covers the points between two corners.

    Parameters
    ----------
    low, high : ndarray of int64, shape (2,)
        Smallest and largest x, y; lattice steps.
    step : int
        Pixel size; lattice steps.
    margin : int
        Pixels added on each side.
    settings : SiteSettings

    Raises
    ------
    InputError
        If the raster would hold more pixels than the settings allow.
    """
    column, row = (int(value) // step - margin for value in low)
    width = int(high[0]) // step + margin + 1 - column
    height = int(high[1]) // step + margin + 1 - row
    if width * height > settings.most_pixels:
        size, most = step * LATTICE, settings.most_pixels
        raise InputError(
            f"The raster would be {width} x {height} pixels ({width * size:.0f} x "
            f"{height * size:.0f} m at {size:g} m), more than {most:,}: raise PIXEL_SIZE, cut the "
            "cloud to the site, or check that its coordinates are metres."
        )
    return Grid(column, row, width, height, step)
