"""The lists of lengths that are compared: a schedule, and what was measured by hand."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from ..errors import InputError
from ..tables.column_names import LENGTHS, simplified
from ..tables.named_table import NamedTable, read_named_table

DIMENSIONS = ("width", "height", "sill")
DEVIATIONS = {"width": "width_std", "height": "height_std"}
NUMBERS = (*DIMENSIONS, *DEVIATIONS.values(), "length")


class MeasuredLength(NamedTuple):
    """A length of a detail.

    Attributes
    ----------
    id : str
    dimension : str
        One of `DIMENSIONS`.
    length : float
        In metres.
    std : float
        Its standard deviation (m); nan if it is not known.
    """

    id: str
    dimension: str
    length: float
    std: float = math.nan


@dataclass(frozen=True)
class LengthList:
    """Lengths in the order of their file.

    Attributes
    ----------
    source : str
        What messages call it.
    lengths : tuple of MeasuredLength
    warnings : tuple of str
    """

    source: str
    lengths: tuple[MeasuredLength, ...]
    warnings: tuple[str, ...] = ()


def read_schedule(path: Path) -> LengthList:
    """Read a table with id, width, height and sill, and width_std and height_std if there are any, in metres.

    Raises
    ------
    InputError
        If the file cannot be read, lacks a column, or holds something that is not a number.
    """
    table = read_named_table(path, LENGTHS, ("id", "width", "height"), NUMBERS)
    lengths: list[MeasuredLength] = []
    for line in table.rows:
        for dimension in DIMENSIONS:
            value = _number(table, line, dimension, dimension)
            if math.isfinite(value):
                _refuse_repeated(table, line, dimension, lengths)
                std = _number(table, line, DEVIATIONS.get(dimension, ""), dimension)
                lengths.append(MeasuredLength(table.text(line, "id"), dimension, value, std))
    return LengthList(str(path), tuple(lengths), _converted(table))


def read_reference(path: Path) -> LengthList:
    """Read lengths that were measured by hand, in metres or in the unit that the header states.

    Parameters
    ----------
    path : Path
        Table with id and some of width, height and sill, empty where not measured; or with id, dimension and
        length. The names may be English, German, French, Italian or Spanish.

    Raises
    ------
    InputError
        If the file cannot be read, lacks a column, or holds something that is not a number.
    """
    table = read_named_table(path, LENGTHS, ("id",), NUMBERS)
    lengths = []
    for line in table.rows:
        for dimension, role in _dimensions(table, line):
            value = _number(table, line, role, dimension)
            if math.isfinite(value):
                lengths.append(MeasuredLength(table.text(line, "id"), dimension, value))
    return LengthList(str(path), tuple(lengths), _converted(table))


def _converted(table: NamedTable) -> tuple[str, ...]:
    units = sorted({unit for role, unit in table.units.items() if table.metres(role) != 1})
    return table.warnings + tuple(
        f"{table.path} gives lengths in {unit}; they were converted to metres." for unit in units
    )


def _dimensions(table: NamedTable, line: int) -> list[tuple[str, str]]:
    """Return the dimensions of a row and the columns that hold them, in whichever of the two layouts."""
    if {"dimension", "length"} <= table.columns.keys():
        written = table.text(line, "dimension")
        dimension = next((name for name in DIMENSIONS if simplified(written) in LENGTHS[name]), None)
        if dimension is None:
            raise InputError(
                f"Line {line} of {table.path}: the dimension must be width, height or sill, not {written}."
            )
        return [(dimension, "length")]
    pairs = [(dimension, dimension) for dimension in DIMENSIONS if dimension in table.columns]
    if not pairs:
        raise InputError(
            f"{table.path} has no lengths; name its columns id, width, height and sill, or id, dimension and "
            "length."
        )
    return pairs


def _refuse_repeated(table: NamedTable, line: int, dimension: str, before: list[MeasuredLength]) -> None:
    """Refuse a schedule that lists a length twice, because only one of them could be compared."""
    name = table.text(line, "id")
    if any(item.id == name and item.dimension == dimension for item in before):
        raise InputError(
            f"Line {line} of {table.path}: the {dimension} of {name} is listed twice; remove one entry."
        )


def _number(table: NamedTable, line: int, role: str, name: str) -> float:
    """Return a length in metres; nan if its field is empty or there is no such column."""
    text = table.text(line, role)
    if not text:
        return math.nan
    value = table.dialect.number(text) * table.metres(role)
    # Only a sill may lie at the ground or below it.
    if not math.isfinite(value) or (value <= 0 and name != "sill"):
        raise InputError(f"Line {line} of {table.path}: the {name} {text} is not a length in metres.")
    return value
