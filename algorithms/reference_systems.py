"""Coordinate reference systems of point clouds, with the GDAL of rasterio instead of pyproj."""

import re
import struct
from typing import Optional

from rasterio.crs import CRS
from rasterio.errors import CRSError, RasterioError
from rasterio.io import MemoryFile

from .errors import InputError

# What GDAL calls a frame of no known place, such as a scanner's own.
LOCAL = ("LOCAL_CS", "ENGCRS", "ENGINEERINGCRS")
# What a GeoPackage has that was written without a system.
UNDEFINED = "Undefined geographic SRS"


def parse_wkt(wkt: str) -> CRS:
    """Return the horizontal part of a coordinate reference system in WKT 1 or 2.

    Raises
    ------
    ValueError
        If the text is not a coordinate reference system.
    """
    try:
        return horizontal(CRS.from_wkt(wkt))
    except CRSError as error:
        raise ValueError(str(error)) from error


def parse_layer_wkt(wkt: str, owner: str) -> Optional[CRS]:
    """Return the horizontal system of a vector layer, None if it has none; `owner` is what messages call it.

    Raises
    ------
    InputError
        If the text is not a coordinate reference system, or not in metres.
    """
    if not wkt or wkt.startswith(LOCAL) or UNDEFINED in wkt:
        return None
    try:
        crs = parse_wkt(wkt)
    except ValueError as error:
        raise InputError(
            f"The coordinate reference system of {owner} is not understood; assign it again."
        ) from error
    require_metres(crs, owner)
    return crs


def parse_geotiff_keys(directory: bytes, doubles: bytes, text: bytes) -> Optional[CRS]:
    """Return the horizontal system that the three GeoTIFF records of a LAS file describe.

    GDAL reads the keys best itself, so they are handed over in a GeoTIFF of one pixel.

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
    # Keys that name no system at all come back as a nameless local one.
    return None if crs is None or crs.to_wkt().startswith("LOCAL_CS") else horizontal(crs)


def horizontal(crs: CRS) -> CRS:
    """Return `crs` without its heights.

    Raises
    ------
    InputError
        If the heights are not in metres.
    """
    wkt = crs.to_wkt()
    if not wkt.startswith("COMPD_CS"):
        return crs
    vertical = re.search(r'VERT_CS\[.*\bUNIT\["([^"]*)",([^],]+)', wkt)
    if vertical and float(vertical.group(2)) != 1.0:
        raise InputError(f"The heights of {name_of(crs)} are in {vertical.group(1)}; convert them to metres.")
    start = re.search(r"\b(PROJCS|GEOGCS|LOCAL_CS)\[", wkt).start()
    depth = 0
    for match in re.finditer(r'"[^"]*"|\[|\]', wkt[start:]):
        depth += {"[": 1, "]": -1}.get(match.group(), 0)
        if match.group() == "]" and depth == 0:
            return CRS.from_wkt(wkt[start : start + match.end()])
    return crs


def name_of(crs: CRS) -> str:
    """Return `EPSG:25832`, or the name in the definition if there is no code."""
    code = crs.to_epsg()
    return f"EPSG:{code}" if code else crs.to_wkt().split('"')[1]


def require_metres(crs: CRS, owner: str) -> None:
    """Refuse a system that is not in metres; `owner` says in the message whose it is.

    Raises
    ------
    InputError
        If the axes are degrees, feet, or the metres of an earth-centred system.
    """
    wkt = crs.to_wkt()
    if crs.is_geographic:
        system = "in degrees"
    elif wkt.startswith("GEOCCS"):
        system = "earth-centred"
    else:
        # The unit of the axes comes last, after the one of the underlying angles.
        unit, metres = re.findall(r'\bUNIT\["([^"]*)",([^],]+)', wkt)[-1]
        if float(metres) == 1.0:
            return
        system = f"in {unit}"
    raise InputError(
        f"The coordinates of {owner} are {system} ({name_of(crs)}); "
        "reproject to a projected coordinate reference system in metres."
    )


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
