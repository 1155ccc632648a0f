"""PLY, as text or binary: its vertices, with all that they have."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Optional

import numpy as np

from ...errors import InputError
from ...progress import Progress
from ...tables.column_names import CLOUD, recognised
from ...tables.remarks import unapplied_remarks
from ..settings import ReadingSettings
from ..source import Chunk, Source, no_points, truncated, unreadable
from .coordinate_steps import coordinate_warnings
from .normals import unnamed_normals
from .number_table import read_numbers
from .ply_header import COORDINATES, PlyLayout, named, read_layout
from .value_ranges import intensity_scale, rgb_factor, scaled_colour, to_uint16

COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
"""What properties are called, in small letters."""

LARGEST_BLOCK = 2**28
"""Bytes of vertices that are read at once, however many properties they have."""


LINES_BLOCK = 2**24
"""Bytes in which lines are counted at once."""


@dataclass(frozen=True)
class PlySource(Source):
    """A PLY file.

    Points from all over the file decide in which range intensity and colour are.

    Attributes
    ----------
    layout : PlyLayout
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

    layout: PlyLayout
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
        layout = read_layout(path)
        sample = _sample(path, layout, settings)
        xyz = named(layout.dtype, COORDINATES) or COORDINATES
        intensity = _intensity(layout.dtype)
        rgb = next(filter(None, (named(layout.dtype, colour) for colour in COLOURS)), None)
        positions = _columns(sample, xyz)
        return cls(
            path=path,
            crs=None,
            warnings=(
                *_converted(path, layout),
                *_surplus(path, layout),
                *unapplied_remarks(path, layout.remarks),
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
        for points, fraction in _blocks(self.path, self.layout, _pieces(self.layout, size)):
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


def _others(
    layout: PlyLayout, xyz: tuple[str, ...], intensity: Optional[str], rgb: Optional[tuple[str, ...]]
) -> list[str]:
    """Return the properties other than these."""
    return [name for name in layout.dtype.names or () if name not in (*xyz, intensity, *(rgb or ()))]


def _intensity(dtype: np.dtype) -> Optional[str]:
    """Return the property that holds the intensity."""
    names = list(dtype.names or ())
    column = recognised(names, {"intensity": CLOUD["intensity"]}).get("intensity")
    return None if column is None else names[column]


def _converted(path: Path, layout: PlyLayout) -> tuple[str, ...]:
    if layout.metres == 1:
        return ()
    return (f"{path} gives coordinates in {layout.unit}; they were converted to metres.",)


def _surplus(path: Path, layout: PlyLayout) -> tuple[str, ...]:
    """Return a sentence if more follows the vertices than the header announces."""
    if not layout.is_last:
        return ()
    with path.open("rb") as stream:
        stream.seek(layout.start)
        if layout.encoding == "ascii":
            more = _is_longer(stream, layout.skipped + layout.count)
        else:
            stream.seek(layout.count * layout.dtype.itemsize, 1)
            more = len(stream.read(layout.dtype.itemsize)) == layout.dtype.itemsize
    if not more:
        return ()
    return (
        f"The header of {path} announces {layout.count} points, but more follow, which were left out; export "
        "it again.",
    )


def _is_longer(stream: BinaryIO, count: int) -> bool:
    """Whether more than blanks follows so many lines."""
    blocks = iter(lambda: stream.read(LINES_BLOCK), b"")
    for block in blocks:
        lines = block.count(b"\n")
        if lines >= count:
            return any(map(bytes.strip, (block.split(b"\n", count)[count], *blocks)))
        count -= lines
    return False


def _sample(path: Path, layout: PlyLayout, settings: ReadingSettings) -> np.ndarray:
    """Return vertices from all over the file whose coordinates are numbers.

    Raises
    ------
    InputError
        If there are none.
    """
    if layout.count <= settings.whole_points:
        pieces = _pieces(layout, settings.sample_points)
    else:
        starts = np.linspace(0, layout.count - settings.run_points, settings.runs).astype(np.int64).tolist()
        pieces = [(start, settings.run_points) for start in starts]
    blocks = [points for points, _ in _blocks(path, layout, pieces)]
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


def _pieces(layout: PlyLayout, size: int) -> list[tuple[int, int]]:
    """Return all vertices as the first one and the number of each piece of at most `size`."""
    size = max(min(size, LARGEST_BLOCK // layout.dtype.itemsize), 1)
    return [(start, min(size, layout.count - start)) for start in range(0, layout.count, size)]


def _blocks(
    path: Path, layout: PlyLayout, pieces: Iterable[tuple[int, int]]
) -> Iterator[tuple[np.ndarray, float]]:
    """Yield the vertices of each piece whose coordinates are numbers, and the fraction read so far."""
    read = _read_lines if layout.encoding == "ascii" else _read_records
    xyz = named(layout.dtype, COORDINATES) or COORDINATES
    try:
        with path.open("rb") as stream:
            stream.seek(layout.start)
            for done, points in read(path, stream, layout, pieces):
                finite = np.isfinite(_columns(points, xyz)).all(axis=1)
                yield points[finite], done / layout.count
    except OSError as error:
        raise unreadable(path, error) from error


def _read_records(
    path: Path, stream: BinaryIO, layout: PlyLayout, pieces: Iterable[tuple[int, int]]
) -> Iterator[tuple[int, np.ndarray]]:
    for start, count in pieces:
        stream.seek(layout.start + start * layout.dtype.itemsize)
        points = np.fromfile(stream, layout.dtype, count)
        if len(points) < count:
            raise truncated(path, f"it announces {layout.count} points and has {start + len(points)}")
        yield start + count, points


def _read_lines(
    path: Path, stream: BinaryIO, layout: PlyLayout, pieces: Iterable[tuple[int, int]]
) -> Iterator[tuple[int, np.ndarray]]:
    passed = -layout.skipped
    for start, count in pieces:
        passed += sum(1 for _ in islice(stream, start - passed))
        lines = [line.decode("ascii", errors="replace") for line in islice(stream, count)]
        if len(lines) < count:
            found = max(passed, 0) + len(lines)
            raise truncated(path, f"it announces {layout.count} points and has {found}")
        passed += count
        first = 1 + layout.header + layout.skipped + start
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
