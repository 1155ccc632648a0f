"""Damaged LAS files are refused by name, whatever the damage."""

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.las_reader import (
    EVERYTHING,
    Selection,
    has_chunks_of_any_size,
    open_reader,
    read_records,
    seek,
)
from ichnograph.algorithms.errors import InputError


def records(count, point_format=3):
    """Return a header and points with random coordinates and intensity."""
    rng = np.random.default_rng(0)
    header = laspy.LasHeader(point_format=point_format)
    header.scales = np.full(3, 0.001)
    points = laspy.ScaleAwarePointRecord.zeros(count, header=header)
    for name in "XYZ":
        points[name] = rng.integers(-100_000, 100_000, count)
    points["intensity"] = rng.integers(1, 65535, count)
    return header, points


def write(path, header, points):
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(points)
    return path


def read(path, size=1000):
    """Return all records of a file."""
    with open_reader(path) as reader:
        count = reader.header.point_count
        return np.concatenate(
            [read_records(path, reader, min(size, count - start)) for start in range(0, count, size)]
        )


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
def test_the_records_are_those_written_and_can_be_sought(tmp_path, name):
    header, points = records(2500)
    path = write(tmp_path / name, header, points)
    assert read(path).tobytes() == points.array.tobytes()
    with open_reader(path) as reader:
        seek(path, reader, 2490)
        assert read_records(path, reader, 10)["X"].tolist() == points["X"][2490:].tolist()
        with pytest.raises(InputError, match="ends before its last point"):
            read_records(path, reader, 1)
        assert not has_chunks_of_any_size(reader.header)


def test_selected_dimensions_are_read(tmp_path):
    header, points = records(100, 6)
    path = write(tmp_path / "scan.laz", header, points)
    with open_reader(path, Selection.base() | Selection.Z) as reader:
        found = read_records(path, reader, 100)
    assert found["Z"].tolist() == points["Z"].tolist()
    with open_reader(path, EVERYTHING) as reader:
        assert read_records(path, reader, 100)["intensity"].tolist() == points["intensity"].tolist()


@pytest.mark.parametrize("point_format", [3, 6])
@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
@pytest.mark.parametrize("left", [1, 3, 4, 100, 226, 300, 0.1, 0.5, 0.9, -20, -3, -1])
def test_a_truncated_file_is_an_input_error(tmp_path, name, point_format, left):
    path = write(tmp_path / name, *records(60_000, point_format))
    data = path.read_bytes()
    path.write_bytes(data[: int(left * len(data)) if isinstance(left, float) else left])
    with pytest.raises(InputError) as error:
        read(path)
    assert str(path) in str(error.value)
    assert "\n" not in str(error.value)


def test_damage_within_the_compressed_points_never_escapes_as_another_error(tmp_path):
    path = write(tmp_path / "scan.laz", *records(2000))
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
    path = write(tmp_path / name, *records(0))
    with pytest.raises(InputError, match="holds no points"):
        read(path)
