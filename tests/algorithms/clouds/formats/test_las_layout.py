"""A header that contradicts the length of its file is refused."""

import struct

import laspy
import pytest
from ichnograph.algorithms.clouds.formats.las_layout import count_warning, read_layout
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.algorithms.clouds.sample_files import las_records, write_copc, write_las


def layout(path):
    with path.open("rb") as stream:
        return read_layout(path, stream)


def changed(path, position, code, value):
    data = bytearray(path.read_bytes())
    struct.pack_into(code, data, position, value)
    path.write_bytes(data)
    return path


def test_the_layout_is_that_of_the_header(tmp_path):
    found = layout(write_las(tmp_path / "scan.las", *las_records(300)))
    assert (found.count, found.record_size, found.compressed) == (300, 34, False)
    assert found.start + 300 * 34 == found.size


def test_the_older_field_for_the_number_of_points_counts_if_the_newer_one_is_empty(tmp_path):
    header, points = las_records(300)
    header.version = laspy.header.Version(1, 4)
    path = write_las(tmp_path / "scan.las", header, points)
    changed(path, 107, "<I", 300)
    assert layout(changed(path, 247, "<Q", 0)).count == 300


def test_points_that_the_header_does_not_announce_are_counted_by_the_length_of_the_file(tmp_path):
    path = changed(write_las(tmp_path / "scan.las", *las_records(300)), 107, "<I", 0)
    assert layout(path).count == 300
    assert "announces no points; the 300 that follow it were read" in count_warning(path)[0]


@pytest.mark.parametrize(
    ("position", "code", "value", "problem"),
    [
        (0, "<4s", b"PNG ", "is not a LAS or LAZ file"),
        (24, "<B", 9, "there is no version 9"),
        (25, "<B", 6, "there is no version 1.6|ends within the header"),
        (100, "<I", 2**31, "announces more records than it has room for"),
        (96, "<I", 2**31, "announces more records than it has room for"),
        (105, "<H", 65300, "announces 65300 bytes a point"),
        (107, "<I", 301, "announces 301 points, but it ends before the last"),
    ],
)
def test_what_contradicts_the_file_is_refused(tmp_path, position, code, value, problem):
    path = write_las(tmp_path / "scan.las", *las_records(300))
    with pytest.raises(InputError, match=problem):
        layout(changed(path, position, code, value))


def test_a_record_after_the_points_that_is_longer_than_the_file_is_refused(tmp_path):
    path = write_copc(tmp_path / "scan.copc.laz", *las_records(300, 6), 3)
    start = struct.unpack_from("<Q", path.read_bytes(), 235)[0]
    assert layout(path).count == 300
    with pytest.raises(InputError, match="a record after its points announces more than there is"):
        layout(changed(path, start + 20, "<Q", 2**40))


@pytest.mark.parametrize("point_format", [0, 3, 4, 6, 9])
def test_points_behind_those_that_the_header_announces_are_said(tmp_path, point_format):
    header, points = las_records(300, point_format)
    if point_format >= 6:
        header.version = laspy.header.Version(1, 4)
    path = write_las(tmp_path / "scan.las", header, points)
    assert count_warning(path) == ()
    fields = [(107, "<I")] if point_format < 6 else [(247, "<Q")]
    for position, code in fields:
        changed(path, position, code, 280)
    assert "announces 280 points, but 20 more follow" in count_warning(path)[0]


@pytest.mark.parametrize(
    "more",
    [
        pytest.param(bytes(512), id="zeros"),
        pytest.param(bytes(34 * 3), id="zeros of the length of points"),
        pytest.param(b"\xff\x7f" * 17 * 3, id="far from all points"),
        pytest.param(b"end of the file" * 7, id="a rest"),
    ],
)
def test_bytes_that_fill_up_a_file_are_no_points(tmp_path, more):
    path = write_las(tmp_path / "scan.las", *las_records(300))
    path.write_bytes(path.read_bytes() + more)
    assert count_warning(path) == ()


def test_points_that_were_appended_beside_the_others_are_points(tmp_path):
    header, points = las_records(300)
    points.x[299] = 1.5 * points.x.max() - 0.5 * points.x.min()
    path = write_las(tmp_path / "scan.las", header, points)
    changed(path, 107, "<I", 299)
    changed(path, 179, "<d", points.x[:299].max())
    assert "1 more follow" in count_warning(path)[0]
