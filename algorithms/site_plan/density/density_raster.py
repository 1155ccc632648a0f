"""The density raster: what walls are extracted from, as a file or from a cloud."""

from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np
import rasterio
from affine import Affine
from rasterio.crs import CRS
from rasterio.enums import ColorInterp

from ...errors import CancelledError, InputError
from ...raster import write_raster
from ...reference_systems import position_warning, require_metres
from ..walls.height_gate import Heights
from .density_image import DensityImage
from .settings import SiteSettings

BANDS = ("density", "occupied height", "base", "top", "ground", "spread", "hanging height")
"""Descriptions of the bands of a density raster."""

COLOURS = (ColorInterp.red, ColorInterp.palette)

NO_CRS = "The raster has no coordinate reference system, so the results have none either."


@dataclass(frozen=True)
class DensityRaster:
    """The bands from which walls are extracted.

    Attributes
    ----------
    density : ndarray of float32, shape (rows, columns)
        Nan where there is none.
    heights : Heights or None
        None if only a density is known.
    transform : Affine
        From (column, row) to world coordinates; square pixels, north up.
    crs : CRS or None
    warnings : tuple of str
        What the user may not have meant.
    """

    density: np.ndarray
    heights: Optional[Heights]
    transform: Affine
    crs: Optional[CRS]
    warnings: tuple[str, ...] = ()

    @classmethod
    def of(cls, image: DensityImage) -> "DensityRaster":
        """Return the bands of a density image."""
        return cls(image.density, image.heights, image.transform, image.crs, image.warnings)


def write_density(path: Path, image: DensityImage) -> None:
    """Write a density image as GeoTIFF with the bands `BANDS`."""
    arrays = (image.density, image.occupied, image.base, image.top, image.ground, image.spread, image.hanging)
    write_raster(path, dict(zip(BANDS, arrays)), image.transform, image.crs)


def read_density(path: Path, settings: SiteSettings = SiteSettings()) -> DensityRaster:
    """Read a density raster; without all of `BANDS`, the first band is the density.

    Raises
    ------
    InputError
        If the file is not a raster, is too large, is rotated or has oblong pixels, is not in metres, or holds
        no density.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"INPUT {path}: there is no such file; check the path.")
    try:
        with rasterio.open(path) as raster:
            _check_size(path, raster, settings)
            bands = dict(zip(raster.descriptions, range(1, raster.count + 1)))
            _check_grid(path, raster, settings)
            _check_values(path, raster)
            complete = set(BANDS) <= set(bands)
            arrays = [_filled(raster, bands[name]) for name in BANDS] if complete else [_filled(raster, 1)]
            transform, crs = raster.transform, raster.crs
    except (InputError, CancelledError):
        raise
    # Damaged files raise errors of GDAL, of texts and of reference systems, which have no common base.
    except Exception as error:
        raise InputError(
            f"INPUT {path}: cannot be read as a raster; give the output of 'densityimage'."
        ) from error
    if any(np.isinf(values).any() for values in arrays):
        raise InputError(f"INPUT {path}: holds infinite values; give the output of 'densityimage'.")
    density, *rest = arrays
    if (density < 0).any():
        raise InputError(
            f"INPUT {path}: holds values below 0, which no density has; state which value stands for none, "
            "or give the output of 'densityimage'."
        )
    if not (density > 0).any():
        raise InputError(f"INPUT {path}: holds no density above 0; is it the right raster?")
    middle = np.array(transform * (density.shape[1] / 2, density.shape[0] / 2))
    warnings = position_warning(crs, middle, str(path)) if crs else (NO_CRS,)
    return DensityRaster(density, Heights(*rest) if rest else None, transform, crs, warnings)


def _check_size(path: Path, raster: rasterio.DatasetReader, settings: SiteSettings) -> None:
    """Refuse a raster before memory is claimed for it."""
    if raster.width * raster.height > settings.most_pixels:
        raise InputError(
            f"INPUT {path}: has {raster.width} x {raster.height} pixels, more than {settings.most_pixels:,}; "
            "cut it to the site, or make it with a larger PIXEL_SIZE."
        )


def _check_grid(path: Path, raster: rasterio.DatasetReader, settings: SiteSettings) -> None:
    t = raster.transform
    if t.is_identity:
        raise InputError(f"INPUT {path}: is not georeferenced; give the output of 'densityimage'.")
    if not np.isfinite(t).all() or t.b or t.d or t.a <= 0 or abs(t.a + t.e) > 1e-6 * t.a:
        raise InputError(f"INPUT {path}: pixels must be square and north up; resample it with the Warp tool.")
    if not settings.smallest_pixel_m <= t.a <= settings.largest_pixel_m:
        raise InputError(f"INPUT {path}: has pixels of {t.a:.3g} m; give the output of 'densityimage'.")
    if raster.crs:
        require_metres(raster.crs, str(path))


def _check_values(path: Path, raster: rasterio.DatasetReader) -> None:
    """Refuse pictures, whose first band is a colour, and complex numbers."""
    if raster.colorinterp[0] in COLOURS or np.dtype(raster.dtypes[0]).kind == "c":
        raise InputError(f"INPUT {path}: holds a picture, not densities; give the output of 'densityimage'.")


def _filled(raster: rasterio.DatasetReader, number: int) -> np.ndarray:
    """Return a band as float32, with its scale and offset applied; nan where there is no value."""
    values = raster.read(number, masked=True)
    scale, offset = raster.scales[number - 1], raster.offsets[number - 1]
    if (scale, offset) != (1, 0):
        values = values * scale + offset
    with np.errstate(over="ignore"):
        return values.astype(np.float32).filled(np.nan)
