"""Layers of points, with heights as Z values or in a field, and with names or without."""

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.lists.point_layer import read_features
from ichnograph.algorithms.registration.lists.point_list import points_of_features, read_point_list
from ichnograph.algorithms.registration.lists.settings import ListSettings
from ichnograph.tests.algorithms.registration.lists.written_lists import XYZ, refuse, write
from rasterio.crs import CRS

UTM = CRS.from_epsg(25833).to_wkt()


def write_layer(path, points, fields=None, rows=None, geometry="3D Point", crs_wkt=UTM, **options):
    drivers = {".shp": "ESRI Shapefile", ".gpkg": "GPKG", ".geojson": "GeoJSON", ".fgb": "FlatGeobuf"}
    schema = {"geometry": geometry, "properties": fields or {}}
    kind = geometry.replace("3D ", "")
    with fiona.open(path, "w", drivers[path.suffix], schema, crs_wkt=crs_wkt, **options) as layer:
        for point, values in zip(points, rows or [{}] * len(points)):
            shape = {"type": kind, "coordinates": [point] if kind == "MultiPoint" else point}
            layer.write({"geometry": shape, "properties": values})
    return path


@pytest.mark.parametrize("suffix", [".shp", ".gpkg", ".geojson", ".fgb"])
@pytest.mark.parametrize("geometry", ["3D Point", "3D MultiPoint"])
def test_layers_of_points_with_z(tmp_path, suffix, geometry):
    rows = [{"Name": "007"}, {"Name": "T 2"}, {"Name": "Tür"}]
    options = {"SPATIAL_INDEX": "NO"} if suffix == ".fgb" else {}
    path = write_layer(tmp_path / f"control{suffix}", XYZ, {"Name": "str"}, rows, geometry, **options)
    points = read_point_list(path)
    assert (points.name, points.names, points.named) == ("control", ("007", "T 2", "Tür"), True)
    np.testing.assert_array_equal(points.xyz, XYZ)
    assert points.crs.to_epsg() == 25833


@pytest.mark.parametrize("decoded_by_gdal", [True, False])
@pytest.mark.parametrize("encoding", ["utf-8", "iso-8859-1"])
def test_names_of_shapefiles_have_the_stated_encoding(tmp_path, encoding, decoded_by_gdal):
    names = ("Süd", "Größe", "P")
    rows = [{"name": name} for name in names]
    path = write_layer(tmp_path / "list.shp", XYZ, {"name": "str"}, rows, encoding=encoding)

    # QGIS sets this option once it has opened a shapefile.
    with fiona.Env(**({} if decoded_by_gdal else {"SHAPE_ENCODING": ""})):
        assert read_point_list(path).names == names


def test_a_shapefile_of_an_unknown_encoding_is_read_by_gdal(tmp_path):
    path = write_layer(tmp_path / "list.shp", XYZ, {"name": "str"}, [{"name": name} for name in "ABC"])
    path.with_suffix(".cpg").write_text("Klingon")

    assert read_point_list(path).names == ("A", "B", "C")


def test_layers_without_names_are_numbered(tmp_path):
    fields, rows = {"id": "int", "code": "str"}, [{"id": None, "code": "a"}] * 3
    points = read_point_list(write_layer(tmp_path / "a.gpkg", XYZ, fields, rows))
    assert (points.names, points.named) == (("1", "2", "3"), False)


@pytest.mark.parametrize(
    ("kind", "values", "names"),
    [("int", [7, 8, 9], ("7", "8", "9")), ("float", [7.0, 8.0, 9.0], ("7", "8", "9"))],
)
def test_numbers_are_names_too(tmp_path, kind, values, names):
    rows = [{"PT_NR": value} for value in values]
    assert read_point_list(write_layer(tmp_path / "a.shp", XYZ, {"PT_NR": kind}, rows)).names == names


def test_a_field_that_names_every_point_is_preferred_to_one_that_does_not():
    features = [((1, 2, 3), {"name": None, "id": 4}), ((1, 2, 3), {"name": "a", "id": 5})]
    assert points_of_features("list", "the layer", features, "").names == ("4", "5")


def test_heights_may_stand_in_a_field(tmp_path):
    rows = [{"name": name, "Height": point[2]} for name, point in zip("abc", XYZ)]
    flat = [point[:2] for point in XYZ]
    path = write_layer(tmp_path / "a.shp", flat, {"name": "str", "Height": "float"}, rows, "Point")
    np.testing.assert_array_equal(read_point_list(path).xyz, XYZ)


@pytest.mark.parametrize(
    ("crs_wkt", "sentence"),
    [
        (CRS.from_epsg(4326).to_wkt(), "are in degrees .EPSG:4326.; reproject"),
        (CRS.from_epsg(2263).to_wkt(), "are in US survey foot .EPSG:2263.; reproject"),
    ],
)
def test_layers_that_are_not_in_metres_are_refused(tmp_path, crs_wkt, sentence):
    refuse(write_layer(tmp_path / "a.gpkg", XYZ, crs_wkt=crs_wkt), sentence)


