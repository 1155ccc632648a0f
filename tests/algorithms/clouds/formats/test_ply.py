"""PLY as programs write it, and every way to spoil it."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.formats.ply import PlySource, _sample
from ichnograph.algorithms.clouds.formats.ply_header import read_layout
from ichnograph.algorithms.clouds.settings import ReadingSettings
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_ply

DATA = Path(__file__).parents[5] / "shared" / "data"

XYZ = np.array([[1.5, 2.25, 3.0], [4.5, 5.25, 6.5], [-7.5, 8.0, 9.125]])
ENCODINGS = ["ascii", "binary_little_endian", "binary_big_endian"]


def vertices(**columns):
    columns = {**dict(zip("xyz", XYZ.T)), **{name: np.asarray(values) for name, values in columns.items()}}
    return np.rec.fromarrays(list(columns.values()), names=",".join(columns))


def read(path, size=1000):
    chunks = list(PlySource.open(path).chunks(np.zeros(3), Progress(), size))
    return (
        np.concatenate([chunk.xyz for chunk in chunks]),
        None if chunks[0].intensity is None else np.concatenate([c.intensity for c in chunks]),
        None if chunks[0].rgb is None else np.concatenate([c.rgb for c in chunks]),
        {name: np.concatenate([c.attributes[name] for c in chunks]) for name in chunks[0].attributes},
    )


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("kind", ["float", "double", "float32", "float64"])
def test_coordinates_of_either_precision_and_any_encoding(tmp_path, encoding, kind):
    number = np.float32 if "32" in kind or kind == "float" else np.float64
    points = np.rec.fromarrays(XYZ.T.astype(number), names="x,y,z")
    path = write_ply(tmp_path / "a.ply", points, encoding, types=[kind] * 3)
    xyz, intensity, rgb, attributes = read(path)
    np.testing.assert_array_equal(xyz, XYZ)
    assert (intensity, rgb, attributes) == (None, None, {})


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_what_else_the_vertices_have_is_kept(tmp_path, encoding):
    points = vertices(
        nx=np.float32([0, 0.5, 1]), scalar_Deviation=np.float32([1, np.nan, -1]), alpha=np.uint8([1, 2, 255])
    )
    types = ["double"] * 3 + ["float", "float", "uchar"]
    *_, attributes = read(write_ply(tmp_path / "a.ply", points, encoding, types))
    assert {name: values.dtype.itemsize for name, values in attributes.items()} == {
        "nx": 4,
        "scalar_Deviation": 4,
        "alpha": 1,
    }
    for name, values in attributes.items():
        np.testing.assert_array_equal(values, points[name])


@pytest.mark.parametrize(
    ("values", "kind", "expected"),
    [
        (np.uint8([[255, 0, 1]] * 3), "uchar", [65535, 0, 257]),
        (np.uint8([[1, 0, 1]] * 3), "uint8", [257, 0, 257]),
        (np.uint16([[255, 0, 1]] * 3), "ushort", [65535, 0, 257]),
        (np.uint16([[256, 0, 1]] * 3), "ushort", [256, 0, 1]),
        (np.float32([[1, 0, 0.5]] * 3), "float", [65535, 0, 32768]),
        (np.float32([[255, 0, 1]] * 3), "float", [65535, 0, 257]),
    ],
)
@pytest.mark.parametrize(
    "names", [("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue")]
)
def test_colour_is_brought_to_16_bits(tmp_path, values, kind, expected, names):
    points = vertices(**dict(zip(names, values.T)))
    path = write_ply(tmp_path / "a.ply", points, types=["double"] * 3 + [kind] * 3)
    np.testing.assert_array_equal(read(path)[2], [expected] * 3)


def test_properties_may_be_written_in_capitals(tmp_path):
    path = write_ply(tmp_path / "a.ply", XYZ, "ascii")
    for name in "xyz":
        path.write_text(path.read_text().replace(f"double {name}", f"double {name.upper()}"))
    np.testing.assert_array_equal(read(path)[0], XYZ)
    assert read(path)[3] == {}


def test_single_precision_at_national_coordinates_is_said(tmp_path):
    points = np.random.default_rng(0).random((100, 3)) + [412345, 5812345, 71]
    single = np.rec.fromarrays(points.T.astype(np.float32), names="x,y,z")
    path = write_ply(tmp_path / "a.ply", single, types=["float"] * 3)
    (warning,) = PlySource.open(path).warnings
    assert "single precision, so they lie in steps of 0.031 m in x, 0.5 m in y" in warning


def test_the_range_of_the_colours_is_found_all_over_the_file(tmp_path):
    rgb = np.full((120_000, 3), 200, np.uint16)
    rgb[60_000:] = 40_000
    xyz = np.random.default_rng(0).random((len(rgb), 3))
    points = np.rec.fromarrays([*xyz.T, *rgb.T], names="x,y,z,red,green,blue")
    path = write_ply(tmp_path / "a.ply", points, types=["double"] * 3 + ["ushort"] * 3)
    assert PlySource.open(path).rgb_factor == 1.0


@pytest.mark.parametrize("name", ["intensity", "scalar_intensity", "scalar_Intensity", "reflectance"])
def test_intensity_is_brought_to_16_bits(tmp_path, name):
    path = write_ply(tmp_path / "a.ply", vertices(**{name: [0.0, 0.5, 1.0]}))
    _, intensity, _, attributes = read(path)
    np.testing.assert_array_equal(intensity, [0, 32768, 65535])
    assert attributes == {}


def test_vertices_that_are_not_numbers_are_left_out(tmp_path):
    xyz = np.vstack([np.full((20_000, 3), np.nan), XYZ])
    path = write_ply(tmp_path / "a.ply", xyz)
    np.testing.assert_array_equal(read(path)[0], XYZ)
    np.testing.assert_array_equal(PlySource.open(path).middle, np.median(XYZ, axis=0))


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_faces_behind_the_vertices_do_not_matter(tmp_path, encoding):
    faces = "element face 2\nproperty list uchar int vertex_indices\n"
    path = write_ply(tmp_path / "a.ply", XYZ, encoding, after=faces)
    with path.open("ab") as stream:
        stream.write(b"3 0 1 2\n3 0 1 2\n")
    np.testing.assert_array_equal(read(path)[0], XYZ)


def test_elements_before_the_vertices_are_passed_over(tmp_path):
    camera = "element camera 2\nproperty double f\nproperty uchar n\n"
    path = write_ply(tmp_path / "a.ply", XYZ, before=camera)
    head, points = path.read_bytes().split(b"end_header\n")
    path.write_bytes(head + b"end_header\n" + bytes(18) + points)
    np.testing.assert_array_equal(read(path)[0], XYZ)
    path = write_ply(tmp_path / "b.ply", XYZ, "ascii", before=camera)
    path.write_text(path.read_text().replace("end_header\n", "end_header\n1.5 2\n2.5 3\n"))
    np.testing.assert_array_equal(read(path)[0], XYZ)


def test_line_ends_of_windows(tmp_path):
    path = write_ply(tmp_path / "a.ply", XYZ, "ascii")
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    np.testing.assert_array_equal(read(path)[0], XYZ)


@settings(deadline=None, max_examples=20)
@given(size=st.integers(1, 30), encoding=st.sampled_from(ENCODINGS))
def test_chunks_do_not_change_a_bit(tmp_path_factory, size, encoding):
    xyz = np.random.default_rng(1).uniform(-30, 30, (25, 3))
    path = write_ply(tmp_path_factory.mktemp("ply") / "a.ply", xyz, encoding)
    np.testing.assert_array_equal(read(path, size)[0], read(path)[0])


@pytest.mark.parametrize(
    ("encoding", "old", "new", "sentence"),
    [
        ("ascii", "ply\n", "plywood\n", "is not a PLY file"),
        ("ascii", "end_header\n", "", "is not a PLY file"),
        ("ascii", "format ascii", "format morse", "of an unknown encoding"),
        ("ascii", "vertex 3", "vertex many", "has a header that cannot be read"),
        ("ascii", "vertex 3", "vertex 0", "holds no points"),
        ("ascii", "vertex 3", "corner 3", "holds no points"),
        ("ascii", "vertex 3", "vertex 4", "announces 4 points and has 3"),
        ("binary_little_endian", "vertex 3", "vertex 4", "announces 4 points and has 3"),
        ("ascii", "double z", "double up", "has vertices without x, y and z"),
        ("ascii", "double z", "double y", "the property double y"),
        ("ascii", "double z", "list uchar int z", "the property list uchar int z"),
        ("ascii", "6.5", "six", "Line 10 of .* holds something that is not a number"),
        ("ascii", " 6.5", "", "Line 10 of .* has 2 numbers instead of 3"),
        ("ascii", " 6.5", " 6.5 7", "Line 10 of .* has 4 numbers instead of 3"),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_sentence(tmp_path, encoding, old, new, sentence):
    path = write_ply(tmp_path / "a.ply", XYZ, encoding)
    path.write_bytes(path.read_bytes().replace(old.encode(), new.encode()))
    with pytest.raises(InputError, match=sentence) as caught:
        read(path)
    assert str(path) in str(caught.value)


def test_a_file_of_another_program():
    path = DATA / "registration" / "teaser_1" / "src.ply"
    if not path.exists():
        pytest.skip("the shared data are not here")
    xyz, *_ = read(path)
    assert len(xyz) == 10
    np.testing.assert_allclose(xyz[0], [0, 0.340289771402993, 0.125195115981903], atol=1e-7)


def test_colours_of_signed_bytes_are_those_of_the_same_bits(tmp_path):
    colour = np.int8([-1, 0, -128])
    points = vertices(red=colour, green=colour, blue=colour)
    rgb = read(write_ply(tmp_path / "a.ply", points, types=["double"] * 3 + ["char"] * 3))[2]
    np.testing.assert_array_equal(rgb[:, 0], np.array([255, 0, 128]) * 257)


@pytest.mark.parametrize("remark", ["comment units: mm\n", "obj_info Unit = millimetre\n"])
def test_a_unit_in_a_remark_is_honoured_and_said(tmp_path, remark):
    path = write_ply(tmp_path / "a.ply", 1000 * XYZ, before=remark)
    np.testing.assert_allclose(read(path)[0], XYZ, atol=1e-12)
    source = PlySource.open(path)
    np.testing.assert_allclose(source.middle, np.median(XYZ, axis=0))
    assert "they were converted to metres" in source.warnings[0]


def test_whole_numbers_of_a_stated_unit_are_not_doubted(tmp_path):
    whole = np.round(100 * XYZ)
    assert "are whole numbers" in PlySource.open(write_ply(tmp_path / "a.ply", whole)).warnings[0]
    stated = write_ply(tmp_path / "a.ply", whole, before="comment units: m\n")
    assert PlySource.open(stated).warnings == ()


def test_feet_in_a_remark_are_refused(tmp_path):
    with pytest.raises(InputError, match="gives lengths in feet"):
        read(write_ply(tmp_path / "a.ply", XYZ, before="comment units: feet\n"))


def test_decimals_in_a_property_of_whole_numbers_are_refused(tmp_path):
    path = write_ply(tmp_path / "a.ply", vertices(red=[0.5, 1.0, 0.25]), "ascii", ["double"] * 3 + ["uchar"])
    with pytest.raises(InputError, match="property red with decimals"):
        read(path)


@pytest.mark.parametrize("name", ["Amplitude", "scalar_Reflectance", "Intensity"])
def test_intensity_has_the_names_of_the_other_formats(tmp_path, name):
    assert PlySource.open(write_ply(tmp_path / "a.ply", vertices(**{name: [0.5, 1, 0]}))).intensity == name


@pytest.mark.parametrize("encoding", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_points_behind_those_that_the_header_announces_are_said(tmp_path, encoding):
    path = write_ply(tmp_path / "a.ply", np.random.default_rng(0).random((9, 3)), encoding)
    assert PlySource.open(path).warnings == ()
    path.write_bytes(path.read_bytes().replace(b"element vertex 9", b"element vertex 7"))

    assert "announces 7 points, but more follow" in PlySource.open(path).warnings[0]


def test_faces_behind_the_vertices_are_no_points(tmp_path):
    faces = "element face 1\nproperty list uchar int vertex_indices\n"
    path = write_ply(tmp_path / "a.ply", np.random.default_rng(0).random((9, 3)), "ascii", after=faces)
    path.write_bytes(path.read_bytes() + b"3 0 1 2\n")

    assert PlySource.open(path).warnings == ()


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_a_large_file_is_examined_by_points_from_all_over_it(tmp_path, encoding):
    xyz = np.random.default_rng(0).random((1200, 3))
    xyz[600:] += 100
    camera = "element camera 2\nproperty uchar n\n" if encoding == "ascii" else ""
    path = write_ply(tmp_path / "a.ply", xyz, encoding, before=camera)
    path.write_bytes(
        path.read_bytes().replace(b"end_header\n", b"end_header\n" + (b"1\n2\n" if camera else b""))
    )
    few = ReadingSettings(whole_points=100, runs=4, run_points=10)
    sample = _sample(path, read_layout(path), few)

    assert len(np.unique(sample["x"])) == 40
    assert set(sample["x"] > 50) == {False, True}
    np.testing.assert_allclose(read(path)[0], xyz, rtol=1e-12)


def test_a_shift_in_a_remark_is_said(tmp_path):
    path = write_ply(tmp_path / "a.ply", XYZ, before="obj_info shift 412345.6 5812345.7 0\n")
    assert "says 'shift 412345.6 5812345.7 0', which is not applied" in PlySource.open(path).warnings[0]
