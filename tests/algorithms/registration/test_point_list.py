"""Every way in which people write lists of points, and every way to spoil them."""

from pathlib import Path

import fiona
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.lists.point_list import points_of_features, read_point_list
from rasterio.crs import CRS

DATA = Path(__file__).parents[4] / "shared" / "data"

XYZ = [[1.5, 2.25, 3.0], [4.5, 5.25, 6.5], [-7.5, 8.0, 9.125]]
UTM = CRS.from_epsg(25833).to_wkt()


def write(tmp_path, content, name="scan1.txt"):
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def refuse(path, sentence, **options):
    with pytest.raises(InputError, match=sentence) as error:
        read_point_list(path, **options)
    assert str(path) in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    "text",
    [
        "1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125\n",
        "1.5 2.25 3.0\r\n4.5 5.25 6.5\r\n-7.5 8 9.125",
        "x y z\n1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125\n",
        "1.5,2.25,3.0\n4.5,5.25,6.5\n-7.5,8,9.125\n",
        "1,5;2,25;3,0\n4,5;5,25;6,5\n-7,5;8;9,125\n",
        "1,5\t2,25\t3,0\n4,5\t5,25\t6,5\n-7,5\t8\t9,125\n",
        "# picked by hand\n1.5 2.25 3.0\n\n// and\n4.5 5.25 6.5\n; last\n-7.5 8 9.125\n",
        "northing;easting;height\n2.25;1.5;3.0\n5.25;4.5;6.5\n8;-7.5;9.125\n",
        "3\n1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125\n",
    ],
)
def test_points_without_names_are_numbered_by_their_row(tmp_path, text):
    points = read_point_list(write(tmp_path, text))
    assert (points.name, points.names, points.named) == ("scan1", ("1", "2", "3"), False)
    np.testing.assert_array_equal(points.xyz, XYZ)
    assert points.warnings == ()


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("T1 1.5 2.25 3.0\nT2 4.5 5.25 6.5\n", ("T1", "T2")),
        ("T1,1.5,2.25,3.0\nT2,4.5,5.25,6.5\n", ("T1", "T2")),
        ("T1;1,5;2,25;3,0\nT2;4,5;5,25;6,5\n", ("T1", "T2")),
        ("T1 1,5 2,25 3,0\nT2 4,5 5,25 6,5\n", ("T1", "T2")),
        ("north tower\t1.5\t2.25\t3.0\nsouth tower\t4.5\t5.25\t6.5\n", ("north tower", "south tower")),
        ("Point #0 1.5 2.25 3.0\nPoint #1 4.5 5.25 6.5\n", ("Point #0", "Point #1")),
        ("Point 1 1.5 2.25 3.0\nPoint 2 4.5 5.25 6.5\n", ("Point 1", "Point 2")),
        ("101 1.5 2.25 3.0\n7 4.5 5.25 6.5\n", ("101", "7")),
        ("101 1.500 2.250 3.000\n102 4.500 5.250 6.500\n", ("101", "102")),
        ("007 1.5 2.25 3\n008 4.5 5.25 6.5\n", ("007", "008")),
        ("base_1,1.5,2.25,3\n1,4.5,5.25,6.5\n", ("base_1", "1")),
        ("1.1;1,5;2,25;3,0\n1.2;4,5;5,25;6,5\n", None),
        ("name;x;y;z\n1.1;1,5;2,25;3,0\n1.2;4,5;5,25;6,5\n", ("1.1", "1.2")),
        ("Pkt;Hochwert;Rechtswert;Höhe\n3;2,25;1,5;3\n4;5,25;4,5;6,5\n", ("3", "4")),
        ("x,y,z,Point No.\n1.5,2.25,3,9\n4.5,5.25,6.5,8\n", ("9", "8")),
        ("Station 4, Müller\nT1 1.5 2.25 3.0\nT2 4.5 5.25 6.5\n", ("T1", "T2")),
    ],
)
def test_names_may_be_anything(tmp_path, text, names):
    path = write(tmp_path, text)
    if names is None:
        refuse(path, "commas .* can be decimal signs|can be names or coordinates")
        return
    points = read_point_list(path)
    assert (points.names, points.named) == (names, True)
    np.testing.assert_array_equal(points.xyz, XYZ[:2])


