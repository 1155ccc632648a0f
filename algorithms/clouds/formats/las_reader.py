"""LAS and LAZ files opened with care: a damaged one is refused before laspy or lazrs trusts it."""

import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO, Optional

import laspy
import lazrs
import numpy as np

from ...errors import InputError
from ..source import no_points, unreadable

LARGEST_CHUNK = 1_000_000
"""Points for which lazrs may claim memory at once, whatever a damaged header announces."""

Selection = laspy.DecompressionSelection
EVERYTHING = Selection.all()


@contextmanager
def open_reader(
    path: Path, selection: laspy.DecompressionSelection = EVERYTHING
) -> Iterator[laspy.LasReader]:
    """Open `path` with laspy, after checking that its header agrees with its length.

    Raises
    ------
    InputError
        If the file is not a LAS, is truncated, is damaged or holds no points.
    """
    with _as_input_error(path):
        stream = path.open("rb")
    with stream:
        _check_layout(path, stream)
        stream.seek(0)
        with _as_input_error(path):
            reader = laspy.LasReader(stream, closefd=False, decompression_selection=selection)
            _check_chunk_size(path, reader.header)
        yield reader


@contextmanager
def _as_input_error(path: Path) -> Iterator[None]:
    try:
        yield
    except (KeyboardInterrupt, SystemExit, InputError):
        raise
    except OSError as error:
        raise unreadable(path, error) from error
    # A panic of lazrs derives from BaseException; damaged bytes raise nearly anything.
    except BaseException as error:
        raise _damaged(path, f"it cannot be decoded: {error}") from error


def _damaged(path: Path, detail: str) -> InputError:
    return InputError(f"{path} is truncated or damaged ({detail}); copy or export it again.")


def _check_layout(path: Path, stream: BinaryIO) -> None:
    """Refuse a header that contradicts the length of the file, before laspy trusts it."""
    size = path.stat().st_size
    head = stream.read(375)
    if head[:4] != b"LASF":
        raise InputError(f"{path} is not a LAS or LAZ file; give it the extension of its format.")
    if len(head) < 227 or (head[25] >= 4 and len(head) < 375):
        raise _damaged(path, "it ends within the header")
    header_size, data_start, vlrs, kind, record_size, count = struct.unpack_from("<HIIBHI", head, 94)
    evlr_start, evlrs = 0, 0
    if head[25] >= 4:
        evlr_start, evlrs, count = struct.unpack_from("<QIQ", head, 235)
    if header_size + 54 * vlrs > data_start or evlr_start + 60 * evlrs > size:
        raise _damaged(path, "its header announces more records than it has room for")
    if count == 0:
        raise no_points(path)
    compressed = kind & 0b1100_0000
    if not compressed and data_start + count * record_size > size:
        raise _damaged(path, f"its header announces {count} points, but it ends before the last")
    if compressed:
        _check_chunk_table(path, stream, data_start, size)


def _check_chunk_table(path: Path, stream: BinaryIO, data_start: int, size: int) -> None:
    """Refuse a chunk table that lies beyond the end of the file, or whose size would make lazrs abort."""

    def integer(position: int, code: str) -> int:
        stream.seek(position)
        value = stream.read(struct.calcsize(code))
        if len(value) < struct.calcsize(code):
            raise _damaged(path, "it ends before the table of its compressed chunks")
        return struct.unpack(code, value)[0]

    table = integer(data_start, "<q")
    if table == -1:
        table = integer(size - 8, "<q")
    if not data_start < table < size or integer(table + 4, "<I") > size:
        raise _damaged(path, "the table of its compressed chunks is missing")


def _check_chunk_size(path: Path, header: laspy.LasHeader) -> None:
    """Refuse a chunk for which lazrs would claim more memory than there is, and abort."""
    laszip = _laszip_record(header)
    if laszip is None or laszip.uses_variable_size_chunks():
        return
    if laszip.chunk_size() > max(header.point_count, LARGEST_CHUNK):
        raise _damaged(path, "its compressed chunks are larger than the file")


def has_chunks_of_any_size(header: laspy.LasHeader) -> bool:
    """Whether a LAZ has chunks of different numbers of points, as a COPC has."""
    laszip = _laszip_record(header)
    return laszip is not None and laszip.uses_variable_size_chunks()


def _laszip_record(header: laspy.LasHeader) -> Optional[lazrs.LazVlr]:
    records = header.vlrs.get("LasZipVlr")
    return lazrs.LazVlr(records[0].record_data) if records else None


def seek(path: Path, reader: laspy.LasReader, position: int) -> None:
    """Continue at the record `position`.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    with _as_input_error(path):
        reader.seek(position)


def read_records(path: Path, reader: laspy.LasReader, count: int) -> np.ndarray:
    """Return the next `count` raw records.

    Raises
    ------
    InputError
        If there are fewer, or they cannot be decoded.
    """
    with _as_input_error(path):
        points = reader.read_points(count).array
    if len(points) < count:
        raise _damaged(path, "it ends before its last point")
    return points
