"""Writing and reading georeferenced rasters."""

from pathlib import Path
from typing import Any, Optional

import numpy as np
import rasterio
from affine import Affine
from rasterio.crs import CRS
from rasterio.enums import ColorInterp
from rasterio.errors import RasterioError

from .errors import InputError
from .files import atomic_output

NODATA = -9999.0
"""Marks pixels without a value in float rasters."""

PICTURE = ("red", "green", "blue")
COLOURS = {name: ColorInterp[name] for name in (*PICTURE, "alpha")}
"""Bands that GDAL interprets as colours."""


def write_raster(
    path: Path,
    bands: dict[str, np.ndarray],
    transform: Affine,
    crs: Optional[CRS],
    nodata: Optional[float] = None,
    tags: Optional[dict[str, Any]] = None,
) -> None:
    """Write a tiled, compressed GeoTIFF.

    Parameters
    ----------
    path : Path
        Replaced only when the new file is complete.
    bands : dict of str to ndarray, shape (rows, columns)
        Band descriptions and values, all of one type; nan becomes `NODATA` in float bands. Red, green and
        blue are a picture, and alpha marks its pixels.
    transform : Affine
        From (column, row) to world coordinates.
    crs : CRS or None
    nodata : float, optional
        Value of integer bands that stands for no value.
    tags : dict, optional
        Further metadata of the file.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    arrays = list(bands.values())
    floating = arrays[0].dtype.kind == "f"
    profile = {
        "driver": "GTiff",
        "height": arrays[0].shape[0],
        "width": arrays[0].shape[1],
        "count": len(arrays),
        "dtype": arrays[0].dtype.name,
        "nodata": NODATA if floating else nodata,
        "transform": transform,
        "crs": crs,
        "tiled": True,
        "blockxsize": 256,
        "blockysize": 256,
        "compress": "deflate",
        "predictor": 3 if floating else 2,
        "zlevel": 1,
        "num_threads": "all_cpus",
        "BIGTIFF": "IF_SAFER",
        **({"photometric": "RGB"} if set(PICTURE) <= set(bands) else {}),
    }
    with atomic_output(path) as temporary:
        with rasterio.open(temporary, "w", **profile) as raster:
            raster.update_tags(**(tags or {}))
            raster.colorinterp = [COLOURS.get(name, ColorInterp.undefined) for name in bands]
            for number, (name, values) in enumerate(bands.items(), start=1):
                raster.set_band_description(number, name)
                raster.update_tags(number, **_statistics(values))
                raster.write(_filled(values), number)
        if not _holds(temporary, arrays):
            raise InputError(f"{path} was not written completely; free some space or choose another folder.")


def _filled(values: np.ndarray) -> np.ndarray:
    if values.dtype.kind != "f":
        return values
    return np.where(np.isfinite(values), values, NODATA).astype(values.dtype)


def _holds(path: Path, arrays: list[np.ndarray]) -> bool:
    """Whether a raster reads as it was written; GDAL does not report a full disk."""
    try:
        with rasterio.open(path) as raster:
            return all(
                np.array_equal(raster.read(number), _filled(values))
                for number, values in enumerate(arrays, start=1)
            )
    except (RasterioError, OSError):
        return False


def _statistics(values: np.ndarray) -> dict[str, float]:
    """Return the statistics of a band by GDAL's names, so that readers need not compute them."""
    valid = values[np.isfinite(values)]
    if valid.size == 0:
        return {}
    return {
        "STATISTICS_MINIMUM": float(valid.min()),
        "STATISTICS_MAXIMUM": float(valid.max()),
        "STATISTICS_MEAN": float(valid.mean(dtype=float)),
        "STATISTICS_STDDEV": float(valid.std(dtype=float)),
        "STATISTICS_VALID_PERCENT": 100.0 * valid.size / values.size,
    }