def test_whole_coordinates_are_fine_beside_names_that_count_them(tmp_path):
    points = read_point_list(write(tmp_path, "1 0 0 0\n2 10 0 0\n3 0 10 5\n"))
    assert points.names == ("1", "2", "3")
    np.testing.assert_array_equal(points.xyz, [[0, 0, 0], [10, 0, 0], [0, 10, 5]])


@pytest.mark.parametrize(
    ("prefixes", "names"),
    [
        (("", ""), ("1", "2")),
        (("0,", "1,"), ("0", "1")),
        (("52017,", "3381,"), ("52017", "3381")),
        (("Point #0,", "Point #1,"), ("Point #0", "Point #1")),
        (("north tower,", "A,"), ("north tower", "A")),
    ],
)
def test_picking_lists_of_cloudcompare(tmp_path, prefixes, names):
    rows = ["1.500000000000,2.250000000000,3.000000000000", "4.500000000000,5.250000000000,6.500000000000"]
    text = "".join(f"{prefix}{row}\n" for prefix, row in zip(prefixes, rows))
    points = read_point_list(write(tmp_path, text, "picking_list.txt"))
    assert points.names == names
    np.testing.assert_array_equal(points.xyz, XYZ[:2])


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_encodings(tmp_path, encoding):
    path = write(tmp_path, "Tür 1;1,5;2,25;3\r\nTor 2;4,5;5,25;6,5\r\n".encode(encoding))
    assert read_point_list(path).names == ("Tür 1", "Tor 2")


@pytest.mark.parametrize(
    "name", ["a.xyz", "a.csv", "a.ASC", "a.pts", "a.dat", "a.neu", "a.pnt", "a.koo", "a"]
)
def test_any_other_extension_is_tried_as_text(tmp_path, name):
    points = read_point_list(write(tmp_path, "T1 1.5 2.25 3.0\n", name))
    assert (points.name, points.path) == ("a", tmp_path / name)


@pytest.mark.parametrize(
    "text",
    [
        "1.5 2.25 3.0 0.25\n4.5 5.25 6.5 0.5\n",
        "1.5 2.25 3.0 900\n4.5 5.25 6.5 800\n",
        "2 2.25 3.0 900\n4.5 5.25 6.5 800\n",
        "x y z intensity\n1 2 3 900\n",
        "1.5 2.25 3.0 10:58:35\n4.5 5.25 6.5 10:58:36\n",
        "T1 1.5 2.25 3.0 BOLT\nT2 4.5 5.25 6.5\nT3 7.5 8.25 9 corner of the house\n",
        "T1,1.5,2.25,3.0\nT2,4.5,5.25,6.5,BOLT\n",
        "101 BOLT 1.5 2.25 3.0\n102 NAIL 4.5 5.25 6.5\n",
        "id code x y z\n1 BOLT 1.5 2.25 3.0\n",
    ],
)
def test_further_columns_are_left_out_with_a_warning(tmp_path, text):
    points = read_point_list(write(tmp_path, text))
    assert points.xyz.shape == (text.count("\n") - (" z" in text), 3)
    assert points.xyz[0, 1] in (2.25, 2)
    (warning,) = points.warnings
    assert "its further columns were left out" in warning


