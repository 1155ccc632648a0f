"""LAS and LAZ files opened with care: a damaged one is refused before laspy or lazrs trusts it."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

import laspy
import numpy as np

from ...errors import CancelledError, InputError
from ..source import unreadable
from .las_layout import LasLayout, damaged, read_layout, surplus_warning
from .laz_chunks import read_record, surplus, with_table

LARGEST_BLOCK = 2**28
"""Bytes of raw records that are read at once, whatever a damaged header announces."""

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
        with _as_input_error(path):
            layout = read_layout(path, stream)
            reader = _open(path, stream, layout, selection)
        yield reader


def _open(
    path: Path, stream: BinaryIO, layout: LasLayout, selection: laspy.DecompressionSelection
) -> laspy.LasReader:
    stream.seek(0)
    reader = laspy.LasReader(stream, closefd=False, decompression_selection=selection)
    if layout.compressed:
        records = reader.header.vlrs.get("LasZipVlr")
        if not records:
            raise damaged(path, "it lacks the record of its compression")
        checked, data = with_table(path, stream, layout, read_record(path, records[0].record_data, layout))
        if checked is not stream:
            # Several threads jump between chunks, and their lengths are not known.
            reader = laspy.LasReader(checked, closefd=False, laz_backend=laspy.LazBackend.Lazrs)
            reader.header.vlrs.get("LasZipVlr")[0].record_data = data
        checked.seek(layout.start)
    reader.header.point_count = layout.count
    return reader


@contextmanager
def _as_input_error(path: Path) -> Iterator[None]:
    try:
        yield
    except (KeyboardInterrupt, SystemExit, MemoryError, CancelledError, InputError):
        raise
    except OSError as error:
        raise unreadable(path, error) from error
    # A panic of lazrs derives from BaseException; damaged bytes raise nearly anything.
    except BaseException as error:
        raise damaged(path, f"it cannot be decoded: {_one_line(error)}") from error


def _one_line(error: BaseException) -> str:
    return " ".join(str(error).split())[:200]


def surplus_points(path: Path) -> tuple[str, ...]:
    """Return a sentence if the chunks of a LAZ hold more points than its header announces."""
    with path.open("rb") as stream:
        layout = read_layout(path, stream)
        if not layout.compressed:
            return ()
        stream.seek(0)
        data = laspy.LasHeader.read_from(stream).vlrs.get("LasZipVlr")[0].record_data
        more = surplus(stream, layout, read_record(path, data, layout))
    return surplus_warning(path, layout.count, more) if more else ()


def can_seek(reader: laspy.LasReader) -> bool:
    """Whether any record can be jumped to: not where chunks have different sizes, nor without their table."""
    records = reader.header.vlrs.get("LasZipVlr")
    if not records:
        return True
    is_variable = int.from_bytes(records[0].record_data[12:16], "little") == 2**32 - 1
    return not is_variable and reader.laz_backend is not laspy.LazBackend.Lazrs


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
        raise damaged(path, "it ends before its last point")
    return points
