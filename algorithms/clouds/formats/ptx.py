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
from ...tables.encoding import encoding_of
from ..settings import ReadingSettings
from ..source import Chunk, Source, no_points, truncated, unreadable
from .coordinate_steps import coordinate_warnings
from .line_samples import sample_lines
from .number_table import read_numbers
from .poses import pose_doubt, pose_problem
from .value_ranges import intensity_scale, rgb_factor, scaled_colour, to_uint16

UNMOVED = np.vstack([np.zeros(3), np.eye(3)])
"""Position and axes of a scanner in its own system, as programs write them that leave these lines out."""

LARGEST_DIFFERENCE = 1e-2
"""Metres, and parts of 1 of an axis: what rounding to two decimals leaves."""

WIDTHS = (3, 4, 7)
"""Numbers in the line of a cell: x y z, then intensity, then red green blue."""


HEADER = 10
"""Lines before the cells of a scan."""

MOST_DIGITS = 9
"""Of the number of rows or columns; no scanner turns so finely."""


@dataclass(frozen=True)
class PtxSource(Source):
    """A PTX file; the points of all scans, moved by their poses, without the cells that are empty.

    The first scan decides whether there is intensity and colour. They are 0 in scans without. Cells from all
    over the file decide in which ranges they are.

    Attributes
    ----------
    encoding : str
    intensity_scale : tuple of 2 float
        Summand, then factor, that bring the intensity to 0..65535.
    rgb_factor : float
        Brings the colour to 0..65535.
    """

    encoding: str
    intensity_scale: tuple[float, float]
    rgb_factor: float

    @classmethod
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "PtxSource":
        """Examine the first scan of `path`.

        Raises
        ------
        InputError
            If the file is not a PTX, is truncated or holds no points.
        """
        try:
            encoding = _encoding(path)
            blocks = _blocks(path, encoding, settings.sample_points)
            first, doubt = next(
                ((cells, doubt) for cells, _, _, doubt, _ in blocks if len(cells)), (None, "")
            )
            if first is None:
                raise no_points(path)
            width = first.shape[1]
            sample = _sample(path, encoding, width, settings)
        except OSError as error:
            raise unreadable(path, error) from error
        return cls(
            path=path,
            crs=None,
            warnings=(*((doubt,) if doubt else ()), *coordinate_warnings(path, sample[:, :3])),
            middle=np.median(first[:, :3], axis=0),
            has_intensity=width > 3,
            has_rgb=width == 7,
            encoding=encoding,
            intensity_scale=intensity_scale(sample[:, 3], relative=True) if width > 3 else (0.0, 1.0),
            rgb_factor=rgb_factor(sample[:, 4:]) if width == 7 else 1.0,
        )

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        progress.update(0.0, f"Reading {self.path.name}")
        summand, factor = self.intensity_scale
        usual = 3 + self.has_intensity + 3 * self.has_rgb
        said = False
        for points, scan, fraction, doubt, station in _blocks(self.path, self.encoding, size):
            if points.shape[1] != usual and not said:
                said = True
                progress.update(fraction, _mixed(self.path, usual, points.shape[1]))
            full = np.zeros((len(points), WIDTHS[-1]))
            full[:, : points.shape[1]] = points
            if len(points):
                yield Chunk(
                    full[:, :3] - origin,
                    to_uint16((full[:, 3] + summand) * factor) if self.has_intensity else None,
                    scaled_colour(self.path, full[:, 4:], self.rgb_factor) if self.has_rgb else None,
                    scan=np.full(len(points), scan),
                    station=station - origin if np.any(station) else None,
                )
            progress.update(fraction, doubt)


def _mixed(path: Path, usual: int, width: int) -> str:
    what = "colour" if {usual, width} == {4, 7} else "intensity or colour"
    lost = "is 0 there" if width < usual else "is left out there"
    return (
        f"Scans of {path.name} have unlike columns, {usual} in the first and {width} in others, so {what} "
        f"{lost}; export all scans alike."
    )


def _encoding(path: Path) -> str:
    with path.open("rb") as stream:
        return encoding_of(path, stream.read(4096))


def _sample(path: Path, encoding: str, width: int, settings: ReadingSettings) -> np.ndarray:
    """Return cells from all over the file that hold a point, before they are moved, shape (n, width)."""
    found = [np.empty((0, width))]
    for lines in sample_lines(path, encoding, settings=settings.text):
        cells = [line for line in lines if len(line.split()) == width]
        try:
            found.append(read_numbers(path, cells, 1, width))
        except InputError:
            continue
    sample = np.concatenate(found)
    return sample[_filled(sample)]


