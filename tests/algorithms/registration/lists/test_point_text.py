"""Every way in which people write lists of points as text, and every way to spoil them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.registration.lists.point_list import read_point_list
from ichnograph.tests.algorithms.registration.lists.written_lists import XYZ, refuse, write


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
        ('Name,X,Y,Z\n"wall 1, north",1.5,2.25,3\n"wall 2",4.5,5.25,6.5\n', ("wall 1, north", "wall 2")),
        ("Point,X,Y,Z\n101,1.5,2.25,3\n,,,\n102,4.5,5.25,6.5\n,,,\n", ("101", "102")),
        ("Punto;Este;Norte;Cota\n101;1,5;2,25;3\n102;4,5;5,25;6,5\n", ("101", "102")),
        ("Repère;Est;Nord;Altitude\n101;1,5;2,25;3\n102;4,5;5,25;6,5\n", ("101", "102")),
        ("TargetID X Y Z\n101 1.5 2.25 3\n102 4.5 5.25 6.5\n", ("101", "102")),
        ("Vermarkung X Y Z\n101 1.5 2.25 3\n102 4.5 5.25 6.5\n", ("101", "102")),
        ("sep=,\nName,X,Y,Z\n101,1.5,2.25,3\n102,4.5,5.25,6.5\n", ("101", "102")),
        ("Name|X|Y|Z\n101|1.5|2.25|3\n102|4.5|5.25|6.5\n", ("101", "102")),
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
        ("Name;X [ft];Y [ft];Z [ft]\nT1;1500;2500;3500\n", "gives lengths in ft; convert them"),
        ("T1 1.5 2.25 3.125\nT2 1.5 2.25 3.125\nT3 4.5 5.5 6", "Line 3 of .*, the last, is cut off"),
        ("\ufeff1.5 2.5 3.5\n".encode("utf-16-le")[:-1], "cannot be read as text in UTF-16"),
        ("a b c d\nT1 1.5 2.5 3.5\n", "does not name the 4 columns"),
        ("1 334.71 285.94\n2 563.67 519.34\n3 444.27 153.79\n", "x and y but no z; add the heights"),
        ("1,5,2,25,3,0\n4,5,5,25,6,5\n", "can be decimal signs or separators"),
        (
            "# a remark\nT1 1.5 2.5 3.5\nT2 4.5 5.5 6.5\n\nT1 1.5 2.5 3.6\n",
            "Two points of .* are called T1, in line 2 and line 5; rename",
        ),
        ("7 1.5 2.5 3.5\n8 4.5 5.5 6.5\n7 1.5 2.5 3.6\n", "Two points of .* are called 7, in"),
    ],
)
def test_what_is_no_list_is_refused_in_one_sentence(tmp_path, content, sentence):
    refuse(write(tmp_path, content), sentence)


def test_a_cloud_that_was_chosen_by_mistake_is_recognised_by_its_number_of_points(tmp_path):
    refuse(write(tmp_path, "1.5 2.5 3.5\n" * 40_001), "has 40001 lines, too many for a list of points")


def test_separators_of_thousands_do_not_belong_to_the_numbers(tmp_path):
    rows = "1;691.234,125;5.334.567,397;512,276\n2;691.252,025;5.334.568,9;513\n"
    text = f"Punkt;Rechtswert;Hochwert;Hoehe\n{rows}"
    points = read_point_list(write(tmp_path, text))
    np.testing.assert_array_equal(points.xyz[:, 1], [5334567.397, 5334568.9])


def test_units_in_the_header_are_converted_and_said(tmp_path):
    points = read_point_list(write(tmp_path, "Name;X [mm];Y [mm];Z [mm]\nT1;1500;2250;3500\n"))
    np.testing.assert_allclose(points.xyz, [[1.5, 2.25, 3.5]])
    assert "gives coordinates in mm; they were converted to metres" in points.warnings[0]


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


NAMES = st.lists(st.from_regex(r"[A-Z][a-z]{0,3}[0-9]{0,3}", fullmatch=True), unique=True)
NUMBERS = st.lists(st.integers(0, 10**6).map(str), unique=True)
MILLIMETRES = st.integers(-(10**5), 10**9)


@settings(deadline=None, max_examples=200)
@given(
    names=st.one_of(NAMES, NUMBERS, st.just([])),
    # Heights that are all 0 are doubted.
    points=st.lists(st.tuples(MILLIMETRES, MILLIMETRES, MILLIMETRES.filter(bool)), min_size=1, max_size=8),
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
    assert not [text for text in read.warnings if "whole numbers" not in text]


@pytest.mark.parametrize("header", ["# m\n", "name x[m] y[m] z[m]\n", "# in mm\n"])
def test_whole_numbers_of_a_stated_unit_are_not_doubted(tmp_path, header):
    whole = "T1 100000 200000 3000\nT2 900000 400000 5000\nT3 100000 800000 3000\n"
    assert "whole numbers" in read_point_list(write(tmp_path, whole)).warnings[0]
    said = read_point_list(write(tmp_path, header + whole)).warnings
    assert not [text for text in said if "whole numbers" in text]


@pytest.mark.parametrize("row", ["#1 9.5 8.25 7", "# P9 9.5 8.25 7", ";P9 9.5 8.25 7"])
def test_rows_that_begin_as_remarks_do_are_left_out_and_said(tmp_path, row):
    points = read_point_list(write(tmp_path, f"{row}\nT1 1.5 2.25 3.0\nT2 4.5 5.25 6.5\n"))
    assert points.names == ("T1", "T2")
    assert "1 rows of" in points.warnings[0]
    assert "the first in line 1, begin as remarks do" in points.warnings[0]


def test_heights_that_are_all_0_are_said(tmp_path):
    path = tmp_path / "list.txt"
    path.write_text("A 1.5 2.5 0\nB 4.5 3.5 0.000\n")
    assert any("All heights in" in warning for warning in read_point_list(path).warnings)
    path.write_text("A 1.5 2.5 0\nB 4.5 3.5 0.5\n")
    assert not any("All heights in" in warning for warning in read_point_list(path).warnings)
