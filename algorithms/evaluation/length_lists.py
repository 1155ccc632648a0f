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
        Of the detail, as '7 of facade 2' where the list has several facades.
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

    The schedule of several facades has a column facade too.

    Raises
    ------
    InputError
        If the file cannot be read, lacks a column, lists a length twice, or holds something that is not a
        number.
    """
    table = read_named_table(path, LENGTHS, ("id", "width", "height"), NUMBERS)
    lengths: dict[tuple[str, str], MeasuredLength] = {}
    for line in table.rows:
        name = _id(table, line)
        for dimension in DIMENSIONS:
            value = _number(table, line, dimension, dimension)
            if not math.isfinite(value):
                continue
            # Only one of them could be compared.
            if (name, dimension) in lengths:
                raise InputError(
                    f"Line {line} of {path}: the {dimension} of {name} is listed twice; remove one entry."
                )
            std = _deviation(table, line, DEVIATIONS.get(dimension, ""))
            lengths[name, dimension] = MeasuredLength(name, dimension, value, std)
    return LengthList(str(path), tuple(lengths.values()), _converted(table))


def read_reference(path: Path) -> LengthList:
    """Read lengths that were measured by hand, in metres or in the unit that the header states.

    Parameters
    ----------
    path : Path
        Table with id and some of width, height and sill, empty where not measured; or with id, dimension and
        length; and facade where the schedule has it. The names may be English, German, French, Italian or
        Spanish.

    Raises
    ------
    InputError
        If the file cannot be read, lacks a column, or holds something that is not a number.
    """
    table = read_named_table(path, LENGTHS, ("id",), NUMBERS)
    lengths: list[MeasuredLength] = []
    for line in table.rows:
        for dimension, role in _dimensions(table, line):
            value = _number(table, line, role, dimension)
            if math.isfinite(value):
                lengths.append(MeasuredLength(_id(table, line), dimension, value))
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


def _id(table: NamedTable, line: int) -> str:
    """Return the id of the detail in a row; each facade of a common schedule counts its own."""
    name, facade = table.text(line, "id"), table.text(line, "facade")
    if not name:
        raise InputError(f"Line {line} of {table.path} has no id; add the one of its detail.")
    return f"{name} of facade {facade}" if facade else name


def _number(table: NamedTable, line: int, role: str, name: str) -> float:
    """Return a length in metres; nan if its field is empty or there is no such column."""
    value = _metres(table, line, role)
    # Only a sill may lie at the ground or below it.
    if math.isinf(value) or (value <= 0 and name != "sill"):
        raise InputError(
            f"Line {line} of {table.path}: the {name} {table.text(line, role)} is not a length in metres."
        )
    return value


def _deviation(table: NamedTable, line: int, role: str) -> float:
    """Return a standard deviation in metres; nan if it is not known."""
    value = _metres(table, line, role)
    if math.isinf(value) or value < 0:
        raise InputError(
            f"Line {line} of {table.path}: the {role} {table.text(line, role)} is not a standard deviation."
        )
    return value


def _metres(table: NamedTable, line: int, role: str) -> float:
    """Return a number in metres; nan if its field is empty, infinite if it is not a number."""
    text = table.text(line, role)
    value = table.dialect.number(text) * table.metres(role)
    return math.inf if text and not math.isfinite(value) else value
