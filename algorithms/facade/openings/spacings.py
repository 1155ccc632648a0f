"""How far apart the points of a wall are, which changes over a facade."""

import numpy as np
from scipy import ndimage

from .grid import Grid
from .settings import StateSettings


def local_spacings(cells: np.ndarray, grid: Grid, settings: StateSettings = StateSettings()) -> np.ndarray:
    """Return the spacing of the points of a wall around each pixel, shape (rows, columns) (m).

    Squares at the edge of an opening are partly filled, so only those count that are about as full as those
    beside them.

    Parameters
    ----------
    cells : ndarray of int64, shape (n,)
        The pixel of each point of the wall; -1 outside.
    grid : Grid
    settings : StateSettings
    """
    pixels = max(round(settings.square_m / grid.size), 1)
    rows, columns = np.divmod(cells[cells >= 0], grid.shape[1])
    shape = tuple(-(-length // pixels) for length in grid.shape)
    counts = np.zeros(shape)
    np.add.at(counts, (rows // pixels, columns // pixels), 1)
    if not counts.any():
        return np.full(grid.shape, grid.size)
    full = (counts > 0) & (counts >= settings.full * ndimage.maximum_filter(counts, 3, mode="constant"))
    nearest = ndimage.distance_transform_edt(~full, return_distances=False, return_indices=True)
    spacings = pixels * grid.size / np.sqrt(counts[tuple(nearest)])
    every = np.ix_(np.arange(grid.shape[0]) // pixels, np.arange(grid.shape[1]) // pixels)
    return np.asarray(spacings[every])


def closed_wall(wall: np.ndarray, spacings: np.ndarray, size: float) -> np.ndarray:
    """Return the pixels of a wall with the gaps between its points, where these are larger than pixels.

    Parameters
    ----------
    wall : ndarray of bool, shape (rows, columns)
    spacings : ndarray of float64, shape (rows, columns)
        Of the points around each pixel (m).
    size : float
        Side of a pixel (m).
    """
    reach = np.where(spacings > size, spacings / size, 0.0)
    if not wall.any() or not reach.any():
        return wall
    grown = ndimage.distance_transform_edt(~wall) <= reach
    if grown.all():
        # Without a background, there are no distances to it.
        return grown
    return wall | (ndimage.distance_transform_edt(np.pad(grown, 1, mode="edge"))[1:-1, 1:-1] > reach) & grown
