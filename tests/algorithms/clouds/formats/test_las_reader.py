"""Damaged LAS files are refused by name, whatever the damage."""

import struct

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.las_reader import (
    EVERYTHING,
    Selection,
    can_seek,
    open_reader,
    read_records,
    seek,
    surplus_points,
)
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.algorithms.clouds.sample_files import las_records, table_of, write_las


def read(path, size=1000):
    """Return all records of a file."""
    with open_reader(path) as reader:
        count = reader.header.point_count
        return np.concatenate(
            [read_records(path, reader, min(size, count - start)) for start in range(0, count, size)]
        )


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
def test_the_records_are_those_written_and_can_be_sought(tmp_path, name):
    header, points = las_records(2500)
    path = write_las(tmp_path / name, header, points)
    assert read(path).tobytes() == points.array.tobytes()
    with open_reader(path) as reader:
        seek(path, reader, 2490)
        assert read_records(path, reader, 10)["X"].tolist() == points["X"][2490:].tolist()
        with pytest.raises(InputError, match="ends before its last point"):
            read_records(path, reader, 1)
        assert can_seek(reader)


def test_selected_dimensions_are_read(tmp_path):
    header, points = las_records(100, 6)
    path = write_las(tmp_path / "scan.laz", header, points)
    with open_reader(path, Selection.base() | Selection.Z) as reader:
        found = read_records(path, reader, 100)
    assert found["Z"].tolist() == points["Z"].tolist()
    with open_reader(path, EVERYTHING) as reader:
        assert read_records(path, reader, 100)["intensity"].tolist() == points["intensity"].tolist()


@pytest.mark.parametrize("point_format", [3, 6])
@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
@pytest.mark.parametrize("left", [1, 3, 4, 100, 226, 300, 0.1, 0.5, 0.9, -50, "last point"])
def test_a_truncated_file_is_an_input_error(tmp_path, name, point_format, left):
    path = write_las(tmp_path / name, *las_records(60_000, point_format))
    data = path.read_bytes()
    if left == "last point":
        left = -1 if name.endswith("las") else table_of(data) - len(data) - 1
    path.write_bytes(data[: int(left * len(data)) if isinstance(left, float) else left])
    with pytest.raises(InputError) as error:
        read(path)
    assert str(path) in str(error.value)
    assert "\n" not in str(error.value)


def test_damage_within_the_compressed_points_never_escapes_as_another_error(tmp_path):
    path = write_las(tmp_path / "scan.laz", *las_records(2000))
    data = path.read_bytes()
    for position in [*range(94, 460, 3), *range(460, len(data), len(data) // 60)]:
        path.write_bytes(data[:position] + b"\xff\x7f\xff\x7f" + data[position + 4 :])
        try:
            read(path, 500)
        except InputError as error:
            assert str(path) in str(error)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"\x89PNG\r\n\x1a\n" + bytes(500), "is not a LAS or LAZ file"),
        (b"LASF" + bytes(96), "is truncated or damaged"),
    ],
)
def test_another_content_is_refused(tmp_path, content, sentence):
    (tmp_path / "scan.las").write_bytes(content)
    with pytest.raises(InputError, match=f"scan.las {sentence}"):
        read(tmp_path / "scan.las")


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
def test_a_file_without_points_is_refused(tmp_path, name):
    path = write_las(tmp_path / name, *las_records(0))
    with pytest.raises(InputError, match="holds no points"):
        read(path)


def test_points_in_the_chunks_of_a_laz_that_its_header_does_not_announce_are_said(tmp_path):
    newer = write_las(tmp_path / "newer.laz", *las_records(300, 6))
    older = write_las(tmp_path / "older.laz", *las_records(50_300))
    assert surplus_points(newer) == surplus_points(older) == ()
    for path, position, code, count in ((newer, 247, "<Q", 280), (older, 107, "<I", 49_000)):
        data = bytearray(path.read_bytes())
        struct.pack_into(code, data, position, count)
        path.write_bytes(data)

    assert "announces 280 points, but 20 more follow" in surplus_points(newer)[0]
    # How many the last of the older chunks holds is not written anywhere.
    assert "announces 49000 points, but 1001 more follow" in surplus_points(older)[0]
