"""The layout of a text cloud, found from its first lines."""

import io
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ...errors import InputError
from ..settings import TextSettings
from .text_columns import Columns, columns_by_count, columns_by_name
from .text_dialect import BYTE_ORDER_MARKS, Dialect, decimal_sign, delimiter_and_width, is_row, split
from .text_header import read_preamble
from .value_ranges import intensity_scale, rgb_factor


@dataclass(frozen=True)
class Layout:
    """How a text cloud is to be read.

    Attributes
    ----------
    encoding : str
    dialect : Dialect
    columns : Columns
    preamble : int
        Number of lines before the first point.
    announced : int or None
        Number of points that the count line of a PTS announces; None without such a line.
    intensity_scale : tuple of 2 float
        Summand, then factor, that bring the intensity to 0..65535.
    rgb_factor : float
        Brings the colour to 0..65535.
    middle : ndarray of float64, shape (3,)
        Median of the first coordinates.
    warnings : tuple of str
    """

    encoding: str
    dialect: Dialect
    columns: Columns
    preamble: int
    announced: Optional[int]
    intensity_scale: tuple[float, float]
    rgb_factor: float
    middle: np.ndarray
    warnings: tuple[str, ...]


def read_layout(path: Path, settings: TextSettings = TextSettings()) -> Layout:
    """Return the layout of `path`, found from its beginning.

    Raises
    ------
    InputError
        If the file is not text, holds no points, or can be read in more than one way.
    """
    encoding, lines = _first_lines(path, settings.sample_bytes)
    delimiter, width = delimiter_and_width(path, lines)
    numbers = [index for index, line in enumerate(lines) if is_row(line, delimiter, width)]
    rows = [split(lines[index], delimiter) for index in numbers]
    names, announced = read_preamble(path, lines[: numbers[0]], delimiter, width)
    dialect = Dialect(delimiter, decimal_sign(path, rows, delimiter, names), width)
    values = np.array([[dialect.number(field) for field in row] for row in rows])
    columns, warnings = (
        (columns_by_name(names), ())
        if names
        else columns_by_count(path, rows, values, settings.numeric_share)
    )
    return Layout(
        encoding=encoding,
        dialect=dialect,
        columns=columns,
        preamble=numbers[0],
        announced=announced,
        intensity_scale=(
            (0.0, 1.0)
            if columns.intensity is None
            else intensity_scale(values[:, columns.intensity], path.suffix.lower() == ".pts")
        ),
        rgb_factor=rgb_factor(values[:, columns.rgb]) if columns.rgb else 1.0,
        middle=_middle(path, values[:, columns.xyz]),
        warnings=warnings,
    )


def _first_lines(path: Path, size: int) -> tuple[str, list[str]]:
    with path.open("rb") as stream:
        sample = stream.read(size)
        has_more = bool(stream.read(1))
    marks = [name for mark, name in BYTE_ORDER_MARKS.items() if sample.startswith(mark)]
    encoding = marks[0] if marks else "utf-8"
    if encoding != "utf-16" and b"\0" in sample:
        raise InputError(f"{path} is not a text file; give it the extension of its format.")
    lines = list(io.StringIO(sample.decode(encoding, errors="replace"), newline=None))
    if lines and lines[0].lower().startswith("ncols"):
        raise InputError(f"{path} is a raster grid, not a point cloud; choose the cloud itself.")
    return encoding, lines[:-1] if has_more else lines


def _middle(path: Path, xyz: np.ndarray) -> np.ndarray:
    finite = xyz[np.isfinite(xyz).all(axis=1)]
    if not len(finite):
        raise InputError(f"{path} has coordinates that are not numbers; export it again.")
    return np.median(finite, axis=0)
