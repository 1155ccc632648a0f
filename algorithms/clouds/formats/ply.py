"""PLY, as text or binary: its vertices, with all that they have."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Optional

import numpy as np

from ...errors import InputError
from ...progress import Progress
from ...tables.column_names import CLOUD, recognised
from ...tables.header import metres_of, stated_unit
from ..settings import ReadingSettings
from ..source import Chunk, Source, no_points, truncated, unreadable
from .coordinate_steps import coordinate_warnings
from .normals import unnamed_normals
from .number_table import read_numbers
from .value_ranges import intensity_scale, rgb_factor, scaled_colour, to_uint16

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
COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
"""What properties are called, in small letters."""

REMARKS = ("comment", "obj_info")

MOST_DIGITS = 15
"""Of the number of elements; no disk holds more."""

LARGEST_BLOCK = 2**28
"""Bytes of vertices that are read at once, however many properties they have."""


@dataclass(frozen=True)
class Layout:
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
    unit : str or None
        The unit of the coordinates, if a comment states one.
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
    unit: Optional[str]
    metres: float
    is_last: bool


@dataclass(frozen=True)
class PlySource(Source):
    """A PLY file.

    Points from all over the file decide in which range intensity and colour are.

    Attributes
    ----------
    layout : Layout
    xyz : tuple of 3 str
        The properties that hold the coordinates.
    intensity : str or None
        The property that holds it.
    intensity_scale : tuple of 2 float
        Summand, then factor, that bring it to 0..65535.
    rgb : tuple of 3 str, or None
        The properties that hold the colour.
    rgb_factor : float
        Brings it to 0..65535.
    """

    layout: Layout
    xyz: tuple[str, ...]
    intensity: Optional[str]
    intensity_scale: tuple[float, float]
    rgb: Optional[tuple[str, ...]]
    rgb_factor: float

    @classmethod
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "PlySource":
        """Examine the header and the first points of `path`.

        Raises
        ------
        InputError
            If the file is not a PLY, is truncated or holds no points.
        """
        layout = _read_layout(path)
        sample = _sample(path, layout, settings)
        xyz = _named(layout.dtype, COORDINATES) or COORDINATES
        intensity = _intensity(layout.dtype)
        rgb = next(filter(None, (_named(layout.dtype, colour) for colour in COLOURS)), None)
        positions = _columns(sample, xyz)
        return cls(
            path=path,
            crs=None,
            warnings=(
                *_converted(path, layout),
                *_surplus(path, layout),
                *coordinate_warnings(path, positions, (layout.metres,) * 3, layout.unit is not None),
                *unnamed_normals(path, {name: sample[name] for name in _others(layout, xyz, intensity, rgb)}),
            ),
            middle=np.median(positions, axis=0) * layout.metres,
            has_intensity=intensity is not None,
            has_rgb=rgb is not None,
            layout=layout,
            xyz=xyz,
            intensity=intensity,
            intensity_scale=intensity_scale(sample[intensity].astype(float)) if intensity else (0.0, 1.0),
            rgb=rgb,
            rgb_factor=rgb_factor(_colour(sample, rgb)) if rgb else 1.0,
        )

    @property
    def attributes(self) -> tuple[tuple[str, np.dtype], ...]:
        """See `Source.attributes`."""
        names = _others(self.layout, self.xyz, self.intensity, self.rgb)
        return tuple((name, self.layout.dtype[name].newbyteorder("=")) for name in names)

    @property
    def expected_points(self) -> int:
        """See `Source.expected_points`."""
        return self.layout.count

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        progress.update(0.0, f"Reading {self.path.name}")
        summand, factor = self.intensity_scale
        for points, fraction in _blocks(self.path, self.layout, size):
            if len(points):
                yield Chunk(
                    _columns(points, self.xyz) * self.layout.metres - origin,
                    to_uint16((points[self.intensity] + summand) * factor) if self.intensity else None,
                    scaled_colour(self.path, _colour(points, self.rgb), self.rgb_factor)
                    if self.rgb
                    else None,
                    {name: points[name] for name, _ in self.attributes},
                )
            progress.update(fraction)


def _named(dtype: np.dtype, names: tuple[str, ...]) -> Optional[tuple[str, ...]]:
    """Return the properties with names in any letters, of which all are needed."""
    spelt = {name.lower(): name for name in reversed(dtype.names or ())}
    return tuple(spelt[name] for name in names) if set(names) <= spelt.keys() else None


def _others(
    layout: Layout, xyz: tuple[str, ...], intensity: Optional[str], rgb: Optional[tuple[str, ...]]
) -> list[str]:
    """Return the properties other than these."""
    return [name for name in layout.dtype.names or () if name not in (*xyz, intensity, *(rgb or ()))]


def _intensity(dtype: np.dtype) -> Optional[str]:
    """Return the property that holds the intensity."""
    names = list(dtype.names or ())
    column = recognised(names, {"intensity": CLOUD["intensity"]}).get("intensity")
    return None if column is None else names[column]


def _converted(path: Path, layout: Layout) -> tuple[str, ...]:
    if layout.metres == 1:
        return ()
    return (f"{path} gives coordinates in {layout.unit}; they were converted to metres.",)


def _surplus(path: Path, layout: Layout) -> tuple[str, ...]:
    """Return a sentence if more follows the vertices than the header announces."""
    if not layout.is_last:
        return ()
    with path.open("rb") as stream:
        stream.seek(layout.start)
        if layout.encoding == "ascii":
            more = any(line.split() for line in islice(stream, layout.skipped + layout.count, None))
        else:
            stream.seek(layout.count * layout.dtype.itemsize, 1)
            more = len(stream.read(layout.dtype.itemsize)) == layout.dtype.itemsize
    if not more:
        return ()
    return (
        f"The header of {path} announces {layout.count} points, but more follow, which were left out; export "
        "it again.",
    )


def _sample(path: Path, layout: Layout, settings: ReadingSettings) -> np.ndarray:
    """Return vertices from all over the file whose coordinates are numbers.

    Raises
    ------
    InputError
        If there are none.
    """
    if layout.encoding == "ascii" or layout.count <= settings.whole_points:
        blocks = [points for points, _ in _blocks(path, layout, settings.sample_points)]
    else:
        starts = np.linspace(0, layout.count - settings.run_points, settings.runs).astype(np.int64).tolist()
        runs = [replace(layout, start=layout.start + row * layout.dtype.itemsize) for row in starts]
        blocks = [
            points
            for run in runs
            for points, _ in _blocks(path, replace(run, count=settings.run_points), settings.run_points)
        ]
    sample = np.concatenate([points for points in blocks if len(points)] or [np.empty(0, layout.dtype)])
    if not len(sample):
        raise no_points(path)
    return sample


def _columns(points: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
    with np.errstate(invalid="ignore"):
        return np.stack([points[name].astype(np.float64) for name in names], axis=1)


def _colour(points: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
    """Return the colour; some programs announce its bytes as signed ones."""
    colour = _columns(points, names)
    signed = np.array([points.dtype[name] == np.int8 for name in names])
    return np.where(signed & (colour < 0), colour + 256, colour)


def _blocks(path: Path, layout: Layout, size: int) -> Iterator[tuple[np.ndarray, float]]:
    """Yield the vertices whose coordinates are numbers, and the fraction read so far."""
    read = _read_lines if layout.encoding == "ascii" else _read_records
    xyz = _named(layout.dtype, COORDINATES) or COORDINATES
    size = max(min(size, LARGEST_BLOCK // layout.dtype.itemsize), 1)
    try:
        with path.open("rb") as stream:
            stream.seek(layout.start)
            for done, points in read(path, stream, layout, size):
                finite = np.isfinite(_columns(points, xyz)).all(axis=1)
                yield points[finite], done / layout.count
    except OSError as error:
        raise unreadable(path, error) from error


def _read_records(
    path: Path, stream: BinaryIO, layout: Layout, size: int
) -> Iterator[tuple[int, np.ndarray]]:
    for start in range(0, layout.count, size):
        count = min(size, layout.count - start)
        points = np.fromfile(stream, layout.dtype, count)
        if len(points) < count:
            raise truncated(path, f"it announces {layout.count} points and has {start + len(points)}")
        yield start + count, points


def _read_lines(path: Path, stream: BinaryIO, layout: Layout, size: int) -> Iterator[tuple[int, np.ndarray]]:
    before = sum(1 for _ in islice(stream, layout.skipped))
    for start in range(0, layout.count, size):
        count = min(size, layout.count - start)
        lines = [line.decode("ascii", errors="replace") for line in islice(stream, count)]
        if len(lines) < count:
            raise truncated(path, f"it announces {layout.count} points and has {start + len(lines)}")
        first = 1 + layout.header + before + start
        values = read_numbers(path, lines, first, len(layout.dtype.names))
        points = np.empty(count, layout.dtype)
        for name, column in zip(layout.dtype.names, values.T):
            points[name] = _of_type(path, name, column, layout.dtype[name])
        yield start + count, points


def _of_type(path: Path, name: str, column: np.ndarray, kind: np.dtype) -> np.ndarray:
    """Return numbers of a text in the type that the header gives to them."""
    if kind.kind == "f":
        with np.errstate(over="ignore"):
            return column.astype(kind)
    limits = np.iinfo(kind)
    whole = np.nan_to_num(column)
    if np.any(whole % 1):
        raise InputError(
            f"{path} has a property {name} with decimals where its header announces whole numbers; export it "
            "again."
        )
    if np.any((whole < limits.min) | (whole > limits.max)):
        raise InputError(f"{path} has a property {name} beyond the range of its type; export it again.")
    return whole.astype(kind)


def _read_layout(path: Path) -> Layout:
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
            remarks = (" ".join(words[1:]) for words in lines if words[0] in REMARKS)
            unit = stated_unit(path, remarks)
            metres = metres_of(path, unit)
            last = not any(later for _, later, _ in elements[number + 1 :])
            layout = Layout(encoding, start, lines_before, len(lines), count, dtype, unit, metres, last)
            _check_length(path, layout)
            return layout
        lines_before += count
        if encoding != "ascii":
            start += count * _record(path, properties, BYTE_ORDERS[encoding]).itemsize
    raise no_points(path)


def _check_length(path: Path, layout: Layout) -> None:
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
    if _named(dtype, COORDINATES) is None:
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
