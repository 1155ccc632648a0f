"""Compare the lengths of a schedule with lengths measured by hand, as table 1 of the facade paper."""

import csv
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np
import pandas as pd

from ..errors import InputError, NothingFoundError
from ..files import atomic_output

DIMENSIONS = ("width", "height", "sill")
DEVIATIONS = {"width": "width_std", "height": "height_std"}
LONG = ("id", "dimension", "length")


@dataclass(frozen=True)
class Length:
    """A length, measured twice.

    Attributes
    ----------
    id : str
        Of the detail.
    dimension : str
        One of `DIMENSIONS`.
    automatic, manual : float
        In metres.
    std : float
        Standard deviation of the automatic one (m); nan if it is not known.
    """

    id: str
    dimension: str
    automatic: float
    manual: float
    std: float

    @property
    def difference(self) -> float:
        """Automatic minus manual (m)."""
        return self.automatic - self.manual


@dataclass(frozen=True)
class LengthComparison:
    """All lengths that were measured twice.

    Attributes
    ----------
    lengths : tuple of Length
        In the order of the reference.
    warnings : tuple of str
        What of the reference has no match, in sentences.
    """

    lengths: tuple[Length, ...]
    warnings: tuple[str, ...]

    @property
    def differences(self) -> np.ndarray:
        """Automatic minus manual, shape (n,) (m)."""
        return np.array([length.difference for length in self.lengths])

    @property
    def mean(self) -> float:
        """Mean of the differences (m)."""
        return float(self.differences.mean())

    @property
    def std(self) -> float:
        """Standard deviation of the differences (m); nan of a single one."""
        return float(self.differences.std(ddof=1)) if len(self.lengths) > 1 else math.nan

    @property
    def largest(self) -> float:
        """The largest absolute difference (m)."""
        return float(np.abs(self.differences).max())


def compare_lengths(schedule: Path, reference: Path) -> LengthComparison:
    """Pair the lengths of a reference with those of a schedule by id and dimension.

    Parameters
    ----------
    schedule : Path
        csv with id, width, height and sill, and width_std and height_std if there are any, in metres.
    reference : Path
        csv with id and some of width, height and sill, empty where not measured; or with id, dimension and
        length. Separated by commas, or by semicolons, then also with decimal commas.

    Raises
    ------
    InputError
        If a file cannot be read, lacks a column, or holds what is no number.
    NothingFoundError
        If no length is in both.
    """
    known = {}
    for row, line in _rows(Path(schedule), ("id", "width", "height")):
        for dimension in DIMENSIONS:
            value = _number(schedule, line, dimension, row.get(dimension, ""))
            if value is not None:
                std = _number(
                    schedule, line, DEVIATIONS.get(dimension, ""), row.get(DEVIATIONS.get(dimension), "")
                )
                known[row["id"], dimension] = value, math.nan if std is None else std
    lengths, unknown = [], []
    for number, dimension, manual in _reference(Path(reference)):
        if (number, dimension) in known:
            automatic, std = known[number, dimension]
            lengths.append(Length(number, dimension, automatic, manual, std))
        else:
            unknown.append(f"{dimension} of {number}")
    if not lengths:
        raise NothingFoundError(
            f"No length of {reference} is in {schedule}; the ids of both must be those of the schedule."
        )
    warnings = (f"{schedule} does not have {', '.join(unknown)}.",) if unknown else ()
    return LengthComparison(tuple(lengths), warnings)


def write_table(path: Path, comparison: LengthComparison) -> None:
    """Write the lengths as csv.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    rows = [
        (item.id, item.dimension, item.automatic, item.manual, round(item.difference, 5), item.std)
        for item in comparison.lengths
    ]
    columns = ["id", "dimension", "automatic", "manual", "difference", "std"]
    with atomic_output(path) as temporary:
        pd.DataFrame(rows, columns=columns).to_csv(temporary, index=False, lineterminator="\n")


def _reference(path: Path) -> Iterator[tuple[str, str, float]]:
    """Yield id, dimension and length, of whichever of the two layouts."""
    for row, line in _rows(path, ("id",)):
        if set(LONG) <= row.keys():
            dimension = row["dimension"].lower()
            if dimension not in DIMENSIONS:
                raise InputError(
                    f"Line {line} of {path}: the dimension must be width, height or sill, not {dimension}."
                )
            pairs = [(dimension, row["length"])]
        else:
            pairs = [(dimension, row[dimension]) for dimension in DIMENSIONS if dimension in row]
            if not pairs:
                raise InputError(
                    f"{path} has no lengths; name its columns id, width, height and sill, or id, dimension "
                    "and length."
                )
        for dimension, text in pairs:
            value = _number(path, line, dimension, text)
            if value is not None:
                yield row["id"], dimension, value


def _rows(path: Path, needed: tuple) -> Iterator[tuple[dict, int]]:
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
        raise InputError(f"{path} has no column {' and no column '.join(missing)}; name its columns so.")
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
        raise InputError(f"Line {line} of {path}: the {name} {text} is no number of metres.")
    return value
