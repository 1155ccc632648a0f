"""GeoTIFF keys of a LAS file become a reference system."""

import struct

from ichnograph.algorithms.clouds.formats.geotiff_keys import parse_geotiff_keys
from rasterio.crs import CRS


def directory(*keys):
    """Return a GeoTIFF key directory of (key, value) pairs."""
    return struct.pack("<4H", 1, 1, 0, len(keys)) + b"".join(
        struct.pack("<4H", key, 0, 1, value) for key, value in keys
    )


def test_a_projected_system_is_read_from_geotiff_keys():
    assert parse_geotiff_keys(directory((1024, 1), (3072, 32633)), b"", b"") == CRS.from_epsg(32633)


def test_a_geographic_system_is_read_from_geotiff_keys():
    assert parse_geotiff_keys(directory((1024, 2), (2048, 4326)), b"", b"").is_geographic


def test_keys_without_a_system_are_none():
    assert parse_geotiff_keys(directory(), b"", b"") is None
