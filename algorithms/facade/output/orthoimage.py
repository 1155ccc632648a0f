"""The orthoimage of a facade: its colours, projected at right angles onto its plane."""

import math
from pathlib import Path

import numpy as np
from affine import Affine
from rasterio.features import rasterize
from scipy.ndimage import distance_transform_edt

from ...errors import InputError
from ...raster import write_raster
from ..elevation import Elevation, Points
from .elevation_layers import ELEVATION_CRS, frame_values
from .settings import OrthoimageSettings

STEPS = (1.0, 2.0, 5.0, 10.0)
"""Pixel sizes are these times a power of ten."""


def automatic_pixel_size(spacing: float) -> float:
    """Return 1, 2 or 5 times a power of ten that is not less than the spacing of the points (m)."""
    power = 10.0 ** math.floor(math.log10(spacing))
    return next(step * power for step in STEPS if step * power >= spacing * (1 - 1e-9))


def write_orthoimage(
    path: Path,
    points: Points,
    elevation: Elevation,
    pixel_size: float,
    fill: bool,
    settings: OrthoimageSettings = OrthoimageSettings(),
) -> None:
    """Write red, green, blue and alpha; without colour the intensity in grey, and alpha.

    Parameters
    ----------
    path : Path
    points : Points
    elevation : Elevation
        Its rows are shown.
    pixel_size : float
        In metres.
    fill : bool
        Whether pixels of the wall without points take the colour of the nearest.
    settings : OrthoimageSettings

    Raises
    ------
    InputError
        If the image would have too many pixels, or the file cannot be written.
    """
    rows = elevation.rows
    uvw = elevation.frame.local(points.xyz[rows], points.origin)
    names: tuple[str, ...] = ("red", "green", "blue")
    if points.rgb is not None:
        values = points.rgb[rows]
    else:
        values, names = _grey(points, rows, settings)[:, None], ("intensity",)
    left, bottom, right, top = elevation.wall.bounds
    corner = math.floor(left / pixel_size) * pixel_size, math.ceil(top / pixel_size) * pixel_size
    shape = math.ceil((corner[1] - bottom) / pixel_size), math.ceil((right - corner[0]) / pixel_size)
    if shape[0] * shape[1] > settings.most_pixels:
        raise InputError(
            f"The orthoimage would have {shape[1]} x {shape[0]} pixels, more than {settings.most_pixels:,}; "
            "raise PIXEL_SIZE, or cut the cloud to the facade."
        )
    transform = Affine(pixel_size, 0, corner[0], 0, -pixel_size, corner[1])
    image, filled = paint(uvw, values, corner, shape, pixel_size, settings.layer_m)
    if fill:
        wall = rasterize([elevation.wall.convex_hull], shape, transform=transform).astype(bool)
        image, filled = _fill(image, filled, wall)
    bands = {name: image[..., band] for band, name in enumerate(names)}
    bands["alpha"] = np.where(filled, 255, 0).astype(np.uint8)
    write_raster(path, bands, transform, ELEVATION_CRS, tags=frame_values(elevation.frame))


def paint(
    uvw: np.ndarray,
    values: np.ndarray,
    corner: tuple[float, float],
    shape: tuple[int, int],
    size: float,
    layer: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean values of the foremost points of each pixel, and which pixels have points.

    Parameters
    ----------
    uvw : ndarray of float64, shape (n, 3)
    values : ndarray of float32, shape (n, bands)
        0..255.
    corner : tuple of float
        u and v of the upper left corner.
    shape : tuple of int
        Rows and columns.
    size : float
        Of a pixel (m).
    layer : float
        Points further behind the foremost are hidden (m).

    Returns
    -------
    image : ndarray of uint8, shape (rows, columns, bands)
    filled : ndarray of bool, shape (rows, columns)
    """
    columns = np.floor((uvw[:, 0] - corner[0]) / size).astype(np.int64)
    rows = np.floor((corner[1] - uvw[:, 1]) / size).astype(np.int64)
    inside = (rows >= 0) & (rows < shape[0]) & (columns >= 0) & (columns < shape[1])
    cells, w = (rows * shape[1] + columns)[inside], uvw[inside, 2]
    order = np.lexsort((-w, cells))
    starts = np.flatnonzero(np.diff(cells[order], prepend=-1))
    foremost = np.full(shape[0] * shape[1], -np.inf)
    foremost[cells[order][starts]] = w[order][starts]
    seen = w >= foremost[cells] - layer
    counts = np.bincount(cells[seen], minlength=len(foremost))
    image = np.zeros((len(foremost), values.shape[1]), np.uint8)
    for band in range(values.shape[1]):
        sums = np.bincount(cells[seen], values[inside][seen, band], len(foremost))
        image[:, band] = np.rint(sums / np.maximum(counts, 1))
    return image.reshape(*shape, -1), counts.reshape(shape) > 0


def _grey(points: Points, rows: np.ndarray, settings: OrthoimageSettings) -> np.ndarray:
    """Return the intensity as 0..255; mid-grey without intensity."""
    if points.intensity is None:
        return np.full(len(rows), 128, np.float32)
    values = points.intensity[rows]
    low, high = np.percentile(values, (settings.darkest_percent, settings.brightest_percent))
    return np.clip((values - low) / max(high - low, 1.0) * 255, 0, 255).astype(np.float32)


def _fill(image: np.ndarray, filled: np.ndarray, wanted: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    nearest = distance_transform_edt(~filled, return_distances=False, return_indices=True)
    empty = wanted & ~filled
    image = image.copy()
    image[empty] = image[tuple(nearest)][empty]
    return image, filled | wanted
