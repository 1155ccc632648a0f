"""Points as lines of text: XYZ, TXT, CSV, ASC and PTS."""

import io
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Optional, TextIO

import numpy as np
import pandas as pd

from ...errors import InputError
from ...progress import Progress
from ..settings import ReadingSettings
from ..source import Chunk, Source, truncated, unreadable
from .text_dialect import Dialect, is_comment, is_count
from .text_layout import Layout, read_layout
from .value_ranges import to_uint16


@dataclass(frozen=True)
class TextSource(Source):
    """A text file with one point a line.

    The range of intensity and colour (0..1, 0..255, 0..65535; -2048..2047 in a PTS) is judged
    by the first 64 KB and brought to 0..65535.

    Attributes
    ----------
    layout : Layout
    """

    layout: Layout

    @classmethod
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "TextSource":
        """Examine the first lines of `path`.

        Raises
        ------
        InputError
            If the file cannot be read, holds no points or can be read in more than one way.
        """
        try:
            layout = read_layout(path, settings.text)
        except OSError as error:
            raise unreadable(path, error) from error
        return cls(
            path=path,
            crs=None,
            warnings=layout.warnings,
            middle=layout.middle,
            has_intensity=layout.columns.intensity is not None,
            has_rgb=layout.columns.rgb is not None,
            layout=layout,
        )

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
            The unchanged lines, including remarks and counts.
        ndarray of float64, shape (n, used)
            The used columns of the lines that are points; see `is_point`.

        Raises
        ------
        InputError
            If a line cannot be read, or the file ends early.
        """
        progress.update(0.0, f"Reading {self.path.name}")
        announced, found = self.layout.announced or 0, 0
        for number, lines, fraction in self._blocks(size):
            values, announced_here = self._parse(lines, number)
            announced += announced_here
            found += len(values)
            yield lines, values
            progress.update(fraction)
        if found < announced:
            raise truncated(self.path, f"it announces {announced} points and holds {found}")

    def is_point(self, line: str) -> bool:
        """Whether a line after the header is a point, neither a remark nor a count."""
        return not (is_comment(line) or (self.layout.announced is not None and is_count(line)))

    @contextmanager
    def _stream(self) -> Iterator[TextIO]:
        try:
            # Bytes that do not fit the encoding are kept, so that they can be written again.
            with self.path.open(encoding=self.layout.encoding, errors="surrogateescape") as stream:
                yield stream
        except OSError as error:
            raise unreadable(self.path, error) from error

    def _blocks(self, size: int) -> Iterator[tuple[int, list[str], float]]:
        """Yield the number of the first line, the lines, and the fraction read so far."""
        with self._stream() as stream:
            length = self.path.stat().st_size
            number = 1 + len(list(islice(stream, self.layout.preamble)))
            while lines := list(islice(stream, size)):
                yield number, lines, stream.buffer.tell() / length
                number += len(lines)

    def _parse(self, lines: list[str], number: int) -> tuple[np.ndarray, int]:
        """Return the used columns of `lines`, and how many points the lines announce."""
        values, announced = self._table(lines), 0
        if values is None:
            lines, announced = self._regular_lines(lines, number)
            values = self._table(lines, regular=True)
        if values is None:
            raise InputError(
                f"{self.path} cannot be read between the lines {number} and "
                f"{number + len(lines)}; look for unusual characters there."
            )
        return values, announced

    def _table(self, lines: list[str], regular: bool = False) -> Optional[np.ndarray]:
        """Return the used columns, shape (n, used), or None if any line is irregular.

        `regular` means that each line is known to have the right number of fields.
        """
        dialect, used = self.layout.dialect, self.layout.columns.used
        if not lines:
            return np.empty((0, len(used)))
        by_blanks = dialect.delimiter == " "
        try:
            table = pd.read_csv(
                io.BytesIO("".join(lines).replace('"', "").encode(errors="replace")),
                header=None,
                sep=r"\s+" if by_blanks else dialect.delimiter,
                decimal=dialect.decimal,
                skipinitialspace=True,
                dtype=dict.fromkeys(used, np.float64),
                low_memory=False,
            )
        except (ValueError, OverflowError):
            return None
        if table.shape != (len(lines), dialect.width):
            return None
        # Where blanks separate, a line that is too short shows as a missing last field.
        if by_blanks and not regular and table[dialect.width - 1].isna().any():
            return None
        values = table[list(used)].to_numpy()
        return values if np.isfinite(values).all() else None

    def _regular_lines(self, lines: list[str], number: int) -> tuple[list[str], int]:
        """Return the lines that hold points, and how many points the others announce.

        Raises
        ------
        InputError
            Naming the first line that is neither a point nor a remark.
        """
        regular, announced = [], 0
        for position, line in enumerate(lines, start=number):
            if not self.is_point(line):
                announced += 0 if is_comment(line) else int(line)
                continue
            problem = _problem(line, self.layout.dialect, self.layout.columns.used)
            if problem and not line.endswith("\n"):
                raise truncated(self.path, f"its last line {position} is cut off")
            if problem:
                raise InputError(f"Line {position} of {self.path} {problem}; correct or remove that line.")
            regular.append(line)
        return regular, announced

    def _chunk(self, values: np.ndarray, origin: np.ndarray) -> Chunk:
        layout = self.layout
        intensity = rgb = None
        if self.has_intensity:
            summand, factor = layout.intensity_scale
            intensity = to_uint16((values[:, 3] + summand) * factor)
        if self.has_rgb:
            rgb = to_uint16(values[:, -3:] * layout.rgb_factor)
        return Chunk(values[:, :3] - origin, intensity, rgb)


def _problem(line: str, dialect: Dialect, used: tuple[int, ...]) -> str:
    fields = dialect.split(line)
    if len(fields) != dialect.width:
        return f"has {len(fields)} columns instead of {dialect.width}"
    for column in used:
        if not np.isfinite(dialect.number(fields[column])):
            return f"has '{fields[column]}' where a number is expected"
    return ""
