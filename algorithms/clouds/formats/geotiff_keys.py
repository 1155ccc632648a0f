"""The reference system of a LAS file that describes it by GeoTIFF keys."""

import struct
from typing import Optional

from rasterio.crs import CRS
from rasterio.errors import CRSError, RasterioError
from rasterio.io import MemoryFile

from ...reference_systems import horizontal, is_local


def parse_geotiff_keys(directory: bytes, doubles: bytes, text: bytes) -> Optional[CRS]:
    """Return the horizontal system that the three GeoTIFF records of a LAS file describe.

    GDAL reads the keys more completely than any Python package, so they are handed over in a GeoTIFF of
    one pixel.

    Raises
    ------
    ValueError
        If the keys are not a coordinate reference system.
    """
    try:
        geotiff = MemoryFile(_one_pixel_geotiff(directory, doubles, text))
        with geotiff, geotiff.open() as dataset:
            crs = dataset.crs
    except (CRSError, RasterioError) as error:
        raise ValueError(str(error)) from error
    # Keys without any system come back as a nameless local one.
    return None if crs is None or is_local(crs) else horizontal(crs)


def _one_pixel_geotiff(directory: bytes, doubles: bytes, text: bytes) -> bytes:
    short, ascii_, double = 3, 2, 12
    sizes = {short: 2, ascii_: 1, double: 8}
    # A pixel scale and a tie point keep GDAL from warning about a missing geotransform.
    tags = [(tag, short, struct.pack("<H", value)) for tag, value in _PIXEL_TAGS]
    tags += [(33550, double, struct.pack("<3d", 1, 1, 0)), (33922, double, bytes(48))]
    tags += [(34735, short, directory), (34736, double, doubles), (34737, ascii_, text)]
    tags = [tag for tag in tags if tag[2]]
    entries, values = b"", b""
    first_value = 8 + 2 + 12 * len(tags) + 4
    for tag, kind, value in tags:
        entries += struct.pack("<HHI", tag, kind, len(value) // sizes[kind])
        if len(value) <= 4:
            entries += value.ljust(4, b"\0")
        else:
            entries += struct.pack("<I", first_value + len(values))
            values += value + b"\0" * (len(value) % 2)
    return b"II*\0\x08\0\0\0" + struct.pack("<H", len(tags)) + entries + bytes(4) + values


# Width, height, bits, no compression, black is zero, strip offset (any byte), samples, rows, bytes.
_PIXEL_TAGS = (
    (256, 1),
    (257, 1),
    (258, 8),
    (259, 1),
    (262, 1),
    (273, 0),
    (277, 1),
    (278, 1),
    (279, 1),
)
