"""PTX: scans as grids of cells in lines of text, each with its pose."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Optional, TextIO

import numpy as np

from ...errors import InputError
from ...geometry.motion import product
from ...progress import Progress
from ..settings import ReadingSettings
from ..source import Chunk, Source, no_points, truncated, unreadable
from .number_table import read_numbers
from .value_ranges import rgb_factor, to_uint16

WIDTHS = (3, 4, 7)
"""Numbers in the line of a cell: x y z, then intensity, then red green blue."""


@dataclass(frozen=True)
class PtxSource(Source):
    """A PTX file; the points of all scans, moved by their poses, without the cells that are empty.

    The first scan decides whether there is intensity and colour. They are 0 in scans without.

    Attributes
    ----------
    rgb_factor : float
        Brings the colour to 0..65535.
    """

    rgb_factor: float

    @classmethod
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "PtxSource":
        """Examine the first scan of `path`.

        Raises
        ------
        InputError
            If the file is not a PTX, is truncated or holds no points.
        """
        sample = next((points for points, *_ in _blocks(path, settings.sample_points) if len(points)), None)
        if sample is None:
            raise no_points(path)
        width = sample.shape[1]
        return cls(
            path=path,
            crs=None,
            warnings=(),
            middle=np.median(sample[:, :3], axis=0),
            has_intensity=width > 3,
            has_rgb=width == 7,
            rgb_factor=rgb_factor(sample[:, 4:]) if width == 7 else 1.0,
        )

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        progress.update(0.0, f"Reading {self.path.name}")
        for points, scan, fraction in _blocks(self.path, size):
            full = np.zeros((len(points), WIDTHS[-1]))
            full[:, : points.shape[1]] = points
            if len(points):
                yield Chunk(
                    full[:, :3] - origin,
                    to_uint16(full[:, 3] * 65535) if self.has_intensity else None,
                    to_uint16(full[:, 4:] * self.rgb_factor) if self.has_rgb else None,
                    scan=np.full(len(points), scan),
                )
            progress.update(fraction)


def _blocks(path: Path, size: int) -> Iterator[tuple[np.ndarray, int, float]]:
    """Yield the cells that hold a point, shape (n, 3, 4 or 7), their scan, and the fraction read so far."""
    try:
        length = path.stat().st_size
        with path.open(encoding="utf-8", errors="replace") as stream:
            number = 1
            scan = 0
            while header := _read_header(path, stream, number):
                cells, pose = header
                number, left, width = number + 10, cells, None
                while left:
                    lines = list(islice(stream, min(size, left)))
                    if not lines:
                        raise truncated(path, f"a scan announces {cells} cells and has {cells - left}")
                    width = width or _width(path, lines[0], number)
                    cell = read_numbers(path, lines, number, width)
                    number, left = number + len(lines), left - len(lines)
                    yield _points(cell, pose), scan, _position(stream) / length
                scan += 1
    except OSError as error:
        raise unreadable(path, error) from error


def _position(stream: TextIO) -> int:
    """Return the number of bytes that are read of a file of lines."""
    return stream.buffer.tell()


def _read_header(path: Path, stream: TextIO, number: int) -> Optional[tuple[int, np.ndarray]]:
    """Return the number of cells and the pose, a matrix for rows; None at the end of the file."""
    # Columns, rows, the scanner's position and axes, which the pose repeats, and the pose.
    lines = list(islice(stream, 10))
    if not any(line.strip() for line in lines):
        return None
    fields = [line.split() for line in lines]
    shape = [len(row) for row in fields]
    if shape != [1, 1, 3, 3, 3, 3, 4, 4, 4, 4] or not all(row[0].isdecimal() for row in fields[:2]):
        raise InputError(
            f"{path} has no header of a PTX scan from line {number} on; "
            "give it the extension of its format, or export it again."
        )
    return int(lines[0]) * int(lines[1]), read_numbers(path, lines[6:], number + 6, 4)


def _width(path: Path, line: str, number: int) -> int:
    width = len(line.split())
    if width not in WIDTHS:
        raise InputError(
            f"Line {number} of {path} has {width} numbers instead of 4 (x y z intensity) or 7 (and colour); "
            "export it again as PTX."
        )
    return width


def _points(cells: np.ndarray, pose: np.ndarray) -> np.ndarray:
    filled = cells[:, :3].any(axis=1) & np.isfinite(cells[:, :3]).all(axis=1)
    points = cells[filled]
    points[:, :3] = product(points[:, :3], pose[:3, :3].T) + pose[3, :3]
    return points
