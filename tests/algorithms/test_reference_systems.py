"""Reference systems are horizontal and in metres, or refused."""

import numpy as np
import pyproj
import pytest
import rasterio
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.raster import write_raster
from ichnograph.algorithms.reference_systems import (
    UNDEFINED,
    are_swapped,
    has_only_heights,
    horizontal,
    is_elsewhere,
    is_local,
    name_of,
    parse_layer_wkt,
    parse_wkt,
    position_warning,
    require_metres,
)
from rasterio.crs import CRS
from rasterio.transform import from_origin


def test_a_projected_system_is_read_from_wkt():
    assert parse_wkt(CRS.from_epsg(25832).to_wkt()) == CRS.from_epsg(25832)


def test_heights_are_cut_off_a_compound_system():
    compound = CRS.from_user_input("EPSG:25832+7837")
    assert parse_wkt(compound.to_wkt()) == CRS.from_epsg(25832)


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
        (CRS.from_epsg(7837), "heights only"),
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


@pytest.mark.parametrize("height", [7837, 5783])
def test_a_system_without_its_heights_is_written_as_that_of_its_code(height):
    plane = horizontal(CRS.from_user_input(f"EPSG:25832+{height}"))
    assert plane.to_wkt() == CRS.from_epsg(25832).to_wkt()


def test_a_datum_shift_survives_without_the_heights():
    shift = "+proj=utm +zone=33 +ellps=bessel +towgs84=598,73,418,0,0,0,0 +units=m"
    plane = horizontal(CRS.from_string(f"{shift} +geoidgrids=geoid.gtx +vunits=m"))
    assert plane == CRS.from_string(shift)
    assert "TOWGS84[598,73,418,0,0,0,0]" in plane.to_wkt()


@pytest.mark.parametrize(
    "wkt",
    [
        "",
        'LOCAL_CS["drawing",UNIT["metre",1]]',
        CRS.from_epsg(4326).to_wkt().replace("WGS 84", UNDEFINED),
    ],
)
def test_a_layer_without_a_system_on_earth_has_none(wkt):
    assert parse_layer_wkt(wkt, "the layer walls") is None


def test_a_layer_in_a_local_system_of_feet_is_refused():
    with pytest.raises(InputError, match="of the layer walls are in foot"):
        parse_layer_wkt('LOCAL_CS["drawing",UNIT["foot",0.3048]]', "the layer walls")


def test_a_system_of_time_is_not_one_of_a_map():
    wkt = 'TIMECRS["t",TDATUM["x"],CS[TemporalDateTime,1],AXIS["t",future]]'
    with pytest.raises(InputError, match="of the cloud are not those of a map"):
        require_metres(CRS.from_wkt(wkt), "the cloud")


def test_a_layer_in_degrees_or_with_a_broken_system_is_refused():
    with pytest.raises(InputError, match="of the layer walls are in degrees"):
        parse_layer_wkt(CRS.from_epsg(4326).to_wkt(), "the layer walls")
    with pytest.raises(InputError, match="of the layer walls is not understood; assign it again"):
        parse_layer_wkt('PROJCS["cut off", GEOGCS[', "the layer walls")


@pytest.mark.parametrize(
    ("definition", "local"),
    [('LOCAL_CS["site",UNIT["metre",1]]', True), ("EPSG:25832", False), ("EPSG:4326", False)],
)
def test_a_local_system_is_recognised(definition, local):
    assert is_local(CRS.from_user_input(definition)) is local


SCANNER = (
    'ENGCRS["Scanner",EDATUM["scanner"],CS[Cartesian,3],AXIS["x",east,ORDER[1]],AXIS["y",north,ORDER[2]],'
    'AXIS["z",up,ORDER[3]],LENGTHUNIT["metre",1]]'
)


def test_the_third_axis_of_a_local_system_is_dropped_so_that_rasters_can_hold_it(tmp_path):
    scanner = parse_wkt(SCANNER)
    assert is_local(scanner)
    assert name_of(scanner) == "Scanner"
    write_raster(
        tmp_path / "a.tif", {"walls": np.ones((3, 3), np.uint8)}, from_origin(0, 0, 0.1, 0.1), scanner
    )
    with rasterio.open(tmp_path / "a.tif") as raster:
        assert name_of(raster.crs) == "Scanner"


def test_a_projected_system_of_three_axes_is_that_of_two():
    assert parse_wkt(pyproj.CRS.from_epsg(25832).to_3d().to_wkt()).to_wkt() == CRS.from_epsg(25832).to_wkt()


