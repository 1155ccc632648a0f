"""Tables whose first line names the columns."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from ..errors import InputError
from .column_names import Roles, recognised, simplified
from .dialect import Dialect, decimal_signs, ends_cut_off, is_comment, is_number, split, stated_delimiter
from .encoding import read_lines
from .header import header_fields, metres_of, partly_stated, refuse_double_names, stated_unit
from .units import as_unit, factor_of, is_unit, unit_of

DELIMITERS = (";", "\t", "|", ",", " ")

MOST_LINES = 100_000
"""More than any table has that somebody measures or draws."""

MOST_TITLES = 20
"""Lines of titles that may precede the names of the columns."""


@dataclass(frozen=True)
class NamedTable:
    """The rows of a table.

    Attributes
    ----------
    path : Path
    columns : dict of str to int
        The column of each known role.
    rows : dict of int to list of str
        The fields of each row by the number of its line.
    dialect : Dialect
    units : dict of str to str
        The units that the header states, by role.
    warnings : tuple of str
        What the user should know about the file, in sentences.
    """

    path: Path
    columns: dict[str, int]
    rows: dict[int, list[str]]
    dialect: Dialect
    units: dict[str, str]
    warnings: tuple[str, ...] = ()

    def text(self, line: int, role: str) -> str:
        """Return a field as it is written; empty if there is no such column."""
        return self.rows[line][self.columns[role]] if role in self.columns else ""

    def metres(self, role: str) -> float:
        """Return how many metres the unit of a column is, 1 if none is stated.

        Raises
        ------
        InputError
            If it is not metric.
        """
        return metres_of(self.path, self.units.get(role))


def read_named_table(path: Path, roles: Roles, needed: Sequence[str], numbers: Sequence[str]) -> NamedTable:
    """Read a table of any encoding, separator and decimal sign, whose columns have names of `roles`.

    Parameters
    ----------
    path : Path
    roles : mapping of str to tuple of str
        The names of each role.
    needed, numbers : sequence of str
        The roles that must be there, and those that hold numbers.

    Raises
    ------
    InputError
        If the file cannot be read, a needed column is missing, or a row has another number of fields than the
        header, or remarks state several units.
    """
    try:
        lines = read_lines(path, MOST_LINES, "a table of lengths")
    except OSError as error:
        reason = error.strerror or error
        raise InputError(
            f"{path} cannot be read ({reason}); check that it exists and that you may read it."
        ) from error
    heading = _heading(lines, roles, needed)
    delimiter, names = _header(path, lines, heading, roles, needed)
    columns = recognised(names, roles)
    refuse_double_names(path, names, columns, (*needed, *numbers))
    _refuse_two_columns(path, names, roles, numbers)
    numbered = {
        number: line
        for number, line in enumerate(lines[heading + 1 :], start=heading + 2)
        if not is_comment(line) or line.lstrip().startswith(";")
    }
    rows = {number: _row(path, number, split(line, delimiter), names) for number, line in numbered.items()}
    rows = {number: row for number, row in rows.items() if any(row)}
    units = {role: unit for role, column in columns.items() if (unit := unit_of(names[column]))}
    first = next(iter(rows.values()), [""])
    if any(map(is_unit, first)) and not any(map(is_number, first)):
        rows.pop(next(iter(rows)))
        units.update((role, unit) for role, column in columns.items() if (unit := as_unit(first[column])))
    measured = [role for role in numbers if role in columns]
    stated = stated_unit(path, lines[:heading])
    units = {**dict.fromkeys(measured, stated), **units} if stated else units
    if len({factor_of(units.get(role)) for role in measured}) > 1 and not set(measured) <= units.keys():
        raise partly_stated(path)
    if ends_cut_off(list(numbered.values()), delimiter):
        raise InputError(f"The number at the end of {path} is cut off; copy or export it again.")
    fields = [[row[columns[role]] for role in measured] for row in rows.values()]
    if delimiter == "," and not units and _may_be_decimals(fields):
        raise InputError(
            f"The commas in {path} can be decimal signs or separators; separate the columns by semicolons, "
            "or write decimal points."
        )
    decimal, thousands = decimal_signs(path, fields, delimiter, True) if fields else (".", "")
    return NamedTable(
        path, columns, rows, Dialect(delimiter, decimal, len(names), thousands), units, _marked(path, lines)
    )


def _refuse_two_columns(path: Path, names: Sequence[str], roles: Roles, numbers: Sequence[str]) -> None:
    """Refuse two names of one number, such as width and Breite."""
    for role in numbers:
        same = [name for name in names if simplified(name) in roles[role]]
        if len(same) > 1:
            raise InputError(f"{path} has {same[0]} and {same[1]} for one length; rename what is not wanted.")


def _heading(lines: list[str], roles: Roles, needed: Sequence[str]) -> int:
    """Return the first line that names what is needed, such as that below a title; or else the first line."""
    wanted = [index for index, line in enumerate(lines[:MOST_TITLES]) if not is_comment(line)]
    for index in wanted:
        for sign in DELIMITERS:
            if set(needed) <= recognised(header_fields(lines[index], sign), roles).keys():
                return index
    return wanted[0] if wanted else 0


def _may_be_decimals(rows: list[list[str]]) -> bool:
    """Whether all lengths are short whole numbers, so that pairs may be numbers with decimal commas."""
    fields = [field for row in rows for field in row if field]
    return bool(fields) and len(rows[0]) > 1 and all(re.fullmatch(r"\d{1,2}", field) for field in fields)


def _marked(path: Path, lines: list[str]) -> tuple[str, ...]:
    """Return a sentence on remarks that look like rows."""
    marked = [
        number
        for number, line in enumerate(lines, start=1)
        if is_comment(line)
        and not line.lstrip().startswith(";")
        and any(sum(map(is_number, split(line, sign))) > 1 for sign in DELIMITERS)
    ]
    if not marked:
        return ()
    return (
        f"{len(marked)} rows of {path}, the first in line {marked[0]}, begin as remarks do and were left "
        "out; remove the sign before them if they are wanted.",
    )


def _header(
    path: Path, lines: list[str], heading: int, roles: Roles, needed: Sequence[str]
) -> tuple[str, list[str]]:
    """Return the delimiter by which the first line has most known names, and its fields."""
    line = lines[heading] if heading < len(lines) else ""
    stated: Optional[str] = stated_delimiter(lines)
    candidates = (stated,) if stated else DELIMITERS
    delimiter = max(candidates, key=lambda sign: len(recognised(header_fields(line, sign), roles)))
    names = header_fields(line, delimiter)
    while len(names) > 1 and not names[-1]:
        names.pop()
    missing = [name for name in needed if name not in recognised(names, roles)]
    if missing:
        raise InputError(f"{path} has no column {', '.join(missing)}; add or rename it.")
    return delimiter, names


def _row(path: Path, number: int, fields: list[str], names: list[str]) -> list[str]:
    """Return the fields of a row, as many as there are names; there may be more empty ones at its end."""
    surplus = fields[len(names) :]
    if any(surplus) or (len(fields) < len(names) and any(fields)):
        raise InputError(
            f"Line {number} of {path} has {len(fields)} fields where the header names {len(names)} columns; "
            "correct that line, or write decimal points if the separator is a comma."
        )
    return fields[: len(names)] if any(fields) else [""]
