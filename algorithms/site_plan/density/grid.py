"""The pixels of a site: where they lie, and how far the site reaches."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from affine import Affine

from ...clouds.strays import stray_cells
from ...clouds.tiles.lattice import LATTICE
from ...clouds.tiles.tiles import Key, SortedTiles
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

    def part(self, low: Sequence[int], high: Sequence[int]) -> "Grid":
        """Return the pixels that lie between two corners x, y, in lattice steps, at least in part."""
        column, row = max(low[0] // self.step, self.column), max(low[1] // self.step, self.row)
        right = min(high[0] // self.step + 1, self.column + self.width)
        above = min(high[1] // self.step + 1, self.row + self.height)
        return Grid(column, row, max(right - column, 0), max(above - row, 0), self.step)

    def overlap(self, other: "Grid") -> "Grid":
        """Return the pixels that are those of another grid too, of the same pixels."""
        x, y = other.corner
        return self.part((x, y), (x + other.width * self.step - 1, y + other.height * self.step - 1))

    def around(self, tile: Key, edge: int) -> "Grid":
        """Return the pixels in which the points of a tile of `edge` lattice steps may lie."""
        low = tile[0] * edge, tile[1] * edge
        return self.part(low, (low[0] + edge - 1, low[1] + edge - 1))

    def slices(self, part: "Grid", finer: int = 1) -> tuple[slice, slice]:
        """Return the rows and columns of a part, where each pixel is cut into `finer` rows and columns."""
        row, column = (part.row - self.row) * finer, (part.column - self.column) * finer
        return slice(row, row + part.height * finer), slice(column, column + part.width * finer)

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
    store: SortedTiles, settings: SiteSettings = SiteSettings()
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