def test_metres_of_a_grid_derived_from_a_projected_system_are_accepted():
    base = pyproj.CRS.from_epsg(25832).to_json_dict()
    moved = {"A0": -500000, "A1": 1, "A2": 0, "B0": -5000000, "B1": 0, "B2": 1}
    grid = {
        "type": "DerivedProjectedCRS",
        "name": "site grid",
        "base_crs": base,
        "conversion": {
            "name": "site",
            "method": {"name": "Affine parametric transformation", "id": {"authority": "EPSG", "code": 9624}},
            "parameters": [
                {"name": name, "value": value, "unit": "metre" if name[1] == "0" else "unity"}
                for name, value in moved.items()
            ],
        },
        "coordinate_system": base["coordinate_system"],
    }
    crs = parse_wkt(pyproj.CRS.from_json_dict(grid).to_wkt())
    require_metres(crs, "a.las")
    assert name_of(crs) == "site grid"


def test_heights_alone_are_recognised():
    assert has_only_heights(CRS.from_epsg(7837))
    assert not has_only_heights(CRS.from_user_input("EPSG:25832+7837"))
    assert not has_only_heights(CRS.from_epsg(25832))


@pytest.mark.parametrize(
    ("x", "y", "swapped"),
    [(412345, 5812345, False), (5812345, 412345, True), (0, 0, False), (1e300, 1e300, False)],
)
def test_coordinates_that_fit_the_system_only_the_other_way_round_are_swapped(x, y, swapped):
    assert are_swapped(CRS.from_epsg(25833), x, y) is swapped


@pytest.mark.parametrize(
    ("x", "y", "elsewhere"),
    [
        (412345, 5812345, False),
        (5812345, 412345, False),
        (0, 0, True),
        (33_412_345, 5_812_345, True),
        (1e300, 0, True),
    ],
)
def test_coordinates_that_fit_the_system_in_no_way_are_elsewhere(x, y, elsewhere):
    assert is_elsewhere(CRS.from_epsg(25833), x, y) is elsewhere


@pytest.mark.parametrize(
    ("zone", "x", "y"), [(25832, 877519, 6121939), (25833, -31000, 6730000), (25833, 1090000, 7830000)]
)
def test_states_use_a_zone_beyond_its_edges(zone, x, y):
    # Bornholm, Bergen, Finnmark.
    assert not is_elsewhere(CRS.from_epsg(zone), x, y)


def test_a_zone_with_a_shift_of_its_datum_is_a_zone():
    spheroid = 'AUTHORITY["EPSG","7019"]]'
    wkt = CRS.from_epsg(25832).to_wkt().replace(spheroid, f"{spheroid},TOWGS84[1,2,3,0,0,0,0]")
    assert "TOWGS84" in wkt
    assert not is_elsewhere(CRS.from_wkt(wkt), 877519, 6121939)


def test_local_coordinates_beside_a_small_country_are_elsewhere():
    assert is_elsewhere(CRS.from_epsg(21781), 12, 7)


def test_a_northing_of_utm_before_its_easting_is_said_without_a_system_too():
    north, east = 5_812_345.0, 412_345.0
    (sentence,) = position_warning(None, np.array([north, east]), "a.xyz")
    assert "if they are metres, x is a northing of 5812 km and y an easting of 412 km" in sentence
    for x, y in ((east, north), (4_500_000.0, north), (2_600_000.0, 1_200_000.0), (10.0, 20.0), (5e6, 2e6)):
        assert position_warning(None, np.array([x, y]), "a.xyz") == ()


@pytest.mark.parametrize(
    ("code", "x", "y", "sentence"),
    [
        (3857, 1_224_500.0, 6_106_900.0, "Lengths in EPSG:3857, the system of a.las, are 1.49 times"),
        (5513, 1_043_000.0, 743_000.0, "The axes of EPSG:5513, the system of a.las, point south and west"),
    ],
)
def test_systems_that_would_spoil_a_plan_are_said(code, x, y, sentence):
    assert sentence in position_warning(CRS.from_epsg(code), np.array([x, y]), "a.las")[0]


@pytest.mark.parametrize(
    ("code", "x", "y"),
    [(25833, 390_000.0, 5_820_000.0), (2154, 1_200_000.0, 6_110_000.0), (2056, 2_600_000.0, 1_200_000.0)],
)
def test_systems_for_surveys_are_fine(code, x, y):
    assert position_warning(CRS.from_epsg(code), np.array([x, y]), "a.las") == ()
