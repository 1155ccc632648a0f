"""The compressed chunks of a LAZ: checked before lazrs claims memory, and found without a table."""

import io
import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Union

import lazrs

from .las_layout import LasLayout, damaged

LARGEST_CHUNK = 2**28
"""Bytes of the points of a chunk for which memory may be claimed, whatever a damaged file announces."""

VARIABLE = 2**32 - 1
"""The number of points of a chunk that says that the table has the number of each."""

# Types of items in the record of LASzip, and their sizes; extra bytes have any.
ITEM_SIZES = {1: 2, 2: 4, 3: 8, 4: 4, 5: 8, 6: 20, 7: 8, 8: 6, 9: 29, 10: 30, 11: 6, 12: 8, 13: 29}
LAYERS = {10: 9, 11: 1, 12: 2, 13: 1}
EXTRA_BYTES = {0, 14}

POINTWISE, CHUNKED, LAYERED = 1, 2, 3


@dataclass(frozen=True)
class LaszipRecord:
    """The record of a LAZ that says how its points are compressed.

    Attributes
    ----------
    data : bytes
    compressor : int
    chunk_points : int
        Points of a chunk.
    items : tuple of (int, int)
        Type and size of each part of a point.
    """

    data: bytes
    compressor: int
    chunk_points: int
    items: tuple[tuple[int, int], ...]

    @property
    def has_chunks_of_any_size(self) -> bool:
        """Whether chunks have different numbers of points, as in a COPC."""
        return self.chunk_points == VARIABLE

    @property
    def layers(self) -> int:
        """How many parts of a chunk are compressed apart from each other; 0 in the older compression."""
        if self.compressor != LAYERED:
            return 0
        return sum(size if kind in EXTRA_BYTES else LAYERS.get(kind, 0) for kind, size in self.items)


def read_record(path: Path, data: bytes, layout: LasLayout) -> LaszipRecord:
    """Return what the record of LASzip says.

    Raises
    ------
    InputError
        If it contradicts the header.
    """
    if len(data) < 34:
        raise damaged(path, "its record of the compression is cut off")
    compressor, chunk_points, count = (
        *struct.unpack_from("<H", data),
        *struct.unpack_from("<I", data, 12),
        data[32],
    )
    if len(data) < 34 + 6 * count:
        raise damaged(path, "its record of the compression is cut off")
    items = tuple(struct.unpack_from("<HH", data, 34 + 6 * item) for item in range(count))
    wrong = any(kind not in EXTRA_BYTES and ITEM_SIZES.get(kind) != size for kind, size in items)
    if wrong or sum(size for _, size in items) != layout.record_size:
        raise damaged(path, "its record of the compression does not fit its points")
    record = LaszipRecord(data, compressor, chunk_points, items)
    if compressor not in (POINTWISE, CHUNKED, LAYERED):
        raise damaged(path, f"its compression {compressor} is not known")
    points = min(chunk_points, layout.count) if not record.has_chunks_of_any_size else 0
    if points * layout.record_size > LARGEST_CHUNK:
        raise damaged(path, "its compressed chunks are larger than any program writes")
    return record


def with_table(
    path: Path, stream: BinaryIO, layout: LasLayout, record: LaszipRecord
) -> tuple[BinaryIO, bytes]:
    """Return a stream in which the table of the chunks can be read, and the record of LASzip that fits it.

    The stream is the one given if its table is sound. A file without a table is read from start to end, as
    if a table stood at its end.

    Raises
    ------
    InputError
        If the table or a chunk contradicts the length of the file, or a table that is needed is missing.
    """
    if record.compressor != POINTWISE:
        table = _position_of_table(stream, layout)
        chunks = _read_table(stream, layout, record) if table else []
        if chunks:
            _check_chunks(path, stream, layout, record, chunks, table)
            return stream, record.data
    if record.has_chunks_of_any_size:
        raise damaged(path, "the table of its compressed chunks is missing")
    return _with_assumed_table(path, stream, layout, record)


def surplus(stream: BinaryIO, layout: LasLayout, record: LaszipRecord) -> int:
    """Return how many points the chunks hold at least beyond those that the header announces.

    The chunks of the newer compression and those of different sizes state their points; the last of others
    may hold fewer than all.
    """
    if record.compressor == POINTWISE or not _position_of_table(stream, layout):
        return 0
    held, position = 0, layout.start + 8
    chunks = _read_table(stream, layout, record)
    for number, (count, size) in enumerate(chunks, start=1):
        if record.layers and size:
            stream.seek(position + layout.record_size)
            count = struct.unpack("<I", stream.read(4).ljust(4, b"\0"))[0]
        elif number == len(chunks) and not record.has_chunks_of_any_size:
            count = 1
        held, position = held + count, position + size
    return max(held - layout.count, 0)


def _position_of_table(stream: BinaryIO, layout: LasLayout) -> int:
    """Return where the table begins, 0 if there is none."""

    def integer(position: int, code: str) -> int:
        stream.seek(max(position, 0))
        value = stream.read(struct.calcsize(code))
        return int(struct.unpack(code, value)[0]) if len(value) == struct.calcsize(code) else 0

    table = integer(layout.start, "<q")
    if table == -1:
        table = integer(layout.size - 8, "<q")
    sound = layout.start + 8 <= table <= layout.size - 8 and integer(table, "<I") == 0
    return table if sound and integer(table + 4, "<I") <= layout.size else 0


