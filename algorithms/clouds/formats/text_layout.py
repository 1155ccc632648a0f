"""The layout of a text cloud, found from its first lines."""

import io
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ...errors import InputError
from ...tables.degrees import degree_warning
from ...tables.dialect import (
    Dialect,
    decimal_signs,
    delimiter_and_width,
    is_comment,
    is_remark,
    is_row,
    split,
)
from ...tables.encoding import encoding_of
from ...tables.header import read_preamble
from ...tables.remarks import unapplied_remarks
from ...tables.units import factor_of
from ..settings import TextSettings
from .line_samples import sample_lines
from .normals import unnamed_normals
from .text_columns import Columns, columns_by_count, columns_by_name

_OF_MODEL = re.compile(r"(?:vn|vt)\s|f(?:\s+-?\d+(?:/-?\d*)*){3,}\s*$")
"""Normals, textures and faces of an OBJ."""


@dataclass(frozen=True)
class Layout:
    """How a text cloud is to be read.

    Attributes
    ----------
    encoding : str
    dialect : Dialect
    columns : Columns
    metres : tuple of 3 float
        How many metres the units of the coordinates are.
    unit_stated : bool
        Whether the file says so.
    preamble : int
        Number of lines before the first point.
    announced : int or None
        Number of points that the count line of a PTS announces; None without such a line.
    middle : ndarray of float64, shape (3,)
        Median of the first coordinates (m).
    warnings : tuple of str
    others : tuple of str
        The columns that are not read and not 0, by their names, or by their numbers from 1.
    """

    encoding: str
    dialect: Dialect
    columns: Columns
    metres: tuple[float, float, float]
    unit_stated: bool
    preamble: int
    announced: Optional[int]
    middle: np.ndarray
    warnings: tuple[str, ...]
    others: tuple[str, ...] = ()


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
    ends_empty = not any(row[-1] for row in rows)
    header = read_preamble(path, lines[: numbers[0]], delimiter, width, ends_with_delimiter=ends_empty)
    signs = decimal_signs(path, rows, delimiter, bool(header.columns))
    dialect = Dialect(delimiter, signs[0], width, signs[1])
    values = np.array([[dialect.number(field) for field in row] for row in rows])
    runs = [] if header.columns else list(sample_lines(path, encoding, settings=settings))
    _refuse_models(path, lines, rows[0][0], runs)
    columns, warnings = (
        (columns_by_name(header.columns), ())
        if header.columns
        else _unnamed_columns(path, rows, values, _elsewhere(runs, dialect, settings), settings)
    )
    metres = header.factors(path)
    marked = _marked_rows(lines, columns, dialect)
    return Layout(
        encoding=encoding,
        dialect=dialect,
        columns=columns,
        metres=metres,
        unit_stated=bool(header.units),
        preamble=min([numbers[0], *marked]),
        announced=header.announced,
        middle=_middle(path, values[:, columns.xyz]) * metres,
        warnings=(
            *warnings,
            *unapplied_remarks(path, lines[: numbers[0]]),
            *_unnamed_normals(path, values, columns),
            *_converted(path, header.units),
            *degree_warning(path, ([row[column] for column in columns.xyz] for row in rows), dialect),
            *_taken(path, marked),
        ),
        others=tuple(
            (header.names[column] if header.names else "") or f"column {column + 1}"
            for column in range(width)
            if column not in columns.used and np.any(values[:, column] != 0)
        ),
    )


def _refuse_models(path: Path, lines: list[str], mark: str, runs: list[list[str]]) -> None:
    """Refuse models of surfaces, whose normals and triangles would be taken for points.

    Parameters
    ----------
    path : Path
    lines : list of str
        The first lines.
    mark : str
        What the first row begins with.
    runs : list of list of str
        Lines from all over the file: of a large model, triangles are far behind.

    Raises
    ------
    InputError
    """
    is_off = lines[0].strip().endswith("OFF") and len(lines[0].split()) == 1
    is_obj = mark == "v" and any(_OF_MODEL.match(line) for run in (lines, *runs) for line in run)
    if is_off or is_obj:
        raise InputError(f"{path} is a model of surfaces, not a point cloud; export its points as x y z.")


