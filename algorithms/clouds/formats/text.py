"""Points as lines of text: XYZ, TXT, CSV, ASC and PTS."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import TextIO

import numpy as np

from ...progress import Progress
from ...tables.dialect import is_row
from ...tables.encoding import WIDE, damaged
from ..settings import ReadingSettings, TextSettings
from ..source import Chunk, Source, truncated, unreadable
from .coordinate_steps import coordinate_warnings
from .line_samples import sample_lines
from .text_layout import Layout, read_layout
from .text_rows import RowParser
from .value_ranges import intensity_scale, rgb_factor, scaled_colour, to_uint16


@dataclass(frozen=True)
class TextSource(Source):
    """A text file with one point a line.

    The range of intensity and colour (0..1, 0..255, 0..65535; -2048..2047 in a PTS) is judged by points
    from all over the file and brought to 0..65535.

    Attributes
    ----------
    layout : Layout
    intensity_scale : tuple of 2 float
        Summand, then factor, that bring the intensity to 0..65535.
    rgb_factor : float
        Brings the colour to 0..65535.
    """

    layout: Layout
    intensity_scale: tuple[float, float]
    rgb_factor: float

    @classmethod
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "TextSource":
        """Examine the first lines of `path`, and some from all over the file.

        Raises
        ------
        InputError
            If the file cannot be read, holds no points or can be read in more than one way.
        """
        try:
            layout = read_layout(path, settings.text)
            sample = _sample(path, layout, settings.text)
        except OSError as error:
            raise unreadable(path, error) from error
        columns = layout.columns
        return cls(
            path=path,
            crs=None,
            warnings=layout.warnings
            + coordinate_warnings(path, sample[:, :3] / layout.metres, layout.metres, layout.unit_stated),
            middle=layout.middle,
            has_intensity=columns.intensity is not None,
            has_rgb=columns.rgb is not None,
            layout=layout,
            intensity_scale=(
                (0.0, 1.0)
                if columns.intensity is None
                else intensity_scale(sample[:, 3], path.suffix.lower() == ".pts")
            ),
            rgb_factor=rgb_factor(sample[:, -3:]) if columns.rgb else 1.0,
        )

    @property
    def others(self) -> tuple[str, ...]:
        """See `Source.others`."""
        return self.layout.others

    @property
    def rows(self) -> RowParser:
        """What makes numbers of lines."""
        return RowParser(self.path, self.layout)

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        for _, values in self.records(progress, size):
            if len(values):
                yield self._chunk(values, origin)

    def head(self) -> list[str]:
        """Return the lines before the first point."""
        with self._stream() as stream:
            return list(islice(stream, self.layout.preamble))

    def records(self, progress: Progress, size: int) -> Iterator[tuple[list[str], np.ndarray]]:
        """Yield the lines from the first point on, `size` at a time, and what they hold.

        Yields
        ------
        list of str
            The unchanged lines, including remarks, counts, and rows without coordinates.
        ndarray of float64, shape (n, used)
            The used columns of the lines that are points; see `RowParser.is_point`.

        Raises
        ------
        InputError
            If a line cannot be read, or the file ends early.
        """
        progress.update(0.0, f"Reading {self.path.name}")
        announced, found, rows = self.layout.announced or 0, 0, self.rows
        for number, lines, fraction in self._blocks(size):
            values, announced_here = rows.parse(lines, number)
            announced += announced_here
            found += len(values)
            yield lines, values
            progress.update(fraction)
        if self.layout.announced is not None and found < announced:
            lost = announced - found
            if lost > self._rows_without_coordinates(size):
                raise truncated(self.path, f"it announces {announced} points and holds {found}")

    def _rows_without_coordinates(self, size: int) -> int:
        """Return how many rows a program wrote without coordinates, which an announced number counts too."""
        rows = self.rows
        return sum(
            rows.is_row_without_coordinates(line) for _, lines, _ in self._blocks(size) for line in lines
        )

    @contextmanager
    def _stream(self) -> Iterator[TextIO]:
        encoding = self.layout.encoding
        # Bytes that do not fit the encoding are kept, so that they can be written again.
        errors = "strict" if encoding in WIDE else "surrogateescape"
        try:
            with self.path.open(encoding=encoding, errors=errors) as stream:
                yield stream
        except OSError as error:
            raise unreadable(self.path, error) from error
        except UnicodeDecodeError as error:
            raise damaged(self.path, encoding) from error

    def _blocks(self, size: int) -> Iterator[tuple[int, list[str], float]]:
        """Yield the number of the first line, the lines, and the fraction read so far."""
        with self._stream() as stream:
            length = self.path.stat().st_size
            number = 1 + len(list(islice(stream, self.layout.preamble)))
            while lines := list(islice(stream, size)):
                yield number, lines, stream.buffer.tell() / length
                number += len(lines)

    def _chunk(self, values: np.ndarray, origin: np.ndarray) -> Chunk:
        intensity = rgb = None
        if self.has_intensity:
            summand, factor = self.intensity_scale
            intensity = to_uint16((values[:, 3] + summand) * factor)
        if self.has_rgb:
            rgb = scaled_colour(self.path, values[:, -3:], self.rgb_factor)
        return Chunk(values[:, :3] - origin, intensity, rgb)


def _sample(path: Path, layout: Layout, settings: TextSettings) -> np.ndarray:
    """Return the used columns of points from all over the file, shape (n, used)."""
    rows, dialect = RowParser(path, layout), layout.dialect
    found = [np.empty((0, len(layout.columns.used)))]
    for lines in sample_lines(path, layout.encoding, settings=settings):
        values = rows.table(lines)
        if values is None:
            regular = [line for line in lines if is_row(line, dialect.delimiter, dialect.width)]
            values = rows.table([line for line in regular if rows.is_point(line)], regular=True)
        found.append(np.empty((0, len(layout.columns.used))) if values is None else values)
    return np.concatenate(found)
