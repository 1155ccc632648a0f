"""The outlines of a layer, as they are compared."""

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.evaluation.outlines import disagreements, outlines_of
from rasterio.crs import CRS
from shapely.geometry import LineString, MultiPolygon, Polygon, box

UTM = CRS.from_epsg(25833).to_wkt()
# As shapefiles write the same system.
ESRI = CRS.from_epsg(25833).to_wkt(version="WKT1_ESRI")


def outlines(*shapes, wkt=UTM, name="WALLS plan"):
    return outlines_of(name, [shape.wkb if shape is not None else None for shape in shapes], wkt)


def test_polygons_that_touch_are_one_wall():
    found = outlines(box(0, 0, 1, 1), box(1, 0, 2, 1), box(2.0004, 0, 3, 1)).shape
    assert found.symmetric_difference(box(0, 0, 3, 1)).area < 1e-9
    assert len(found.geoms) == 1


def test_walls_a_centimetre_apart_stay_apart():
    assert len(outlines(box(0, 0, 1, 1), box(1.01, 0, 2, 1)).shape.geoms) == 2


def test_parts_and_holes_are_kept():
    ring = box(0, 0, 4, 4).difference(box(1, 1, 3, 3))
    found = outlines(MultiPolygon([ring, box(6, 0, 7, 1)])).shape
    assert found.area == pytest.approx(13)
    assert found.boundary.length == pytest.approx(16 + 8 + 4)


def test_features_without_geometry_are_left_out():
    assert outlines(None, Polygon(), box(0, 0, 1, 1)).shape.area == pytest.approx(1)


def test_an_outline_that_crosses_itself_is_repaired_with_a_warning():
    found = outlines(Polygon([(0, 0), (2, 2), (2, 0), (0, 2)]))
    assert found.shape.area == pytest.approx(2, abs=0.01)
    assert found.warnings == ("Outlines of WALLS plan that cross themselves were repaired: 1.",)


def test_heights_are_dropped():
    found = outlines(Polygon([(0, 0, 5), (1, 0, 6), (1, 1, 7)])).shape
    assert found.area == pytest.approx(0.5)
    assert not found.has_z


@pytest.mark.parametrize("shapes", [[], [None], [Polygon()]])
def test_a_layer_without_outlines_is_refused(shapes):
    with pytest.raises(InputError, match="WALLS plan holds no outlines"):
        outlines(*shapes)


def test_a_coordinate_that_is_not_a_number_is_named():
    with pytest.raises(InputError, match="Feature 2 of WALLS plan"):
        outlines(box(0, 0, 1, 1), LineString([(0, 0), (float("nan"), 1)]))


def test_degrees_are_refused():
    with pytest.raises(InputError, match="WALLS plan are in degrees"):
        outlines(box(0, 0, 1, 1), wkt=CRS.from_epsg(4326).to_wkt())


def test_two_layers_of_one_site_raise_no_doubt():
    walls = outlines(box(500000, 5800000, 500001, 5800001))
    for wkt in (UTM, ESRI):
        reference = outlines(box(500000, 5800000, 500002, 5800001), wkt=wkt, name="REFERENCE true")
        assert disagreements(walls, reference, 0.1) == ()


def test_two_systems_are_refused():
    zone32 = CRS.from_epsg(25832).to_wkt()
    walls, reference = outlines(box(0, 0, 1, 1)), outlines(box(0, 0, 1, 1), wkt=zone32, name="REFERENCE true")
    with pytest.raises(InputError, match="WALLS plan is in EPSG:25833, but REFERENCE true in EPSG:25832"):
        disagreements(walls, reference, 0.1)


def test_a_layer_without_a_system_is_assumed_to_be_in_the_other_one():
    (doubt,) = disagreements(outlines(box(0, 0, 1, 1), wkt=""), outlines(box(0, 0, 1, 1), name="true"), 0.1)
    assert doubt == "WALLS plan has no coordinate reference system; that of true is assumed."


def test_layers_far_apart_are_doubtful():
    (doubt,) = disagreements(outlines(box(0, 0, 1, 1)), outlines(box(100, 0, 101, 1), name="true"), 0.1)
    assert "WALLS plan and true have nothing in common: they are 99.0 m apart" in doubt


def test_walls_must_be_polygons_but_a_reference_may_be_lines():
    lines = outlines(LineString([(0, 0), (1, 0)]), name="true")
    assert disagreements(outlines(box(0, 0, 1, 1)), lines, 0.1) == ()
    with pytest.raises(InputError, match="true holds lines"):
        disagreements(lines, outlines(box(0, 0, 1, 1)), 0.1)