def _read_table(stream: BinaryIO, layout: LasLayout, record: LaszipRecord) -> list[tuple[int, int]]:
    """Return the points and bytes of each chunk; nothing if the table is cut off."""
    stream.seek(layout.start)
    try:
        return list(lazrs.read_chunk_table(stream, lazrs.LazVlr(record.data)) or ())
    except lazrs.LazrsError:
        return []


def _check_chunks(
    path: Path,
    stream: BinaryIO,
    layout: LasLayout,
    record: LaszipRecord,
    chunks: list[tuple[int, int]],
    end: int,
) -> None:
    """Refuse chunks that reach beyond their table, have too few points, or layers longer than themselves."""
    position, points = layout.start + 8, 0
    for count, size in chunks:
        if position + size > end or count * layout.record_size > LARGEST_CHUNK:
            raise damaged(path, "the table of its compressed chunks announces more than there is")
        if record.layers and size and _layered_size(stream, layout, record, position) > size:
            raise damaged(path, "one of its compressed chunks announces more than it holds")
        position, points = position + size, points + count
    if points < layout.count:
        raise damaged(
            path, f"its header announces {layout.count} points, but its chunks hold {points} at most"
        )


def _layered_size(stream: BinaryIO, layout: LasLayout, record: LaszipRecord, position: int) -> int:
    """Return the bytes of a chunk of layers by what its beginning says; all of the file if it is cut off."""
    head = layout.record_size + 4 + 4 * record.layers
    stream.seek(position + layout.record_size + 4)
    lengths = stream.read(4 * record.layers)
    if len(lengths) < 4 * record.layers:
        return layout.size
    return head + sum(struct.unpack(f"<{record.layers}I", lengths))


def _with_assumed_table(
    path: Path, stream: BinaryIO, layout: LasLayout, record: LaszipRecord
) -> tuple[BinaryIO, bytes]:
    """Return the stream with a table after its points, and the record that fits it."""
    data, start = bytearray(record.data), layout.start + 8
    chunk_points = record.chunk_points
    if record.compressor == POINTWISE:
        # Without chunks the points begin at once and are one.
        start, chunk_points = layout.start, layout.count
        struct.pack_into("<H", data, 0, CHUNKED)
        struct.pack_into("<I", data, 12, chunk_points)
    if chunk_points == 0 or chunk_points >= VARIABLE or start >= layout.size:
        raise damaged(path, "the table of its compressed chunks is missing")
    chunks = math.ceil(layout.count / chunk_points)
    if chunks > layout.size:
        raise damaged(path, f"its header announces {layout.count} points, more than it has room for")
    # How long each chunk is matters only to who jumps between them, and to layers, which say it themselves.
    sizes, position = [max((layout.size - start) // chunks, 1)] * chunks, start
    for number in range(chunks if record.layers else 0):
        sizes[number] = _layered_size(stream, layout, record, position)
        position += sizes[number]
        if position > layout.size:
            raise damaged(path, "it ends within its compressed points")
    table = io.BytesIO()
    lazrs.write_chunk_table(table, [(chunk_points, size) for size in sizes], lazrs.LazVlr(bytes(data)))
    points = layout.size - start
    pieces = (
        (0, layout.start),
        struct.pack("<q", layout.start + 8 + points + 1),
        (start, points),
        END,
        table.getvalue(),
    )
    return io.BufferedReader(Spliced(stream, pieces)), bytes(data)


END = None
"""A piece at which reading ends, as at the end of a file; what follows can only be jumped to."""

Piece = Union[bytes, tuple[int, int], None]


class Spliced(io.RawIOBase):
    """A stream made of parts of another one, each a position and a length, of bytes, and of ends."""

    def __init__(self, stream: BinaryIO, pieces: Sequence[Piece]) -> None:
        super().__init__()
        self._stream = stream
        self._pieces = pieces
        self._position = 0
        self._size = sum(_length(piece) for piece in pieces)

    def readable(self) -> bool:
        """See `io.RawIOBase`."""
        return True

    def seekable(self) -> bool:
        """See `io.RawIOBase`."""
        return True

    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        """See `io.RawIOBase`."""
        base = {io.SEEK_SET: 0, io.SEEK_CUR: self._position, io.SEEK_END: self._size}[whence]
        self._position = max(base + offset, 0)
        return self._position

    def readinto(self, buffer: "memoryview") -> int:  # type: ignore[override]
        """See `io.RawIOBase`."""
        start = 0
        for piece in self._pieces:
            within = self._position - start
            if 0 <= within < _length(piece):
                wanted = min(len(buffer), _length(piece) - within)
                if piece is END:
                    return 0
                if isinstance(piece, bytes):
                    found = piece[within : within + wanted]
                else:
                    self._stream.seek(piece[0] + within)
                    found = self._stream.read(wanted)
                buffer[: len(found)] = found
                self._position += len(found)
                return len(found)
            start += _length(piece)
        return 0


def _length(piece: Piece) -> int:
    if piece is END:
        return 1
    return len(piece) if isinstance(piece, bytes) else piece[1]