def test_the_frame_of_a_scanner_is_no_system(tmp_path):
    local = 'LOCAL_CS["scanner",UNIT["metre",1]]'
    assert read_point_list(write_layer(tmp_path / "a.gpkg", XYZ, crs_wkt=local)).crs is None
    assert read_point_list(write_layer(tmp_path / "a.shp", XYZ, crs_wkt=None)).crs is None


def test_of_several_layers_one_is_chosen(tmp_path):
    path = write_layer(tmp_path / "site.gpkg", XYZ, layer="control")
    write_layer(path, XYZ[:2], layer="scan 1")
    refuse(path, r"several layers of points \(control, scan 1\); write site.gpkg\|layername=control")
    refuse(path, "has no layer scan 2 of points; choose among: control, scan 1", layer="scan 2")
    chosen = read_point_list(path, "scan 1")
    assert (chosen.name, len(chosen.names)) == ("scan 1", 2)


def test_layers_of_anything_else_do_not_count(tmp_path):
    path = write_layer(tmp_path / "site.gpkg", XYZ, layer="control")
    write_layer(path, [], layer="walls", geometry="Polygon")
    write_layer(path, [], layer="layer_styles", geometry="None", fields={"name": "str"})
    assert read_point_list(path).name == "site"
    assert read_point_list(path, "control").name == "site"
    refuse(path, "has no layer walls of points", layer="walls")


@pytest.mark.parametrize(
    ("features", "sentence"),
    [
        ([], "the layer holds no points"),
        ([((1, 2, 3), {}), (None, {})], "Feature 2 of the layer is not a single point"),
        ([((1, 2, 3), {}), ((1, 2, float("nan")), {})], "Feature 2 of the layer has a coordinate"),
        ([((1, 2), {})], "The points of the layer have no heights; give them Z"),
        ([((1, 2), {"z": 3}), ((1, 2), {"z": "low"})], "Feature 2 of the layer has a coordinate"),
        ([((1, 2, 3), {"name": "a"}), ((1, 2, 3), {"name": ""})], "Feature 2 of the layer has no name"),
        (
            [((1, 2, 3), {"id": 0}), ((1, 2, 4), {"id": 0})],
            "Two points .* called 0, in feature 1 and feature 2",
        ),
    ],
)
def test_features_that_are_no_list_are_refused(features, sentence):
    with pytest.raises(InputError, match=sentence):
        points_of_features("list", "the layer", features, "")


def test_what_only_looks_like_a_layer_is_refused(tmp_path):
    refuse(write(tmp_path, "T1 1 2 3\n", "a.shp"), "cannot be read as a layer")
    refuse(write_layer(tmp_path / "b.gpkg", [], geometry="Polygon"), "has no layer of points")


def test_heights_of_a_field_are_used_if_z_is_0_everywhere_and_it_is_said(tmp_path):
    rows = [{"Elevation": height} for *_, height in XYZ]
    path = write_layer(tmp_path / "a.shp", [(x, y, 0.0) for x, y, _ in XYZ], {"Elevation": "float"}, rows)
    points = read_point_list(path)
    np.testing.assert_array_equal(points.xyz, XYZ)
    assert "Z is 0 everywhere in" in points.warnings[0]
    assert "field Elevation" in points.warnings[0]


def test_a_site_at_height_0_is_left_there(tmp_path):
    rows = [{"z": None}] * 3
    path = write_layer(tmp_path / "a.shp", [(x, y, 0.0) for x, y, _ in XYZ], {"z": "float"}, rows)
    assert not read_point_list(path).xyz[:, 2].any()
    assert read_point_list(path).warnings == ()


def test_the_unit_in_the_name_of_a_field_of_heights_counts(tmp_path):
    for name, height in (("z_mm", 1500.0), ("z_ft", 5.0)):
        path = write_layer(
            tmp_path / f"{name}.gpkg", [(1, 2)], {name: "float"}, [{name: height}], geometry="Point"
        )
        if name == "z_mm":
            assert read_point_list(path).xyz[0, 2] == 1.5
        else:
            refuse(path, "gives lengths in ft; convert them to metres")


def test_a_layer_of_more_points_than_a_list_has_is_refused():
    with pytest.raises(InputError, match="has more than 2 points, too many for a list"):
        read_features("a", [((0, 0, 0), {})] * 3, "", ListSettings(most_points=2))


def test_a_layer_with_a_damaged_system_is_refused_in_one_sentence(tmp_path):
    path = write_layer(tmp_path / "a.shp", XYZ)
    path.with_suffix(".prj").write_text("PROJCS[x,")
    refuse(path, "cannot be read as a layer|is not understood")


