"""Reference systems are horizontal and in metres, or refused."""

import struct

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.reference_systems import (
    horizontal,
    name_of,
    parse_geotiff_keys,
    parse_wkt,
    require_metres,
)
from rasterio.crs import CRS


def directory(*keys):
    """Return a GeoTIFF key directory of (key, value) pairs."""
    return struct.pack("<4H", 1, 1, 0, len(keys)) + b"".join(
        struct.pack("<4H", key, 0, 1, value) for key, value in keys
    )


def test_a_projected_system_is_read_from_wkt():
    assert parse_wkt(CRS.from_epsg(25832).to_wkt()) == CRS.from_epsg(25832)


def test_heights_are_cut_off_a_compound_system():
    compound = CRS.from_user_input("EPSG:25832+7837")
    assert parse_wkt(compound.to_wkt()) == CRS.from_epsg(25832)


def test_a_projected_system_is_read_from_geotiff_keys():
    assert parse_geotiff_keys(directory((1024, 1), (3072, 32633)), b"", b"") == CRS.from_epsg(32633)


def test_a_geographic_system_is_read_from_geotiff_keys():
    assert parse_geotiff_keys(directory((1024, 2), (2048, 4326)), b"", b"").is_geographic


def test_keys_without_a_system_are_none():
    assert parse_geotiff_keys(directory(), b"", b"") is None


@pytest.mark.parametrize("wkt", ["", "nonsense", 'PROJCS["cut off", GEOGCS['])
def test_broken_wkt_is_a_value_error(wkt):
    with pytest.raises(ValueError, match=r".+"):
        parse_wkt(wkt)


def test_metres_are_accepted():
    require_metres(CRS.from_epsg(25832), "a.las")
    require_metres(parse_wkt('LOCAL_CS["site",UNIT["metre",1]]'), "a.las")


@pytest.mark.parametrize(
    ("crs", "unit"),
    [
        (CRS.from_epsg(4326), "in degrees"),
        (CRS.from_epsg(2992), "in foot"),
        (CRS.from_epsg(2903), "in US survey foot"),
        (CRS.from_epsg(4978), "earth-centred"),
        (CRS.from_wkt('LOCAL_CS["site",UNIT["foot",0.3048]]'), "in foot"),
    ],
)
def test_other_units_are_refused_with_the_remedy(crs, unit):
    with pytest.raises(InputError, match=f"a.las are {unit} .*; reproject to a projected"):
        require_metres(crs, "a.las")


def test_a_system_is_named_by_its_code_or_else_its_own_name():
    assert name_of(CRS.from_epsg(25832)) == "EPSG:25832"
    assert name_of(CRS.from_wkt('LOCAL_CS["site",UNIT["metre",1]]')) == "site"


def test_heights_in_feet_are_refused():
    with pytest.raises(InputError, match=r"heights .* are in US survey foot"):
        horizontal(CRS.from_string("EPSG:32632+6360"))
