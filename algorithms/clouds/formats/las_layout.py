"""What the header of a LAS or LAZ announces, compared with the bytes there are."""

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ...errors import InputError
from ..source import no_points

LARGEST_RECORD = 4096
"""Bytes of a point, ten times those of the largest format with all extra bytes that programs write."""

WITH_WAVEFORM = (4, 5, 9, 10)
"""Point formats of which waveforms may follow the points."""


@dataclass(frozen=True)
class LasLayout:
    """The parts of a file that decide how much is read of it.

    Attributes
    ----------
    size : int
        Bytes of the file.
    start : int
        Where the points begin.
    count : int
        Number of points, from the field for them or from its older one.
    record_size : int
        Bytes of a point that is not compressed.
    compressed : bool
    states_count : bool
        Whether the header has the number of points; if not, it follows from the length of the file.
    surplus : int
        How many further points follow those that the header announces; 0 if compressed.
    """

    size: int
    start: int
    count: int
    record_size: int
    compressed: bool
    states_count: bool
    surplus: int = 0


def _check_records_after_points(path: Path, stream: BinaryIO, start: int, count: int, size: int) -> None:
    """Refuse a record that announces more bytes than follow it, before memory is claimed for them."""
    position = start
    for _ in range(count):
        stream.seek(position + 20)
        (length,) = struct.unpack("<Q", stream.read(8).ljust(8, b"\xff"))
        position += 60 + length
        if position > size:
            raise damaged(path, "a record after its points announces more than there is")


def count_warning(path: Path) -> tuple[str, ...]:
    """Return a sentence if the header of a file does not state the number of its points, or too few."""
    with path.open("rb") as stream:
        layout = read_layout(path, stream)
    if layout.states_count and layout.surplus:
        return surplus_warning(path, layout.count, layout.surplus)
    if layout.states_count:
        return ()
    return (
        f"The header of {path} announces no points; the {layout.count} that follow it were read, so check "
        "that the file is complete.",
    )


def surplus_warning(path: Path, count: int, surplus: int) -> tuple[str, ...]:
    """Return the sentence on points that follow those that the header announces."""
    return (
        f"The header of {path} announces {count} points, but {surplus} more follow, which were left out; "
        "export it again.",
    )


def damaged(path: Path, detail: str) -> InputError:
    """Return the error for a file that contradicts itself."""
    return InputError(f"{path} is truncated or damaged ({detail}); copy or export it again.")


def read_layout(path: Path, stream: BinaryIO) -> LasLayout:
    """Return the layout of a file, or refuse a header that contradicts the length of the file.

    Raises
    ------
    InputError
        If the file is not a LAS, is truncated, is damaged or holds no points.
    """
    size = path.stat().st_size
    head = stream.read(375)
    if head[:4] != b"LASF":
        raise InputError(f"{path} is not a LAS or LAZ file; give it the extension of its format.")
    if len(head) < 227 or (head[25] >= 4 and len(head) < 375):
        raise damaged(path, "it ends within the header")
    if head[24] != 1 or head[25] > 5:
        raise damaged(path, f"there is no version {head[24]}.{head[25]} of LAS")
    header_size, start, vlrs, kind, record_size, count = struct.unpack_from("<HIIBHI", head, 94)
    evlr_start, evlrs = 0, 0
    if head[25] >= 4:
        # Some programs fill in the older field only.
        evlr_start, evlrs, newer = struct.unpack_from("<QIQ", head, 235)
        count = newer or count
        # Without such records, the field may still hold the position in another file.
        evlr_start = evlr_start if evlrs else 0
    if not header_size + 54 * vlrs <= start <= size or evlr_start + 60 * evlrs > size:
        raise damaged(path, "its header announces more records than it has room for")
    _check_records_after_points(path, stream, evlr_start, evlrs, size)
    if not 0 < record_size <= LARGEST_RECORD:
        raise damaged(path, f"its header announces {record_size} bytes a point")
    compressed = bool(kind & 0b1100_0000)
    stated = bool(count)
    if not stated and not compressed:
        # A program that ended early leaves the header as it was before the first point.
        count, rest = divmod((evlr_start or size) - start, record_size)
        count = 0 if rest else count
    if count <= 0:
        raise no_points(path)
    if not compressed and start + count * record_size > size:
        raise damaged(path, f"its header announces {count} points, but it ends before the last")
    end = evlr_start or size
    if kind in WITH_WAVEFORM and head[25] >= 3:
        (waveforms,) = struct.unpack_from("<Q", head, 227)
        end = min(end, waveforms or end)
    surplus, rest = divmod(end - start - count * record_size, record_size)
    if compressed or rest or surplus < 0 or not _is_point(stream, start + count * record_size, head):
        surplus = 0
    return LasLayout(size, start, count, record_size, compressed, stated, surplus)


def _is_point(stream: BinaryIO, position: int, head: bytes) -> bool:
    """Whether the coordinates at a position are those of a point, and not of bytes that fill up a file.

    They are not 0, and lie within the box of the header or as near to it as it is wide, because points that
    were appended lie beside others.
    """
    stream.seek(position)
    stored = np.frombuffer(stream.read(12).ljust(12, b"\0"), "<i4")
    scales, offsets, box = np.split(np.array(struct.unpack_from("<12d", head, 131)), [3, 6])
    high, low = box.reshape(3, 2).T
    with np.errstate(all="ignore"):
        xyz, wide = stored * scales + offsets, high - low
        return bool(stored.any() and np.all((low - wide <= xyz) & (xyz <= high + wide)))