def _blocks(path: Path, encoding: str, size: int) -> Iterator[tuple[np.ndarray, int, float, str, np.ndarray]]:
    """Yield the cells that hold a point, shape (n, 3, 4 or 7), scan, fraction read, doubts, station."""
    try:
        length = path.stat().st_size
        with path.open(encoding=encoding, errors="replace") as stream:
            number = 1
            scan = 0
            while header := _read_header(path, stream, number):
                cells, pose, number, doubt = header
                left, width = cells, None
                while left:
                    raw = list(islice(stream, min(size, left)))
                    if not raw:
                        raise truncated(path, f"a scan announces {cells} cells and has {cells - left}")
                    lines = [line for line in raw if not line.isspace()]
                    if lines:
                        width = width or _width(path, lines[0], number)
                        points = _points(read_numbers(path, lines, number, width), pose)
                        yield points, scan, _position(stream) / length, doubt, pose[3, :3]
                    number, left = number + len(raw), left - len(lines)
                scan += 1
    except OSError as error:
        raise unreadable(path, error) from error


def _position(stream: TextIO) -> int:
    """Return the number of bytes that are read of a file of lines."""
    return stream.buffer.tell()


def _read_header(path: Path, stream: TextIO, number: int) -> Optional[tuple[int, np.ndarray, int, str]]:
    """Return the number of cells, the pose for rows, the number of the next line, and doubts; or None."""
    # Columns, rows, the scanner's position and axes, which the pose repeats, and the pose.
    lines: list[str] = []
    first = last = number
    for line in stream:
        last += 1
        # The end of a file in DOS is not content either.
        if not line.replace("\x1a", " ").split():
            continue
        first = first if lines else last - 1
        lines.append(line)
        if len(lines) == HEADER:
            break
    if not lines:
        return None
    fields = [line.split() for line in lines]
    shape = [len(row) for row in fields]
    whole = all(row[0].isdecimal() and len(row[0]) <= MOST_DIGITS for row in fields[:2])
    if shape != [1, 1, 3, 3, 3, 3, 4, 4, 4, 4] or not whole:
        raise InputError(
            f"{path} has no header of a PTX scan from line {first} on; "
            "give it the extension of its format, or export it again."
        )
    pose = read_numbers(path, [line.rstrip() + "\n" for line in lines[6:]], first + 6, 4)
    problem = pose_problem(pose[:3, :3].T, pose[3, :3])
    if not problem and not np.allclose(pose[:, 3], [0, 0, 0, 1], rtol=0, atol=1e-6):
        problem = "does not end in the column 0 0 0 1"
    if problem:
        raise InputError(
            f"The pose of the scan in line {first} of {path} {problem}; export the scan again with its pose."
        )
    doubt = pose_doubt(pose[:3, :3].T) or _contradiction(lines[2:6], pose)
    sentence = (
        f"The pose of the scan in line {first} of {path} {doubt}; check how it was exported." if doubt else ""
    )
    return int(lines[0]) * int(lines[1]), pose, last, sentence


def _contradiction(lines: list[str], pose: np.ndarray) -> str:
    """Return how the position or axes of the scanner differ from the pose; nothing if they are not given."""
    try:
        stated = np.array([[float(word) for word in line.split()] for line in lines])
    except ValueError:
        return ""
    if not stated.any() or np.array_equal(stated, UNMOVED) or not np.isfinite(stated).all():
        return ""
    if not _agree(stated[0], pose[3, :3]):
        apart = np.linalg.norm(stated[0] - pose[3, :3])
        return f"differs from the position and axes of the scanner above it, by {apart:.3g} m in position"
    axes, rows = stated[1:], pose[:3, :3]
    # The axes are lines in some files and columns in others.
    if not axes.any() or _agree(axes, rows) or _agree(axes.T, rows):
        return ""
    lengths = np.linalg.norm(axes, axis=1) * np.linalg.norm(rows, axis=1)
    cosines = np.sum(axes * rows, axis=1) / np.maximum(lengths, LARGEST_DIFFERENCE)
    angle = np.degrees(np.arccos(np.clip(cosines, -1, 1))).max()
    return f"differs from the axes of the scanner above it, by up to {angle:.3g} degrees"


def _agree(stated: np.ndarray, expected: np.ndarray) -> bool:
    return np.allclose(stated, expected, rtol=0, atol=LARGEST_DIFFERENCE)


def _width(path: Path, line: str, number: int) -> int:
    width = len(line.split())
    if width not in WIDTHS:
        raise InputError(
            f"Line {number} of {path} has {width} numbers instead of 4 (x y z intensity) or 7 (and colour); "
            "export it again as PTX."
        )
    return width


def _filled(cells: np.ndarray) -> np.ndarray:
    """Return which cells hold a point; bool, shape (n,)."""
    return cells[:, :3].any(axis=1) & np.isfinite(cells[:, :3]).all(axis=1)


def _points(cells: np.ndarray, pose: np.ndarray) -> np.ndarray:
    points = cells[_filled(cells)]
    points[:, :3] = product(points[:, :3], pose[:3, :3].T) + pose[3, :3]
    return points
