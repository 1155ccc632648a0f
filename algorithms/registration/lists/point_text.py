"""Lists of points as text: x y z or name x y z, as surveyors, programs and spreadsheets write them."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ...errors import InputError
from ...tables.column_names import POINTS
from ...tables.degrees import degree_warning
from ...tables.dialect import (
    Dialect,
    decimal_signs,
    delimiter_and_width,
    ends_cut_off,
    is_comment,
    is_number,
    split,
)
from ...tables.encoding import read_lines
from ...tables.header import COORDINATES, Header, metres_of, read_preamble
from ...tables.remarks import unapplied_remarks
from ...tables.units import factor_of
from .covariances import CORRELATIONS, STDS, covariances_of, warnings_on
from .point_rows import Rows
from .settings import ListSettings

DELIMITERS = (";", "\t", ",", " ")
REMEDY = "name the columns in a first line, as 'name x y z' or 'x y z intensity'."


@dataclass(frozen=True)
class ListColumns:
    """The columns of the values, counted from 0.

    Attributes
    ----------
    name : tuple of int
        Several if blanks separate columns and occur in names too, as in 'Point #0'; empty without names.
    xyz : tuple of 3 int
    stds, correlations : tuple of 3 int, or empty
        Standard deviations and correlations of the coordinates.
    """

    name: tuple[int, ...]
    xyz: tuple[int, ...]
    stds: tuple[int, ...] = ()
    correlations: tuple[int, ...] = ()

    @property
    def used(self) -> tuple[int, ...]:
        """All columns that are read."""
        return (*self.name, *self.xyz, *self.stds, *self.correlations)


def read_text(path: Path, settings: ListSettings = ListSettings()) -> Rows:
    """Read a list of points from a text file.

    Raises
    ------
    InputError
        If the file is not a list of points, has a line that is not a point, or can be read in several ways.
    OSError
        If the system refuses to read it.
    """
    lines = read_lines(path, 2 * settings.most_points, "a list of points")
    delimiter, width = delimiter_and_width(path, lines)
    points = [not _is_remark(line, delimiter, width) and _numbers(line, delimiter) >= 3 for line in lines]
    first = points.index(True)
    _refuse_lost_points(path, lines[:first])
    ends_empty = not any(split(line, delimiter)[-1] for line, is_point in zip(lines, points) if is_point)
    header = read_preamble(path, lines[:first], delimiter, width, POINTS, ends_empty)
    numbered = [
        (number, line)
        for number, line in enumerate(lines[first:], start=first + 1)
        if not _is_remark(line, delimiter, width)
    ]
    if ends_cut_off([line for _, line in numbered], delimiter):
        raise InputError(
            f"Line {numbered[-1][0]} of {path}, the last, is cut off; copy or export the list again."
        )
    rows = {number: split(line, delimiter) for number, line in numbered}
    regular = [row for row in rows.values() if len(row) == width]
    columns = (
        _columns_by_name(header, regular)
        if header.columns
        else _columns_by_content(path, regular, delimiter, settings)
    )
    coordinates = [[row[column] for column in columns.xyz] for row in regular]
    signs = decimal_signs(path, coordinates, delimiter, bool(header.columns))
    dialect = Dialect(delimiter, signs[0], width, signs[1])
    _refuse_bad_rows(path, rows, dialect, columns)
    xyz = _numbers_in(columns.xyz, rows.values(), dialect)
    covariances, doubts = _covariances(path, columns, rows.values(), dialect, header, settings)
    return Rows(
        source=str(path),
        places=tuple(f"line {number}" for number in rows),
        names=_names(rows.values(), columns.name) if columns.name else None,
        xyz=xyz * header.factors(path),
        unit_stated=not header.units.keys().isdisjoint(COORDINATES),
        covariances=covariances,
        warnings=(
            *_converted(path, header),
            *unapplied_remarks(path, lines[:first], of_list=True),
            *doubts,
            *_warnings(path, rows.values(), columns),
            *_without_heights(path, xyz[:, 2]),
            *_marked(path, lines, delimiter, width),
            *degree_warning(path, coordinates, dialect),
        ),
    )


def _numbers_in(columns: tuple[int, ...], rows: Iterable[list[str]], dialect: Dialect) -> np.ndarray:
    return np.array([[dialect.number(row[column]) for column in columns] for row in rows])


def _covariances(
    path: Path,
    columns: ListColumns,
    rows: Iterable[list[str]],
    dialect: Dialect,
    header: Header,
    settings: ListSettings,
) -> tuple[Optional[np.ndarray], tuple[str, ...]]:
    """Return the covariances of the points, None if the file has no standard deviations, and warnings.

    Standard deviations without a unit have that of their coordinate.
    """
    if not columns.stds:
        return None, ()
    rows = list(rows)
    units = [header.units.get(std, header.units.get(axis)) for std, axis in zip(STDS, COORDINATES)]
    stds = _numbers_in(columns.stds, rows, dialect) * [metres_of(path, unit) for unit in units]
    correlations = np.zeros(stds.shape)
    if columns.correlations:
        correlations = _numbers_in(columns.correlations, rows, dialect)
    covariances = covariances_of(stds, correlations)
    return covariances, warnings_on(str(path), stds, covariances, settings)


def _converted(path: Path, header: Header) -> tuple[str, ...]:
    """Return a sentence on each unit other than metres that the header states."""
    groups = (("coordinates", COORDINATES), ("standard deviations", STDS))
    found = {
        (what, header.units[role])
        for what, roles in groups
        for role in roles
        if factor_of(header.units.get(role)) != 1
    }
    return tuple(
        f"{path} gives {what} in {unit}; they were converted to metres." for what, unit in sorted(found)
    )


def _is_remark(line: str, delimiter: str, width: int) -> bool:
    fields = split(line, delimiter)
    # A semicolon starts a remark, or a point whose name is missing.
    nameless = len(fields) == width and fields[:1] == [""] and _numbers(line, delimiter) >= 3
    return is_comment(line) and not nameless


def _numbers(line: str, delimiter: str) -> int:
    return sum(map(is_number, split(line, delimiter)))


def _refuse_lost_points(path: Path, preamble: list[str]) -> None:
    """Refuse a point, cut off or with another delimiter, that would be taken for a title."""
    for number, line in enumerate(preamble, start=1):
        if not is_comment(line) and any(_numbers(line, delimiter) > 1 for delimiter in DELIMITERS):
            raise InputError(
                f"Line {number} of {path} is neither a point like those below nor a header; "
                "correct it, or put # before it."
            )


def _columns_by_name(header: Header, rows: list[list[str]]) -> ListColumns:
    columns = header.columns
    xyz = (columns["x"], columns["y"], columns["z"])
    name = columns.get("name", _unknown_names(rows, tuple(columns.values())))
    stds, correlations = (
        tuple(columns[role] for role in roles) if set(roles) <= columns.keys() else ()
        for roles in (STDS, CORRELATIONS)
    )
    return ListColumns(() if name is None else (name,), xyz, stds, correlations if stds else ())


def _unknown_names(rows: list[list[str]], known: tuple[int, ...]) -> Optional[int]:
    """Return the first column if its heading is unknown, but its words or whole numbers are all different."""
    labels = _column(rows, 0)
    words = all(label and (label.isdecimal() or not is_number(label)) for label in labels)
    return 0 if 0 not in known and words and len(set(labels)) == len(labels) > 1 else None


def _columns_by_content(
    path: Path, rows: list[list[str]], delimiter: str, settings: ListSettings
) -> ListColumns:
    """Distinguish names from coordinates by the content of `rows`, which have one width."""
    # Six whole numbers between commas may be three with decimal commas; fewer cannot.
    if delimiter == "," and len(rows[0]) > 5:
        decimal_signs(path, rows, delimiter, False)
    shares = np.mean([[is_number(field) for field in row] for row in rows], axis=0)
    numeric = np.flatnonzero(shares >= settings.least_numeric_share).tolist()
    if len(numeric) < 3:
        raise InputError(f"{path} has fewer than three columns of numbers; export it as name x y z.")
    name = list(range(numeric[0]))
    texts = {tuple(row[column] for column in name) for row in rows}
    named = len(rows) > 1 and len(texts) == len(rows)
    if len(numeric) > 3 and not named and _are_names(path, rows, numeric):
        name.append(numeric.pop(0))
    elif len(numeric) == 3 and not name:
        _refuse_missing_heights(path, rows, numeric)
    if len(name) > 1 and delimiter != " ":
        raise InputError(f"It is not clear which column of {path} holds the names; {REMEDY}")
    return ListColumns(tuple(name), tuple(numeric[:3]))


def _are_names(path: Path, rows: list[list[str]], numeric: list[int]) -> bool:
    """Return whether the first of four or more columns of numbers holds names, not coordinates."""
    labels = _column(rows, numeric[0])
    numbers = [label for label in labels if is_number(label)]
    whole = [label for label in numbers if label.isdecimal()]
    some_are_words = len(numbers) < len(labels)
    if len(whole) == len(numbers):
        padded = any(label.startswith("0") and len(label) > 1 for label in whole)
        fractional = all(_have_decimals(rows, column) for column in numeric[1:4])
        if some_are_words or padded or fractional or _count_up(labels):
            return True
    # Some programs write 5 for 5.0, but then in the third coordinate as well.
    elif not some_are_words and (not whole or not _have_decimals(rows, numeric[3])):
        return False
    raise InputError(f"The first column of {path} can be names or coordinates; {REMEDY}")


def _refuse_missing_heights(path: Path, rows: list[list[str]], numeric: list[int]) -> None:
    fractional = all(_have_decimals(rows, column) for column in numeric[1:])
    if fractional and _count_up(_column(rows, numeric[0])):
        raise InputError(
            f"{path} seems to hold numbers of points with x and y but no z; add the heights, "
            "or name the columns in a first line, as 'x y z'."
        )


def _column(rows: list[list[str]], column: int) -> list[str]:
    return [row[column] for row in rows]


def _have_decimals(rows: list[list[str]], column: int) -> bool:
    return any("." in field or "," in field for field in _column(rows, column))


def _count_up(labels: list[str]) -> bool:
    """Return whether labels count the rows, from 0 or 1."""
    counts = [[str(row + start) for row in range(len(labels))] for start in (0, 1)]
    return len(labels) > 2 and labels in counts


def _refuse_bad_rows(path: Path, rows: dict[int, list[str]], dialect: Dialect, columns: ListColumns) -> None:
    after = max(columns.used) + 1
    regular = [row for row in rows.values() if len(row) == dialect.width]
    remarks = not any(_has_number(row, after) for row in regular)
    for number, row in rows.items():
        problem = _problem(
            row, dialect, columns, remarks and len(row) >= after and not _has_number(row, after)
        )
        if problem:
            raise InputError(f"Line {number} of {path} {problem}; correct or remove that line.")


def _has_number(row: list[str], column: int) -> bool:
    return len(row) > column and is_number(row[column])


def _problem(row: list[str], dialect: Dialect, columns: ListColumns, only_remarks_follow: bool) -> str:
    """Return what is wrong with a row, or nothing."""
    if len(row) != dialect.width and not only_remarks_follow:
        return f"has {len(row)} columns instead of {dialect.width}"
    for column in columns.xyz:
        if not np.isfinite(dialect.number(row[column])):
            return f"has '{row[column]}' where a number is expected"
    if not all(row[column] for column in columns.name):
        return "has no name"
    return ""


def _names(rows: Iterable[list[str]], columns: tuple[int, ...]) -> tuple[str, ...]:
    return tuple(" ".join(row[column] for column in columns) for row in rows)


def _warnings(path: Path, rows: Iterable[list[str]], columns: ListColumns) -> tuple[str, ...]:
    left_out = any(field for row in rows for column, field in enumerate(row) if column not in columns.used)
    read = "name, x, y and z" if columns.name else "x, y and z"
    if columns.stds:
        read += ", and their standard deviations,"
    return (f"Only {read} of {path} were read; its further columns were left out.",) if left_out else ()


def _without_heights(path: Path, heights: np.ndarray) -> tuple[str, ...]:
    """Return a sentence if all heights are 0, as programs write those that are not known."""
    if len(heights) < 2 or np.any(heights != 0):
        return ()
    return (f"All heights in {path} are 0; if they are not known, add them.",)


def _marked(path: Path, lines: list[str], delimiter: str, width: int) -> tuple[str, ...]:
    """Return a sentence on remarks that look like the points."""
    marked = []
    for number, line in enumerate(lines, start=1):
        if _is_remark(line, delimiter, width):
            readings = (line, line.lstrip(" \t#/;"))
            if any(_is_shaped_as_point(text, delimiter, width) for text in readings):
                marked.append(number)
    if not marked:
        return ()
    return (
        f"{len(marked)} rows of {path}, the first in line {marked[0]}, begin as remarks do and were left "
        "out; remove the sign before them if they are points.",
    )


def _is_shaped_as_point(line: str, delimiter: str, width: int) -> bool:
    return len(split(line, delimiter)) == width and _numbers(line, delimiter) >= 3