def _elsewhere(runs: list[list[str]], dialect: Dialect, settings: TextSettings) -> np.ndarray:
    """Return the numbers of rows from all over the file, shape (n, columns)."""
    found = [np.empty((0, dialect.width))]
    for lines in runs:
        few = lines[:: max(len(lines) // settings.rows_of_run, 1)]
        rows = [dialect.split(line) for line in few if is_row(line, dialect.delimiter, dialect.width)]
        if rows:
            found.append(np.array([[dialect.number(field) for field in row] for row in rows]))
    return np.concatenate(found)


def _marked_rows(lines: list[str], columns: Columns, dialect: Dialect) -> list[int]:
    """Return the indices of the rows whose name begins as a remark does."""
    if 0 in columns.used:
        return []
    return [
        index
        for index, line in enumerate(lines)
        if is_comment(line) and not is_remark(line, dialect.delimiter, dialect.width)
    ]


def _taken(path: Path, marked: list[int]) -> tuple[str, ...]:
    if not marked:
        return ()
    return (
        f"{len(marked)} of the first rows of {path}, the first in line {marked[0] + 1}, begin as remarks do "
        "and were read as points, because their first field is a name.",
    )


def _unnamed_columns(
    path: Path, rows: list[list[str]], values: np.ndarray, elsewhere: np.ndarray, settings: TextSettings
) -> tuple[Columns, tuple[str, ...]]:
    columns, warnings = columns_by_count(path, rows, values, settings, elsewhere)
    doubt = _assumed_intensity(path, columns, np.concatenate([values, elsewhere]), settings)
    return columns, (*warnings, *doubt)


def _assumed_intensity(
    path: Path, columns: Columns, values: np.ndarray, settings: TextSettings
) -> tuple[str, ...]:
    """Return a sentence on a column without a name that was read as intensity but may be something else.

    Intensity is a part of 1, or whole with many levels; classes have few, distances and deviations decimals.
    That of a PTS has a position of its own.
    """
    if columns.intensity is None or path.suffix.lower() == ".pts":
        return ()
    known = values[np.isfinite(values[:, columns.intensity]), columns.intensity]
    is_part = known.min(initial=0) >= 0 and known.max(initial=0) <= 1 and np.any(known % 1)
    has_levels = not np.any(known % 1) and len(np.unique(known)) > settings.most_classes
    if is_part or has_levels:
        return ()
    return (
        f"Column {columns.intensity + 1} of {path} has no name and was read as intensity; if it is something "
        "else, name the columns in a first line.",
    )


def _unnamed_normals(path: Path, values: np.ndarray, columns: Columns) -> tuple[str, ...]:
    """Return a sentence on named columns that seem to be normals."""
    used = (*columns.used, *(columns.normals or ()))
    others = {f"column {n + 1}": values[:, n] for n in range(values.shape[1]) if n not in used}
    return () if columns.normals else unnamed_normals(path, others)


def _converted(path: Path, units: dict[str, str]) -> tuple[str, ...]:
    others = sorted({unit for unit in units.values() if factor_of(unit) != 1})
    return (
        (f"{path} gives coordinates in {' and '.join(others)}; they were converted to metres.",)
        if others
        else ()
    )


def _first_lines(path: Path, size: int) -> tuple[str, list[str]]:
    with path.open("rb") as stream:
        sample = stream.read(size)
        has_more = bool(stream.read(1))
    encoding = encoding_of(path, sample)
    lines = list(io.StringIO(sample.decode(encoding, errors="replace"), newline=None))
    if lines and lines[0].lower().startswith("ncols"):
        raise InputError(f"{path} is a raster grid, not a point cloud; choose the cloud itself.")
    return encoding, lines[:-1] if has_more else lines


def _middle(path: Path, xyz: np.ndarray) -> np.ndarray:
    finite = xyz[np.isfinite(xyz).all(axis=1)]
    if not len(finite):
        raise InputError(f"{path} has coordinates that are not numbers; export it again.")
    return np.median(finite, axis=0)
