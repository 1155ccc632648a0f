"""What a file says of its reference system."""

from pathlib import Path

import pytest
from ichnograph.algorithms.clouds.formats.stated_crs import read_crs
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.reference_systems import parse_wkt
from rasterio.crs import CRS

SCAN = Path("scan.las")


def read(crs):
    return read_crs(SCAN, lambda: parse_wkt(crs.to_wkt()))


def test_a_projected_system_is_taken_without_its_heights():
    assert read(CRS.from_user_input("EPSG:25832+7837")) == (CRS.from_epsg(25832), ())


def test_no_system_is_no_warning():
    assert read_crs(SCAN, lambda: None) == (None, ())


def test_a_system_that_cannot_be_understood_is_a_warning():
    crs, warnings = read_crs(SCAN, lambda: parse_wkt("nonsense"))
    assert crs is None
    assert warnings == ("The coordinate reference system in scan.las cannot be understood.",)


def test_a_system_of_heights_only_is_ignored_with_a_warning():
    crs, warnings = read(CRS.from_epsg(7837))
    assert crs is None
    assert warnings == ("scan.las states a system of heights only (EPSG:7837), which is ignored.",)


LOCAL = (
    'ENGCRS["Scanner",EDATUM["scanner"],CS[Cartesian,3],AXIS["x",east],AXIS["y",north],AXIS["z",up],'
    'LENGTHUNIT["{}",{}]]'
)


def test_a_local_system_counts_as_none_and_is_said():
    crs, warnings = read_crs(SCAN, lambda: parse_wkt(LOCAL.format("metre", 1)))
    assert crs is None
    assert "scan.las states a local system (Scanner)" in warnings[0]


def test_a_local_system_in_feet_is_refused():
    with pytest.raises(InputError, match=r"scan\.las"):
        read_crs(SCAN, lambda: parse_wkt(LOCAL.format("foot", 0.3048)))


def test_heights_in_feet_are_refused_by_the_name_of_the_file():
    with pytest.raises(InputError, match=r"^scan\.las: The heights of .* are in US survey foot"):
        read(CRS.from_string("EPSG:32632+6360"))