@pytest.mark.parametrize("suffix", [".gpkg", ".fgb", ".geojson", ".shp"])
def test_damage_of_any_kind_is_refused_or_read_but_never_another_error(tmp_path, suffix):
    options = {"SPATIAL_INDEX": "NO"} if suffix == ".fgb" else {}
    names = [{"name": name} for name in "ABC"]
    path = write_layer(tmp_path / f"a{suffix}", XYZ, {"name": "str"}, names, **options)
    data = path.read_bytes()
    generator = np.random.default_rng(0)
    for _ in range(60):
        damaged = bytearray(data)
        for position in generator.integers(0, len(data), 3):
            damaged[position] = generator.integers(256)
        path.write_bytes(damaged)
        try:
            read_point_list(path)
        except InputError as error:
            assert "\n" not in str(error)


def test_a_geopackage_whose_tables_are_damaged_is_refused_before_it_ends_the_process(tmp_path):
    path = write_layer(tmp_path / "a.gpkg", XYZ)
    data = path.read_bytes()
    path.write_bytes(data.replace(b"srs_id INTEGER", b"srs_\xa1d INTEGER"))
    refuse(path, "cannot be read as a layer .*; save it again")


def layer_with_heights(tmp_path, z, heights, kind="float"):
    rows = [{"Elevation": height} for height in heights]
    points = [(x, y, height) for (x, y, _), height in zip(XYZ, z)]
    return read_point_list(write_layer(tmp_path / "a.shp", points, {"Elevation": kind}, rows))


def test_heights_of_a_field_of_text_may_have_decimal_commas(tmp_path):
    points = layer_with_heights(tmp_path, [0.0] * 3, ["1,5", "2,5", "3,25"], "str")
    np.testing.assert_array_equal(points.xyz[:, 2], [1.5, 2.5, 3.25])


def test_a_value_that_stands_for_no_height_is_none(tmp_path):
    points = layer_with_heights(tmp_path, [-9999.0] * 3, [1.5, 2.5, 3.25])
    np.testing.assert_array_equal(points.xyz[:, 2], [1.5, 2.5, 3.25])


@pytest.mark.parametrize(
    ("z", "heights"), [([0.0, 0, 0], [1.5, None, 3.25]), ([5.0, 0, 6], [5.0, 503.0, 6.0])]
)
def test_points_at_0_of_which_a_field_knows_some_heights_are_said(tmp_path, z, heights):
    points = layer_with_heights(tmp_path, z, heights)
    np.testing.assert_array_equal(points.xyz[:, 2], z)
    assert "though its field Elevation holds heights" in points.warnings[0]


def test_a_shapefile_whose_table_is_missing_has_no_names_and_it_is_said(tmp_path):
    path = write_layer(tmp_path / "a.shp", XYZ)
    path.with_suffix(".dbf").unlink()
    points = read_point_list(path)
    assert not points.named
    assert "has no table (.dbf) beside it" in points.warnings[0]


def test_fields_of_standard_deviations_are_read_with_correlations_if_there_are_any(tmp_path):
    schema = dict.fromkeys(("sx", "sy", "sz", "rxy"), "float")
    values = [
        {"sx": 0.001, "sy": 0.002, "sz": 0.003, "rxy": 0.5},
        {"sx": None, "sy": 1.0, "sz": 1.0, "rxy": 0},
    ]
    path = write_layer(tmp_path / "a.gpkg", XYZ[:2], schema, values)
    points = read_point_list(path)
    covariances = points.covariances

    assert any("1 of the 2 points in" in warning for warning in points.warnings)
    assert covariances[0] == pytest.approx(np.array([[1e-6, 1e-6, 0], [1e-6, 4e-6, 0], [0, 0, 9e-6]]))
    assert np.isnan(covariances[1]).all()


def test_fields_of_standard_deviations_have_the_names_and_units_that_columns_have(tmp_path):
    schema = dict.fromkeys(("SX_mm", "StdY_mm", "sigma_z_mm", "Corr_XY"), "float")
    values = [{"SX_mm": 1.0, "StdY_mm": 2.0, "sigma_z_mm": 3.0, "Corr_XY": 0.5}] * 2
    points = read_point_list(write_layer(tmp_path / "a.gpkg", XYZ[:2], schema, values))

    expected = np.array([[1e-6, 1e-6, 0], [1e-6, 4e-6, 0], [0, 0, 9e-6]])
    assert points.covariances[0] == pytest.approx(expected)


def test_whole_metres_of_a_reference_system_are_not_doubted(tmp_path):
    whole = [[412100, 5812100, 3], [412900, 5812400, 5], [412100, 5812800, 3]]
    assert read_point_list(write_layer(tmp_path / "a.gpkg", whole)).warnings == ()
    local = read_point_list(write_layer(tmp_path / "b.gpkg", whole, crs_wkt=None))
    assert "whole numbers" in local.warnings[0]