@pytest.mark.parametrize(
    "text",
    [
        "100 1 2 3\n250 4 5 6\n",
        "101 5.1 6.2 7\n102 8.1 9.2 7\n",
        "1 5.123 6.234 7.345\n2.1 5.223 6.334 7.445\n",
        "A;BOLT;1.5;2.5;3.5\nA;NAIL;1.5;2.5;3.5\n",
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(tmp_path, text):
    refuse(write(tmp_path, text), "name the columns in a first line")


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("", "holds no points"),
        ("name x y z\n", "holds no points"),
        ("Dear reader,\nthere are no points here.\n", "holds no points"),
        ("T1 1.5 2.5\nT2 3.5 4.5\n", "holds no points"),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "is not a text file"),
        (b"1.5 2.5 3.5\n" * 200000, r"too large for a list of points \(2 MB\)"),
        ("T1 1.5 2.5 3.5\nT2 1.5 2.5\n", "Line 2 of .* has 3 columns instead of 4"),
        ("T1 1.5 2.5\nT2 1.5 2.5 3.5\nT3 4.5 5.5 6.5\n", "Line 1 of .* is neither a point .* nor a header"),
        ("T1;1.5;2.5;3.5\nT2 1.5 2.5 3.5\n", "Line 2 of .* has 1 columns instead of 4"),
        ("T1 1.5 2.5 3.5\nT2;1.5;2.5;3.5\nT3;1.5;2.5;3.5\n", "Line 1 of .* is neither a point"),
        ("T 1 1.5 2.5 3.5\nT2 1.5 2.5 3.5\nT3 1.5 2.5 3.5\n", "Line 1 of .* has 5 columns instead of 4"),
        ("1.5 2.5 3.5 0.9\nT2 1.5 2.5 3.5 0.8\nT3 1.5 2.5 3.5 0.7\n", "Line 1 of .* has 4 columns"),
        ("# remark\nT1 1.5 2.5 3.5\nT2 1.5 O.5 3.5\n", "Line 3 of .* has 'O.5' where a number is expected"),
        ("T1 1.5 2.5 3.5\nT2 1.5 nan 3.5\n", "Line 2 of .* has 'nan' where"),
        ("T1 1.5 2.5 3.5\nT2 1.5 1e999 3.5\n", "Line 2 of .* has '1e999' where"),
        ("T1;1.5;2.5;3.5\n;4.5;5.5;6.5\n", "Line 2 of .* has no name"),
        (";1.5;2.5;3.5\nT2;4.5;5.5;6.5\nT3;4.5;5.5;6.5\n", "Line 1 of .* has no name"),
        ("name lat lon h\nT1 48.1 11.5 500\n", "geographic coordinates in degrees"),
        ("# Longitude;Latitude;Height\n11.5;48.1;500\n", "geographic coordinates in degrees"),
        ("Name;X [mm];Y [mm];Z [mm]\nT1;1500;2500;3500\n", "gives coordinates in mm; convert them"),
        ("a b c d\nT1 1.5 2.5 3.5\n", "does not name the 4 columns"),
        ("1 334.71 285.94\n2 563.67 519.34\n3 444.27 153.79\n", "x and y but no z; add the heights"),
        ("1,5,2,25,3,0\n4,5,5,25,6,5\n", "can be decimal signs or separators"),
        (
            "# a remark\nT1 1.5 2.5 3.5\nT2 4.5 5.5 6.5\n\nT1 1.5 2.5 3.6\n",
            "The name T1 stands for two points of .*, in line 2 and line 5; rename",
        ),
        ("7 1.5 2.5 3.5\n8 4.5 5.5 6.5\n7 1.5 2.5 3.6\n", "The name 7 stands for two points"),
    ],
)
def test_what_is_no_list_is_refused_in_one_sentence(tmp_path, content, sentence):
    refuse(write(tmp_path, content), sentence)


@pytest.mark.parametrize("name", ["missing.txt", "missing.gpkg", "folder/missing.shp"])
def test_a_missing_file_is_named(tmp_path, name):
    refuse(tmp_path / name, "cannot be read .*; check that it exists")


@pytest.mark.parametrize("sign", ["#", "# ", "//", ";", "; "])
@pytest.mark.parametrize("separator", [" ", ",", ";", "\t"])
@pytest.mark.parametrize("row", [["T2", "4.5", "5.5", "6.5"], ["4.5", "5.5", "6.5"]])
def test_a_point_may_be_struck_out(tmp_path, sign, separator, row):
    struck = sign + separator.join(row)
    others = [separator.join([*row[:-3], "1.5", "2.5", "3.5"])] * 2
    for lines in ([struck, *others], [*others, struck]):
        points = read_point_list(write(tmp_path, "\n".join(lines)))
        assert points.xyz.tolist()[0] == [1.5, 2.5, 3.5]
        assert len(points.xyz) == (1 if len(row) == 4 else 2)


def test_a_point_that_is_listed_twice_counts_once(tmp_path):
    points = read_point_list(write(tmp_path, "T1 1.5 2.5 3.5\nT2 4.5 5.5 6.5\nT1 1.5 2.5 3.50\n"))
    assert points.names == ("T1", "T2")
    assert len(points.xyz) == 2
    assert points.warnings[0].endswith("count once: T1.")


