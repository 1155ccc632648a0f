"""The lists of lengths that are compared: a schedule, and what was measured by hand."""

import csv
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple, Optional

from ..errors import InputError

DIMENSIONS = ("width", "height", "sill")
DEVIATIONS = {"width": "width_std", "height": "height_std"}
LONG = ("id", "dimension", "length")


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
    """

    source: str
    lengths: tuple[MeasuredLength, ...]


def read_schedule(path: Path) -> LengthList:
    """Read a csv with id, width, height and sill, and width_std and height_std if there are any, in metres.

    Raises
    ------
    InputError
        If the file cannot be read, lacks a column, or holds something that is not a number.
    """
    lengths = []
    for row, line in _rows(path, ("id", "width", "height")):
        for dimension in DIMENSIONS:
            value = _number(path, line, dimension, row.get(dimension, ""))
            if value is not None:
                column = DEVIATIONS.get(dimension, "")
                std = _number(path, line, column, row.get(column, ""))
                lengths.append(MeasuredLength(row["id"], dimension, value, math.nan if std is None else std))
    return LengthList(str(path), tuple(lengths))


def read_reference(path: Path) -> LengthList:
    """Read lengths that were measured by hand, in metres.

    Parameters
    ----------
    path : Path
        csv with id and some of width, height and sill, empty where not measured; or with id, dimension and
        length. Separated by commas, or by semicolons, then also with decimal commas.

    Raises
    ------
    InputError
        If the file cannot be read, lacks a column, or holds something that is not a number.
    """
    lengths = []
    for row, line in _rows(path, ("id",)):
        for dimension, text in _dimensions(path, row, line):
            value = _number(path, line, dimension, text)
            if value is not None:
                lengths.append(MeasuredLength(row["id"], dimension, value))
    return LengthList(str(path), tuple(lengths))


def _dimensions(path: Path, row: dict[str, str], line: int) -> list[tuple[str, str]]:
    """Return the dimensions and lengths of a row, in whichever of the two layouts."""
    if set(LONG) <= row.keys():
        dimension = row["dimension"].lower()
        if dimension not in DIMENSIONS:
            raise InputError(
                f"Line {line} of {path}: the dimension must be width, height or sill, not {dimension}."
            )
        return [(dimension, row["length"])]
    pairs = [(dimension, row[dimension]) for dimension in DIMENSIONS if dimension in row]
    if not pairs:
        raise InputError(
            f"{path} has no lengths; name its columns id, width, height and sill, or id, dimension and "
            "length."
        )
    return pairs


def _rows(path: Path, needed: Sequence[str]) -> Iterator[tuple[dict[str, str], int]]:
    """Yield the rows of a csv by the names of its columns, in lower case, and their lines."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path} cannot be read as a csv file ({error}); check the file.") from error
    lines = text.splitlines()
    separator = ";" if lines and ";" in lines[0] else ","
    reader = csv.reader(lines, delimiter=separator)
    header = [name.strip().lower() for name in next(reader, [])]
    missing = [name for name in needed if name not in header]
    if missing:
        raise InputError(f"{path} has no column {' and no column '.join(missing)}; add or rename it.")
    for fields in reader:
        if any(field.strip() for field in fields):
            yield dict(zip(header, (field.strip() for field in fields))), reader.line_num


def _number(path: Path, line: int, name: str, text: Optional[str]) -> Optional[float]:
    if not text:
        return None
    try:
        value = float(text.replace(",", "."))
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"Line {line} of {path}: the {name} {text} is not a length in metres.")
    return value
