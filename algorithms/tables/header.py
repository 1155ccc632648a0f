"""The lines before the first row: names of columns with their units, and how many points follow."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

from ..errors import InputError
from .column_names import CLOUD, DEGREES, Roles, recognised, simplified
from .dialect import is_comment, is_count, is_number, split
from .units import as_unit, factor_of, is_unit, unit_of, unit_of_remark

COORDINATES = ("x", "y", "z")
LENGTHS = (*COORDINATES, "sx", "sy", "sz")
"""The roles that have units: coordinates and their standard deviations."""

BESIDE_OTHERS = frozenset(("e", "n", "points:0", "points:1", "cartesianx", "cartesiany"))
"""Names that are no second coordinates beside others: single letters are often numbers or errors, and the
positions of ParaView and earth-centred ones accompany those that are meant."""


@dataclass(frozen=True)
class Header:
    """What the lines before the first row say.

    Attributes
    ----------
    columns : dict of str to int
        The column of each known role; empty without names.
    units : dict of str to str
        The stated units of `LENGTHS`, by role.
    announced : int or None
        Number of points; None without such a line.
    names : tuple of str
        Of all columns, as they are written; empty without names.
    """

    columns: dict[str, int] = field(default_factory=dict)
    units: dict[str, str] = field(default_factory=dict)
    announced: Optional[int] = None
    names: tuple[str, ...] = ()

    def factors(self, path: Path) -> tuple[float, float, float]:
        """Return how many metres the units of the coordinates are.

        Raises
        ------
        InputError
            If a unit is not metric.
        """
        x, y, z = (metres_of(path, self.units.get(role)) for role in COORDINATES)
        return x, y, z


def metres_of(path: Path, unit: Optional[str]) -> float:
    """Return how many metres a unit is that a header states, 1 if it states none.

    Raises
    ------
    InputError
        If it is not metric.
    """
    factor = factor_of(unit)
    if factor is None:
        raise InputError(f"The header of {path} gives lengths in {unit}; convert them to metres.")
    return factor


def read_preamble(
    path: Path,
    lines: list[str],
    delimiter: str,
    width: int,
    roles: Roles = CLOUD,
    ends_with_delimiter: bool = False,
) -> Header:
    """Return what the lines before the first row say.

    Parameters
    ----------
    path : Path
    lines : list of str
    delimiter : str
    width : int
        Number of columns of the rows.
    roles : mapping of str to tuple of str
        The names of each role.
    ends_with_delimiter : bool
        Whether the rows end with a delimiter, and so with an empty column that needs no name.

    Raises
    ------
    InputError
        If a line with names does not name the columns, or names one twice; if a line of numbers has another
        number of columns or is not a row; if a unit is stated for some of the coordinates only; or if remarks
        state several.
    """
    columns: dict[str, int] = {}
    units: dict[str, str] = {}
    stated = stated_unit(path, lines)
    announced = None
    names: tuple[str, ...] = ()
    for number, line in enumerate(lines, start=1):
        fields = header_fields(line, delimiter)
        if ends_with_delimiter and len(fields) == width - 1:
            fields.append("")
        if len(fields) == width + 1 and not fields[-1]:
            fields.pop()
        remark = unit_of_remark(line)
        if is_count(line):
            announced = (announced or 0) + int(line)
        elif len(fields) == width:
            found = _named(fields, roles)
            refuse_double_names(path, fields, found, COORDINATES)
            _refuse_two_systems(path, fields, roles)
            if found:
                columns, units, names = found, _units_of(fields, found), tuple(fields)
            if columns and not found and _is_line_of_units(fields):
                units = {role: as_unit(fields[columns[role]]) or "m" for role in LENGTHS if role in columns}
                continue
        if remark or is_count(line) or (is_comment(line) and not _speaks_of_degrees(fields)):
            continue
        if all(map(is_number, fields)):
            raise InputError(
                f"{path} has {len(fields)} columns in line {number} where most lines have "
                f"{width}; correct or remove that line."
            )
        named = _named(fields, roles)
        if columns and not named and re.search(r"\d", line):
            raise InputError(
                f"Line {number} of {path}, below the names of the columns, is not a row of numbers; correct "
                "or remove that line."
            )
        if (named and len(fields) != width) or (len(fields) == width and not columns):
            raise _unclear_header(path, number, fields, width)
    if stated:
        units = {**dict.fromkeys(COORDINATES, stated), **units}
    of_coordinates = [units[role] for role in COORDINATES if role in units]
    if len(of_coordinates) < len(COORDINATES) and any(factor_of(unit) != 1 for unit in of_coordinates):
        raise partly_stated(path)
    return Header(columns, units, announced, names)


def stated_unit(path: Path, lines: Iterable[str]) -> Optional[str]:
    """Return the unit that remarks state for all lengths, None without one.

    Raises
    ------
    InputError
        If they state several, because each would give other lengths.
    """
    stated = {factor_of(unit): unit for unit in map(unit_of_remark, lines) if unit}
    if len(stated) > 1:
        raise InputError(
            f"The remarks in {path} state several units, {' and '.join(stated.values())}; correct them."
        )
    return next(iter(stated.values()), None)


def partly_stated(path: Path) -> InputError:
    """Return the error for a header that states the unit of some of the lengths only."""
    return InputError(
        f"The header of {path} states the unit of some columns only; write it into the name of each column."
    )


def refuse_double_names(
    path: Path, fields: Sequence[str], columns: Mapping[str, int], roles: Sequence[str]
) -> None:
    """Refuse a header in which another column has the same name as that of a role.

    Raises
    ------
    InputError
    """
    names = [simplified(field) for field in fields]
    for role in roles:
        if role in columns and names.count(names[columns[role]]) > 1:
            raise InputError(
                f"{path} has several columns called {fields[columns[role]]}; rename those that are not "
                "wanted."
            )


def _refuse_two_systems(path: Path, fields: list[str], roles: Roles) -> None:
    """Refuse two names of one horizontal coordinate; a second height may be that of a target."""
    keys = [simplified(field) for field in fields]
    letters = {"e", "n"} if {"e", "n", "h"} <= set(keys) else set()
    ignored = BESIDE_OTHERS - letters
    for role in COORDINATES[:2]:
        names = [field for field, key in zip(fields, keys) if key in roles[role] and key not in ignored]
        if len(names) > 1:
            raise InputError(
                f"{path} has {names[0]} and {names[1]} for one coordinate; rename what is not wanted."
            )


def header_fields(line: str, delimiter: str) -> list[str]:
    """Return the fields of a line of names; a unit in brackets belongs to the name before it."""
    text = line.strip().lstrip("#/;").strip()
    if delimiter == " ":
        text = text.replace(" [", "[").replace(" (", "(").replace("\t[", "[").replace("\t(", "(")
    return split(text, delimiter)


def _named(fields: list[str], roles: Roles) -> dict[str, int]:
    """Return the column of every known name; nothing unless x, y and z are among them."""
    found = recognised(fields, roles)
    return found if set(COORDINATES) <= found.keys() else {}


def _units_of(fields: list[str], columns: dict[str, int]) -> dict[str, str]:
    units = {role: unit_of(fields[columns[role]]) for role in LENGTHS if role in columns}
    return {role: unit for role, unit in units.items() if unit}


def _is_line_of_units(fields: list[str]) -> bool:
    return any(map(is_unit, fields)) and all(is_unit(item) or not item.strip("-[]()") for item in fields)


def _speaks_of_degrees(fields: list[str]) -> bool:
    # A single such word may be prose, as in "the long wall".
    return len(DEGREES & {simplified(item) for item in fields}) > 1


def _unclear_header(path: Path, number: int, fields: list[str], width: int) -> InputError:
    if DEGREES & {simplified(item) for item in fields}:
        return InputError(
            f"{path} has geographic coordinates in degrees; "
            "reproject it to a projected coordinate reference system in metres."
        )
    return InputError(
        f"The header in line {number} of {path} does not name the {width} columns of the lines "
        "below; name them, with x, y and z or easting, northing and height among them."
    )