def test_places_without_names_may_repeat(tmp_path):
    points = read_point_list(write(tmp_path, "1.5 2.5 3.5\n1.5 2.5 3.5\n"))
    assert points.names == ("1", "2")


NAMES = st.lists(st.from_regex(r"[A-Z][a-z]{0,3}[0-9]{0,3}", fullmatch=True), unique=True)
NUMBERS = st.lists(st.integers(0, 10**6).map(str), unique=True)


@settings(deadline=None, max_examples=200)
@given(
    names=st.one_of(NAMES, NUMBERS, st.just([])),
    points=st.lists(st.tuples(*[st.integers(-(10**9), 10**9)] * 3), min_size=1, max_size=8),
    separator=st.sampled_from([" ", "   ", "\t", ";", ",", ", ", " ; "]),
    decimal=st.sampled_from([".", ","]),
    header=st.sampled_from([None, ("name", "x", "y", "z"), ("Nr", "Easting", "Northing", "Height")]),
    end=st.sampled_from(["\n", "\r\n"]),
    mark=st.booleans(),
)
def test_the_way_of_writing_changes_nothing(
    tmp_path_factory, names, points, separator, decimal, header, end, mark
):
    if "," in separator:
        decimal = "."
    points = points[: len(names)] if names else points
    rows = [[f"{value / 1000:.3f}".replace(".", decimal) for value in point] for point in points]
    if names:
        rows = [[name, *row] for name, row in zip(names, rows)]
    if header:
        rows = [list(header) if names else list(header[1:]), *rows]
    text = end.join(separator.join(row) for row in rows)
    path = write(tmp_path_factory.mktemp("text"), text.encode("utf-8-sig" if mark else "utf-8"))

    read = read_point_list(path)

    np.testing.assert_array_equal(read.xyz, np.array(points) / 1000)
    expected = names[: len(points)] if names else [str(row + 1) for row in range(len(points))]
    assert list(read.names) == expected
    assert read.named == bool(names)
    assert read.warnings == ()


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


def test_a_field_that_names_every_point_goes_before_one_that_does_not():
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
        ([((1, 2, 3), {"id": 0}), ((1, 2, 4), {"id": 0})], "The name 0 .* in feature 1 and feature 2"),
    ],
)
def test_features_that_are_no_list_are_refused(features, sentence):
    with pytest.raises(InputError, match=sentence):
        points_of_features("list", "the layer", features, "")


def test_what_only_looks_like_a_layer_is_refused(tmp_path):
    refuse(write(tmp_path, "T1 1 2 3\n", "a.shp"), "cannot be read as a layer")
    refuse(write_layer(tmp_path / "b.gpkg", [], geometry="Polygon"), "has no layer of points")


needs_data = pytest.mark.skipif(not DATA.exists(), reason="the shared test data are not here")


@needs_data
@pytest.mark.parametrize(
    ("file", "count", "names", "first"),
    [
        (
            "registration/grafarend_source.txt",
            7,
            ("Solitude", "BuochZeil"),
            [4157222.543, 664789.307, 4774952.099],
        ),
        ("registration/jag3d_third_target.txt", 4, ("1", "2"), [929.580, 422.800, -0.210]),
        ("control_points_eov_cc0/coo_list.csv", 161, ("base_1", "1"), [667568.278, 271801.865, 252.176]),
        ("control_points_eov_cc0/gcp.txt", 10, ("1", "2"), [133.101, 140.589, 83.295]),
        ("control_points_eov_cc0/totalstation.txt", 1389, ("1", "2"), [-97.4704, -175.0972, 5.3846]),
    ],
)
def test_published_lists(file, count, names, first):
    points = read_point_list(DATA / file)
    assert len(points.names) == len(points.xyz) == count
    assert points.names[:2] == names
    np.testing.assert_array_equal(points.xyz[0], first)
    assert len(points.warnings) == ("totalstation" in file)


@needs_data
def test_published_lists_without_heights_are_refused():
    refuse(DATA / "registration" / "levelled_source.txt", "x and y but no z")
