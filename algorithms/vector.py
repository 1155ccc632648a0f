"""Writing vector layers: shapefile or GeoPackage, by extension."""

import errno
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Optional

import fiona
from fiona.errors import FionaError
from rasterio.crs import CRS
from shapely.geometry import mapping
from shapely.geometry.base import BaseGeometry

from .errors import InputError
from .files import atomic_output, is_full

UNKNOWN_METRES = 'LOCAL_CS["Undefined Cartesian SRS",UNIT["metre",1]]'
"""Reference system of a GeoPackage without one; if it were empty, GDAL would write degrees."""

WRITTEN = "2000-01-01T00:00:00.000Z"
"""What a GeoPackage states as the time of its last change, so that the same layer is the same bytes twice."""

DRIVERS = {".shp": "ESRI Shapefile", ".gpkg": "GPKG"}


def write_vector(
    path: Path,
    geometry: str,
    fields: dict[str, str],
    features: Iterable[tuple[BaseGeometry, dict[str, Any]]],
    crs: Optional[CRS],
) -> None:
    """Write features to a shapefile or a GeoPackage.

    Parameters
    ----------
    path : Path
        Ends in .shp or .gpkg; replaced only when the new file is complete.
    geometry : str
        Geometry type, as 'Polygon'.
    fields : dict of str to str
        Names, ten characters at most, and fiona types; the values are rounded to the decimals of the type.
    features : iterable of (shapely geometry, dict)
        Values by field; None is null.
    crs : CRS or None

    Raises
    ------
    InputError
        If the extension is unknown or the file cannot be written.
    """
    path = Path(path)
    driver = DRIVERS.get(path.suffix.lower())
    if driver is None:
        raise InputError(f"{path}: cannot write this kind of layer; end the name in .shp or .gpkg.")
    schema = {"geometry": geometry, "properties": fields}
    options = {"encoding": "utf-8"} if driver == "ESRI Shapefile" else {}
    nowhere = UNKNOWN_METRES if driver == "GPKG" else None
    wkt = crs.to_wkt() if crs else nowhere
    records = [
        {
            "geometry": mapping(shape),
            "properties": {name: _rounded(values[name], kind) for name, kind in fields.items()},
        }
        for shape, values in features
    ]
    with (
        atomic_output(path) as temporary,
        _gdal_errors_named(path),
        fiona.Env(OGR_CURRENT_DATE=WRITTEN),
        fiona.open(temporary, "w", driver=driver, schema=schema, crs_wkt=wkt, **options) as layer,
    ):
        layer.writerecords(records)


def _rounded(value: Any, kind: str) -> Any:
    """Return a value with the decimals of its field, as `float:12.3`, which a GeoPackage would not apply."""
    name, _, size = kind.partition(":")
    decimals = size.partition(".")[2]
    return round(float(value), int(decimals)) if name == "float" and decimals and value is not None else value


@contextmanager
def _gdal_errors_named(path: Path) -> Iterator[None]:
    """Raise an error of GDAL, such as a full disk, as one sentence."""
    try:
        yield
    except (FionaError, RuntimeError) as error:
        if is_full(path.parent):
            raise OSError(errno.ENOSPC, "the disk is full") from error
        raise InputError(
            f"{path} cannot be written ({error}); free some space or choose another folder."
        ) from error
