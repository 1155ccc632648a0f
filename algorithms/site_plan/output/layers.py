"""The site plan's files: the density raster, the plan raster, the walls layer."""

from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np
import rasterio
from affine import Affine
from rasterio.crs import CRS

from ...errors import InputError
from ...raster import write_raster
from ...reference_systems import require_metres
from ...vector import write_vector
from ..density.density_image import DensityImage
from ..site_plan import SitePlan
from ..walls.height_gate import Heights

BANDS = ("density", "occupied height", "base", "top", "ground", "spread", "hanging height")
"""Descriptions of the bands of a density raster."""

OLDER_BANDS = 5
"""Number of bands that a raster of the plugin has at least; the first versions wrote no more."""

WALL_FIELDS = {
    "wall_id": "int",
    "kind": "str:10",
    "length": "float:12.3",
    "thickness": "float:12.3",
    "thick_sd": "float:12.3",
    "z_base": "float:12.3",
    "z_top": "float:12.3",
    "height": "float:12.3",
    "azimuth": "float:12.3",
    "radius": "float:12.3",
    "density": "float:12.3",
    "coverage": "float:12.3",
    "rms": "float:12.4",
    "votes": "int",
}
"""Fields of the walls layer; those that need the wall's faces (thickness, radius, ...) are null."""


@dataclass(frozen=True)
class DensityRaster:
    """A density raster as read from a file.

    Attributes
    ----------
    density : ndarray of float32, shape (rows, columns)
        Nan where there is none.
    heights : Heights or None
        None if the file holds only a density.
    transform : Affine
    crs : CRS or None
    """

    density: np.ndarray
    heights: Optional[Heights]
    transform: Affine
    crs: Optional[CRS]


def write_density(path: Path, image: DensityImage) -> None:
    """Write a density image as GeoTIFF with the bands `BANDS`."""
    arrays = (image.density, image.occupied, image.base, image.top, image.ground, image.spread, image.hanging)
    write_raster(path, dict(zip(BANDS, arrays)), image.transform, image.crs)


def read_density(path: Path) -> DensityRaster:
    """Read a density raster; one of another origin may hold a single band.

    Raises
    ------
    InputError
        If the file is no raster, is turned or has oblong pixels, is not in metres, or holds no density.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"INPUT {path}: there is no such file; check the path.")
    try:
        with rasterio.open(path) as raster:
            bands = dict(zip(raster.descriptions, range(1, raster.count + 1)))
            _check_grid(path, raster)
            if set(BANDS[:OLDER_BANDS]) <= set(bands):
                arrays = [_filled(raster, bands[name]) for name in BANDS if name in bands]
            else:
                arrays = [_filled(raster, 1)]
            transform, crs = raster.transform, raster.crs
    except (rasterio.errors.RasterioError, OSError) as error:
        raise InputError(
            f"INPUT {path}: cannot be read as a raster; give the output of 'densityimage'."
        ) from error
    density, *rest = arrays
    if not (density > 0).any():
        raise InputError(f"INPUT {path}: holds no density above 0; is it the right raster?")
    return DensityRaster(density, Heights(*rest) if rest else None, transform, crs)


def _check_grid(path: Path, raster) -> None:
    t = raster.transform
    if t.is_identity:
        raise InputError(f"INPUT {path}: is not georeferenced; give the output of 'densityimage'.")
    if t.b or t.d or t.a <= 0 or abs(t.a + t.e) > 1e-6 * t.a:
        raise InputError(f"INPUT {path}: pixels must be square and north up; resample it with the Warp tool.")
    if raster.crs:
        require_metres(raster.crs, str(path))


def _filled(raster, number: int) -> np.ndarray:
    return raster.read(number, masked=True).astype(np.float32).filled(np.nan)


def write_plan(path: Path, plan: SitePlan, transform: Affine, crs: Optional[CRS]) -> None:
    """Write the wall pixels as a byte GeoTIFF: 1 wall, 0 none."""
    write_raster(path, {"wall": plan.image.walls.astype(np.uint8)}, transform, crs)


def write_walls(path: Path, plan: SitePlan, crs: Optional[CRS]) -> None:
    """Write the walls as polygons with the fields `WALL_FIELDS`."""
    features = (
        (wall.outline, {name: getattr(wall, name, None) for name in WALL_FIELDS}) for wall in plan.walls
    )
    write_vector(path, "Polygon", WALL_FIELDS, features, crs)
