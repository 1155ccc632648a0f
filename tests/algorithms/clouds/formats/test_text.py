"""Every way in which programs write points as text, and every way to spoil it."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.formats.text import TextSource
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.progress import Progress

DATA = Path(__file__).parents[5] / "shared" / "data"

XYZ = [[1.5, 2.25, 3.0], [4.5, 5.25, 6.5], [-7.5, 8.0, 9.125]]


def write(tmp_path, text, name="scan.xyz"):
    path = tmp_path / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def read(path, size=1000):
    chunks = list(TextSource.open(path).chunks(np.zeros(3), Progress(), size))
    return (
        np.concatenate([chunk.xyz for chunk in chunks]),
        None if chunks[0].intensity is None else np.concatenate([c.intensity for c in chunks]),
        None if chunks[0].rgb is None else np.concatenate([c.rgb for c in chunks]),
    )


@pytest.mark.parametrize(
    "text",
    [
        "1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125\n",
        "1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125",
        "1.5 2.25 3.0\r\n4.5 5.25 6.5\r\n-7.5 8 9.125\r\n",
        "1.5 2.25 3.0\r4.5 5.25 6.5\r-7.5 8 9.125\r",
        "  1.5   2.25 \t 3.0  \n 4.5 5.25\t6.5\n-7.5 8 9.125  \n",
        "1.5,2.25,3.0\n4.5,5.25,6.5\n-7.5,8,9.125\n",
        "1.5, 2.25, 3.0\n4.5, 5.25, 6.5\n-7.5, 8, 9.125\n",
        "1.5, 2.25, 3.0, 161, 158, 182, 153\n4.5, 5.25, 6.5, 1, 2, 3, 4\n-7.5, 8, 9.125, 5, 6, 7, 8\n",
        "1.5 , 2.25 , 3.0 \n4.5 , 5.25 , 6.5 \n-7.5 , 8 , 9.125 \n",
        "1.5;2.25;3.0\n4.5;5.25;6.5\n-7.5;8;9.125\n",
        "1.5\t2.25\t3.0\n4.5\t5.25\t6.5\n-7.5\t8\t9.125\n",
        "1,5 2,25 3,0\n4,5 5,25 6,5\n-7,5 8 9,125\n",
        "1,5;2,25;3,0\n4,5;5,25;6,5\n-7,5;8;9,125\n",
        "1,5\t2,25\t3,0\n4,5\t5,25\t6,5\n-7,5\t8\t9,125\n",
        "1.5e0 2.25E+0 3\n.45e1 5.25 6.5\n-7.5 8. +9.125\n",
        '"1.5","2.25","3.0"\n"4.5","5.25","6.5"\n"-7.5","8","9.125"\n',
        "# a remark\n\n1.5 2.25 3.0\n// another\n4.5 5.25 6.5\n; and more\n\n-7.5 8 9.125\n\n",
        "Scan of the church\n1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125\n",
        "3\n1.5 2.25 3.0\n4.5 5.25 6.5\n-7.5 8 9.125\n",
    ],
)
def test_separators_decimals_and_remarks(tmp_path, text):
    np.testing.assert_array_equal(read(write(tmp_path, text))[0], XYZ)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_encodings(tmp_path, encoding):
    text = "# gemessen von Müller\n1.5 2.25 3\n4.5 5.25 6.5\n-7.5 8 9.125\n"
    np.testing.assert_array_equal(read(write(tmp_path, text.encode(encoding)))[0], XYZ)


@pytest.mark.parametrize(
    "text",
    [
        "X,Y,Z\n1.5,2.25,3\n",
        "x y z\n1.5 2.25 3\n",
        "//X Y Z\n1.5 2.25 3\n",
        "# z;y;x\n3;2.25;1.5\n",
        "Points:0,Points:1,Points:2\n1.5,2.25,3\n",
        "Easting [m];Northing [m];Height [m]\n1,5;2,25;3\n",
        "id,N,E,H\n7,2.25,1.5,3\n",
        "Name\tX\tY\tZ\nP 1\t1.5\t2.25\t3\n",
        '"x","y","z","class"\n1.5,2.25,3,wall\n',
        "class,nx,ny,nz,x,y,z\nwall,0,0,1,1.5,2.25,3\n",
        "x;y;z\n1.5;2.25;3;\n",
    ],
)
def test_a_header_names_the_columns(tmp_path, text):
    xyz, intensity, rgb = read(write(tmp_path, text))
    np.testing.assert_array_equal(xyz, [[1.5, 2.25, 3]])
    assert intensity is None
    assert rgb is None


def test_cloudcompare_header_with_colour_and_intensity(tmp_path):
    path = write(tmp_path, "//X,Y,Z,R,G,B,Scalar_Intensity\n1.5,2.25,3,255,0,1,900\n")
    xyz, intensity, rgb = read(path)
    np.testing.assert_array_equal(xyz, [[1.5, 2.25, 3]])
    np.testing.assert_array_equal(intensity, [900])
    np.testing.assert_array_equal(rgb, [[65535, 0, 257]])


def test_columns_without_a_header_are_recognised_by_their_number(tmp_path):
    four = read(write(tmp_path, "1.5 2.25 3 900\n"))
    six = read(write(tmp_path, "1.5 2.25 3 255 0 1\n"))
    seven = read(write(tmp_path, "1.5 2.25 3 900 255 0 1\n"))
    np.testing.assert_array_equal(four[1], [900])
    np.testing.assert_array_equal(six[2], [[65535, 0, 257]])
    np.testing.assert_array_equal(seven[1], [900])
    np.testing.assert_array_equal(seven[2], [[65535, 0, 257]])


def test_normals_are_not_taken_for_colour(tmp_path):
    path = write(tmp_path, "1.5 2.25 3 0 0 1\n1.5 2.25 3 0 1 0\n")
    assert read(path)[2] is None
    assert TextSource.open(path).layout.columns.normals == (3, 4, 5)


def test_normals_that_are_not_known_do_not_matter(tmp_path):
    path = write(tmp_path, "x y z nx ny nz\n1.5 2.5 3.5 nan nan nan\n4.5 5.5 6.5 0 0 1\n")
    np.testing.assert_array_equal(read(path)[0], [[1.5, 2.5, 3.5], [4.5, 5.5, 6.5]])


@pytest.mark.parametrize("lost", ["nan nan nan", "4.5 NaN 6.5", "inf 1 2", "-1.#IND 0 0"])
def test_rows_that_a_program_wrote_without_coordinates_are_passed_over(tmp_path, lost):
    path = write(tmp_path, f"1.5 2.5 3.5\n{lost}\n4.5 5.5 6.5\n")
    np.testing.assert_array_equal(read(path)[0], [[1.5, 2.5, 3.5], [4.5, 5.5, 6.5]])


def test_an_intensity_that_is_not_known_is_0(tmp_path):
    path = write(tmp_path, "1.5 2.5 3.5 900\n4.5 5.5 6.5 nan\n")
    np.testing.assert_array_equal(read(path)[1], [900, 0])


def test_units_of_the_header_are_converted(tmp_path):
    path = write(tmp_path, "X [mm],Y [mm],Z [mm]\n1500.5,2500,3500\n")
    np.testing.assert_allclose(read(path)[0], [[1.5005, 2.5, 3.5]])
    assert "in mm; they were converted" in TextSource.open(path).warnings[0]


@pytest.mark.parametrize("header", ["# m\n", "x[m] y[m] z[m]\n"])
def test_whole_numbers_of_a_stated_unit_are_not_doubted(tmp_path, header):
    whole = "100 200 3\n900 400 5\n100 800 3\n"
    assert "are whole numbers" in TextSource.open(write(tmp_path, whole)).warnings[0]
    assert TextSource.open(write(tmp_path, header + whole)).warnings == ()


def test_colours_of_16_bits_are_recognised_though_the_file_begins_dark(tmp_path):
    dark, bright = "1.5 2.5 3.5 200 200 200\n" * 20_000, "1.5 2.5 3.5 40000 200 200\n" * 10
    _, _, rgb = read(write(tmp_path, dark + bright), 100_000)
    np.testing.assert_array_equal(rgb[[0, -1]], [[200, 200, 200], [40000, 200, 200]])


def test_a_quoted_field_may_hold_the_separator(tmp_path):
    path = write(tmp_path, 'class,x,y,z\n"wall, north",1.5,2.5,3.5\n"roof",4.5,5.5,6.5\n')
    np.testing.assert_array_equal(read(path)[0], [[1.5, 2.5, 3.5], [4.5, 5.5, 6.5]])


def test_separators_of_thousands_do_not_belong_to_the_numbers(tmp_path):
    path = write(tmp_path, "x;y;z\n691.234,125;5.334.567,397;512,276\n691.235,125;5.334.568,397;512,276\n")
    np.testing.assert_array_equal(read(path)[0][0], [691234.125, 5334567.397, 512.276])


def test_text_in_utf_16_that_is_cut_off_is_refused(tmp_path):
    path = write(tmp_path, "1.5 2.5 3.5\n1.5 2.5 3.5\n".encode("utf-16")[:-1])
    with pytest.raises(InputError, match="cannot be read as text in UTF-16 because it is cut off"):
        read(path)


def test_a_number_cut_off_at_the_end_is_refused(tmp_path):
    path = write(tmp_path, "1.5 2.5 71.25\n2.5 2.5 71.25\n3.5 2.5 7")
    with pytest.raises(InputError, match=r"truncated .the number at the end of its last line 3 is cut off"):
        read(path)


def test_leading_names_and_numbers_of_points_are_not_coordinates(tmp_path):
    named = "base_1,667568.278,271801.865,252.176\n1,655738.628,257962.892,117.020\n"
    numbered = "1 1.5 2.25 3.5\n2 4.5 5.25 6.5\n"
    np.testing.assert_array_equal(read(write(tmp_path, named))[0][0], [667568.278, 271801.865, 252.176])
    np.testing.assert_array_equal(read(write(tmp_path, numbered))[0][0], [1.5, 2.25, 3.5])


def test_a_grid_of_whole_coordinates_keeps_its_first_column(tmp_path):
    text = "".join(f"{x} {y}.5 3.25 0.5\n" for y in range(3) for x in range(3))
    np.testing.assert_array_equal(read(write(tmp_path, text))[0][:3, 0], [0, 1, 2])


@pytest.mark.parametrize(
    ("values", "expected"),
    [("0 255 128", [0, 65535, 32896]), ("0 0.5 1", [0, 32768, 65535]), ("0 300 65535", [0, 300, 65535])],
)
def test_colour_is_brought_to_16_bits(tmp_path, values, expected):
    np.testing.assert_array_equal(read(write(tmp_path, f"x y z r g b\n1 2 3 {values}\n"))[2], [expected])


def test_pts_intensity_is_brought_to_16_bits(tmp_path):
    path = write(tmp_path, "3\n1 2 3 -2048\n1 2 3 0\n1 2 3 2047\n", "scan.pts")
    np.testing.assert_array_equal(read(path)[1], [0, 32776, 65535])


def test_pts_with_several_scans(tmp_path):
    path = write(tmp_path, "2\n1 2 3 5\n4 5 6 5\n1\n7 8 9 5\n", "scan.PTS")
    np.testing.assert_array_equal(read(path)[0], [[1, 2, 3], [4, 5, 6], [7, 8, 9]])
    np.testing.assert_array_equal(read(path, size=1)[0], [[1, 2, 3], [4, 5, 6], [7, 8, 9]])


@pytest.mark.parametrize("text", ["3\n1 2 3\n4 5 6\n", "1\n1 2 3\n2\n4 5 6\n"])
def test_pts_with_fewer_points_than_announced_is_truncated(tmp_path, text):
    with pytest.raises(InputError, match=r"scan\.pts is truncated \(it announces 3 points and holds 2\)"):
        read(write(tmp_path, text, "scan.pts"))


@pytest.mark.parametrize("size", [1, 2, 1000])
@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ("4.5 5.25", "has 2 columns instead of 3"),
        ("4.5 5.25 6.5 7.5", "has 4 columns instead of 3"),
        ("4.5 abc 6.5", "has 'abc' where a number is expected"),
        ("4.5 1e999 6.5", "has '1e999' where a number is expected"),
        ("12", "has 1 columns instead of 3"),
    ],
)
def test_a_bad_line_is_named(tmp_path, size, line, problem):
    path = write(tmp_path, f"# remark\n1 2 3\n1 2 3\n{line}\n1 2 3\n1 2 3\n")
    with pytest.raises(InputError, match=f"Line 4 of .*scan.xyz {problem}"):
        read(path, size)


@pytest.mark.parametrize("separator", [" ", ",", ";", "\t"])
def test_a_short_line_beyond_the_examined_beginning_is_named(tmp_path, separator):
    rows = [separator.join(["1.5", "2.5", "3.5", "900"])] * 20000
    rows[15000] = separator.join(["1.5", "2.5", "3.5"])
    with pytest.raises(InputError, match=r"Line 15001 of .*scan\.xyz has 3 columns instead of 4"):
        read(write(tmp_path, "\n".join(rows) + "\n"), size=7000)


def test_a_last_line_that_is_cut_off_is_truncation(tmp_path):
    with pytest.raises(InputError, match=r"is truncated \(its last line 3 is cut off\)"):
        read(write(tmp_path, "1 2 3\n4 5 6\n7 8"))


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "is not a text file"),
        ("", "holds no points"),
        ("x y z\n", "holds no points"),
        ("Dear reader,\nthere are no points here.\n", "holds no points"),
        ("1.5 2.5\n3.5 4.5\n", "holds no points"),
        ("ncols 4\nnrows 4\n1 2 3 4\n1 2 3 4\n", "is a raster grid"),
        ("1,5,2,25,3,0\n4,5,5,25,6,5\n", "can be decimal signs or separators"),
        ("1,5;2.25;3,0\n", "can be decimal signs or separators"),
        ("lon lat h\n11.5 48.1 500\n", "geographic coordinates in degrees"),
        ("a b c\n1 2 3\n", "does not name the 3 columns"),
        ("x y z\n1 2 3 4\n1 2 3 4\n", "does not name the 4 columns"),
        ("1 2\n1 2 3\n1 2 3\n", "has 2 columns in line 1 where most lines have 3"),
        ("nan nan nan\n", "coordinates that are not numbers"),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_sentence(tmp_path, content, sentence):
    path = write(tmp_path, content)
    with pytest.raises(InputError, match=sentence) as error:
        read(path)
    assert str(path) in str(error.value)
    assert "\n" not in str(error.value)


def test_progress_ends_at_one(tmp_path):
    path = write(tmp_path, "1 2 3\n" * 10)
    reported = []
    progress = Progress(report=lambda fraction, message: reported.append(fraction))
    list(TextSource.open(path).chunks(np.zeros(3), progress, 4))
    assert reported[-1] == 1.0


@settings(deadline=None, max_examples=50)
@given(
    points=st.lists(st.tuples(*[st.integers(-(10**9), 10**9)] * 3), min_size=1, max_size=20),
    separator=st.sampled_from([" ", ";", "\t", ","]),
    size=st.integers(1, 7),
)
def test_any_millimetres_come_back_exactly_however_they_are_chunked(
    tmp_path_factory, points, separator, size
):
    rows = [[f"{value / 1000:.3f}" for value in point] for point in points]
    path = tmp_path_factory.mktemp("text") / "scan.txt"
    path.write_text("".join(separator.join(row) + "\n" for row in rows))
    xyz = read(path, size)[0]
    np.testing.assert_allclose(xyz, np.array(points) / 1000, rtol=1e-15, atol=0)


@pytest.mark.skipif(not DATA.exists(), reason="the shared test data are not here")
@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("rooms_pcl_scan_pair/room_scan1.xyz", 112586),
        ("cornice_pcl_region_growing/cornice.xyz", 108104),
        ("format_ptx_pts_pdal/autzen.pts", 10),
        ("format_ptx_pts_pdal/bunny_8.pts", 9),
        ("format_ptx_pts_pdal/site_56_8.pts", 8),
        ("format_ptx_pts_pdal/test.pts", 19),
        ("control_points_eov_cc0/coo_list.csv", 161),
        ("control_points_eov_cc0/gcp.txt", 10),
        ("control_points_eov_cc0/totalstation.txt", 1389),
    ],
)
def test_files_of_other_programs(name, count):
    assert len(read(DATA / name)[0]) == count


def test_colour_that_begins_in_the_dark_is_colour(tmp_path):
    rows = "".join(f"{n % 97}.25 {n % 89}.5 {n % 7}.75 0 0 0\n" for n in range(5000))
    colour = "".join(f"{n % 97}.25 {n % 89}.5 {n % 7}.75 200 10 30\n" for n in range(500))
    assert read(write(tmp_path, rows + colour))[2][-1].tolist() == [200 * 257, 10 * 257, 30 * 257]
