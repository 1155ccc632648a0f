"""The chunks of a LAZ are found without their table, and what they announce is checked."""

import io
import resource
import struct

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.las_reader import open_reader, read_records
from ichnograph.algorithms.clouds.formats.laz_chunks import END, Spliced
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.algorithms.clouds.sample_files import las_records, table_of, write_las


def read(path, size=1000):
    """Return all records of a file."""
    with open_reader(path) as reader:
        count = reader.header.point_count
        return np.concatenate(
            [read_records(path, reader, min(size, count - start)) for start in range(0, count, size)]
        )


@pytest.mark.parametrize("point_format", [3, 6])
@pytest.mark.parametrize(
    "state", ["never written", "pointer of a stream", "pointer of a stream, at the end", "cut off"]
)
def test_a_laz_without_a_sound_table_of_chunks_is_read_from_start_to_end(tmp_path, point_format, state):
    header, points = las_records(120_000, point_format)
    path = write_las(tmp_path / "scan.laz", header, points)
    data = bytearray(path.read_bytes())
    start, table = struct.unpack_from("<I", data, 96)[0], table_of(data)
    if state != "cut off":
        struct.pack_into("<q", data, start, 0 if state == "never written" else -1)
    if state == "pointer of a stream, at the end":
        data += struct.pack("<q", table)
    else:
        data = data[: table + (9 if state == "cut off" else 0)]
    path.write_bytes(data)

    assert read(path, 50_001).tobytes() == points.array.tobytes()


def test_a_laz_of_one_stream_without_chunks_is_read(tmp_path):
    header, points = las_records(2500)
    path = write_las(tmp_path / "scan.laz", header, points)
    data = bytearray(path.read_bytes())
    start, table = struct.unpack_from("<I", data, 96)[0], table_of(data)
    record = data.index(b"laszip encoded") + 52
    struct.pack_into("<H", data, record, 1)
    path.write_bytes(data[:start] + data[start + 8 : table])

    assert read(path).tobytes() == points.array.tobytes()


@pytest.mark.alone
@pytest.mark.parametrize(
    ("field", "code", "value"),
    [
        ("size of an item", "<H", 65300),
        ("points of a chunk", "<I", 2**31),
        ("number of items", "<H", 60000),
        ("compressor", "<H", 9),
    ],
)
def test_a_record_of_the_compression_that_lies_is_refused_before_memory_is_claimed(
    tmp_path, field, code, value
):
    path = write_las(tmp_path / "scan.laz", *las_records(300))
    data = bytearray(path.read_bytes())
    record = data.index(b"laszip encoded") + 52
    offset = {"compressor": 0, "points of a chunk": 12, "number of items": 32, "size of an item": 36}[field]
    struct.pack_into(code, data, record + offset, value)
    if field == "points of a chunk":
        struct.pack_into("<I", data, 107, value)
    path.write_bytes(data)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    with pytest.raises(InputError, match="truncated or damaged"):
        read(path)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 100_000


def test_layers_that_are_longer_than_their_chunk_are_refused(tmp_path):
    path = write_las(tmp_path / "scan.laz", *las_records(300, 6))
    data = bytearray(path.read_bytes())
    start = struct.unpack_from("<I", data, 96)[0]
    struct.pack_into("<I", data, start + 8 + 30 + 4, 2**31)
    path.write_bytes(data)

    with pytest.raises(InputError, match="one of its compressed chunks announces more than it holds"):
        read(path)


def test_a_spliced_stream_reads_its_pieces_in_sequence_and_ends_where_it_says():
    stream = Spliced(io.BytesIO(b"abcdefgh"), ((1, 3), b"XY", END, b"Z"))
    assert stream.read(10) == b"bcd"
    assert stream.read(10) == b"XY"
    assert stream.read(10) == b""
    assert stream.seek(-1, io.SEEK_END) == 6
    assert stream.read(10) == b"Z"
