"""The header of a PLY: where its vertices are, and what they have."""

from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Optional

import numpy as np

from ...errors import InputError
from ...tables.header import metres_of, stated_unit
from ..source import no_points, truncated, unreadable

HEADER_LINES = 1000
"""A file without the end of a header so far, in lines and in bytes of a line, is not a PLY."""

BYTE_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">", "ascii": "="}
TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}
Element = tuple[str, int, list[list[str]]]
"""Name, count and properties of an element; a property is its words but the first."""

COORDINATES = ("x", "y", "z")
"""What properties are called, in small letters."""

REMARKS = ("comment", "obj_info")

MOST_DIGITS = 15
"""Of the number of elements; no disk holds more."""


@dataclass(frozen=True)
class PlyLayout:
    """The position of the vertices in a file.

    Attributes
    ----------
    encoding : str
        ascii, binary_little_endian or binary_big_endian.
    start : int
        Byte at which the elements begin.
    skipped : int
        Lines of other elements before the vertices of an ascii file.
    header : int
        Number of lines of the header.
    count : int
    dtype : dtype
        Of a vertex.
    remarks : tuple of str
    unit : str or None
        The unit of the coordinates, if a remark states one.
    metres : float
        How many metres it is.
    is_last : bool
        Whether nothing follows the vertices.
    """

    encoding: str
    start: int
    skipped: int
    header: int
    count: int
    dtype: np.dtype
    remarks: tuple[str, ...]
    unit: Optional[str]
    metres: float
    is_last: bool


def read_layout(path: Path) -> PlyLayout:
    """Return the layout of a file.

    Raises
    ------
    InputError
        If it is not a PLY, has no vertices with x, y and z, or is too short for those that it announces.
    """
    try:
        with path.open("rb") as stream:
            lines, start = _header_lines(path, stream), stream.tell()
    except OSError as error:
        raise unreadable(path, error) from error
    encoding = next((words[1] for words in lines if words[0] == "format" and len(words) > 1), None)
    if encoding not in BYTE_ORDERS:
        raise InputError(f"{path} is a PLY of an unknown encoding; export it again.")
    lines_before = 0
    elements = _elements(path, lines)
    for number, (name, count, properties) in enumerate(elements):
        if name == "vertex":
            dtype = _vertex(path, properties, BYTE_ORDERS[encoding])
            remarks = tuple(" ".join(words[1:]) for words in lines if words[0] in REMARKS)
            unit = stated_unit(path, remarks)
            metres = metres_of(path, unit)
            last = not any(later for _, later, _ in elements[number + 1 :])
            layout = PlyLayout(
                encoding, start, lines_before, len(lines), count, dtype, remarks, unit, metres, last
            )
            _check_length(path, layout)
            return layout
        lines_before += count
        if encoding != "ascii":
            start += count * _record(path, properties, BYTE_ORDERS[encoding]).itemsize
    raise no_points(path)


def _check_length(path: Path, layout: PlyLayout) -> None:
    """Refuse a number of vertices for which the file is too short, before memory is claimed for them."""
    # In a text each number takes a digit and a blank at least.
    is_text = layout.encoding == "ascii"
    smallest = 2 * len(layout.dtype.names) if is_text else layout.dtype.itemsize
    skipped = 2 * layout.skipped - 1 if is_text else 0
    room = max(path.stat().st_size - layout.start - skipped, 0)
    if layout.count * smallest > room:
        raise truncated(path, f"it announces {layout.count} points and has {room // smallest}")
    if layout.count == 0:
        raise no_points(path)


def _header_lines(path: Path, stream: BinaryIO) -> list[list[str]]:
    """Return the words of each line of the header."""
    lines = []
    for line in islice(iter(lambda: stream.readline(HEADER_LINES), b""), HEADER_LINES):
        lines.append(line.decode("ascii", errors="replace").split() or [""])
        if lines[0] != ["ply"]:
            break
        if lines[-1] == ["end_header"]:
            return lines
    raise InputError(f"{path} is not a PLY file; give it the extension of its format.")


def _elements(path: Path, lines: list[list[str]]) -> list[Element]:
    """Return what a header says of each element."""
    elements: list[Element] = []
    for words in lines:
        if words[0] == "element":
            if len(words) != 3 or not words[2].isdecimal() or len(words[2]) > MOST_DIGITS:
                raise InputError(f"{path} has a header that cannot be read; export it again.")
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and elements:
            elements[-1][2].append(words[1:])
    return elements


def _vertex(path: Path, properties: list[list[str]], order: str) -> np.dtype:
    dtype = _record(path, properties, order)
    if named(dtype, COORDINATES) is None:
        raise InputError(f"{path} has vertices without x, y and z; export it again as a point cloud.")
    return dtype


def _record(path: Path, properties: list[list[str]], order: str) -> np.dtype:
    fields: list[tuple[str, str]] = []
    for words in properties:
        if len(words) != 2 or words[0] not in TYPES or words[1] in [name for name, _ in fields]:
            raise InputError(
                f"{path} has the property {' '.join(words)} with its vertices or before them, "
                "which cannot be read; export it again as a point cloud."
            )
        fields.append((words[1], order + TYPES[words[0]]))
    return np.dtype(fields)


def named(dtype: np.dtype, names: tuple[str, ...]) -> Optional[tuple[str, ...]]:
    """Return the properties with names in any letters, of which all are needed."""
    spelt = {name.lower(): name for name in reversed(dtype.names or ())}
    return tuple(spelt[name] for name in names) if set(names) <= spelt.keys() else None
