"""Which column of a text cloud holds what, by the names in its header or by what the numbers look like."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ...errors import InputError
from ...tables.dialect import is_number
from ..settings import TextSettings

FEWEST_COUNTED = 10
"""Rows beyond which a column that counts them is not a coordinate."""


@dataclass(frozen=True)
class Columns:
    """The columns that hold the values, counted from 0.

    Attributes
    ----------
    xyz : tuple of 3 int
    intensity : int or None
    rgb : tuple of 3 int, or None
    normals : tuple of 3 int, or None
    """

    xyz: tuple[int, ...]
    intensity: Optional[int] = None
    rgb: Optional[tuple[int, ...]] = None
    normals: Optional[tuple[int, ...]] = None

    @property
    def used(self) -> tuple[int, ...]:
        """The columns of which the points of a site are made."""
        intensity = () if self.intensity is None else (self.intensity,)
        return (*self.xyz, *intensity, *(self.rgb or ()))


def columns_by_name(names: dict[str, int]) -> Columns:
    """Return the columns that a header names."""
    return Columns(
        xyz=(names["x"], names["y"], names["z"]),
        intensity=names.get("intensity"),
        rgb=_triple(names, "red", "green", "blue"),
        normals=_triple(names, "nx", "ny", "nz"),
    )


def _triple(names: dict[str, int], *roles: str) -> Optional[tuple[int, ...]]:
    return tuple(names[role] for role in roles) if set(roles) <= names.keys() else None


def columns_by_count(
    path: Path,
    rows: list[list[str]],
    values: np.ndarray,
    settings: TextSettings = TextSettings(),
    elsewhere: Optional[np.ndarray] = None,
) -> tuple[Columns, tuple[str, ...]]:
    """Decide what columns without names hold, by their values: x y z first, then intensity, colour, normals.

    Intensity may stand before or after the colour. What remains doubtful is left out, and said.

    Parameters
    ----------
    path : Path
    rows : list of list of str
        The fields of the first rows.
    values : ndarray, shape (n, columns)
        Their numbers.
    settings : TextSettings
    elsewhere : ndarray, shape (m, columns), optional
        Numbers from all over the file, because its beginning may be dark.

    Raises
    ------
    InputError
        If there are fewer than three columns of numbers.
    """
    shares = np.mean([[is_number(field) for field in row] for row in rows], axis=0)
    numeric = np.flatnonzero(shares >= settings.numeric_share).tolist()
    if len(numeric) > 3:
        if _is_label(rows, values, numeric):
            numeric = numeric[1:]
        elif _may_be_label(rows, values, numeric, settings):
            raise InputError(
                f"The first column of {path} can be x, or the number or time of a point; name the columns in "
                "a first line, as 'x y z intensity' or 'time x y z'."
            )
        elif _may_be_indices(values, numeric):
            raise InputError(
                f"The first two columns of {path} can be x and y, or the row and the column in the scan; "
                "name the columns in a first line, as 'row column x y z'."
            )
    if len(numeric) < 3:
        raise InputError(f"{path} has fewer than three columns of numbers; export it as x y z.")
    xyz, extra = tuple(numeric[:3]), numeric[3:]
    counting = _counting(values, elsewhere, extra)
    extra = [column for column in extra if column != counting]
    values = values if elsewhere is None else np.concatenate([values, elsewhere])
    constant = counting is not None and np.ptp(values[:, counting]) == 0
    normals = _normals(values, extra, settings.unit_length)
    extra = [column for column in extra if column not in (normals or ())]
    rgb = _colour(values, extra, path.suffix.lower() == ".pts", settings)
    others = [column for column in extra if column not in (rgb or ())]
    intensity = others[0] if len(others) == 1 and len(extra) in (1, 4) else None
    if counting is not None:
        left_out = (
            f"Column {counting + 1} of {path} has no name and counts the points or states a time, so it was "
            "left out; name the columns in a first line, as 'x y z intensity'."
        )
        # A column that is the same everywhere, as intensity that was not exported, says nothing.
        return Columns(xyz, None, rgb, normals), () if constant else (left_out,)
    if len(extra) == 4 and rgb is None and _colour_at(values, extra):
        doubt = (
            f"The last four columns of {path} can be intensity and colour or colour and intensity, so both "
            "were left out; name the columns in a first line, as 'x y z intensity red green blue'.",
        )
        return Columns(xyz, normals=normals), doubt
    ignored = f"The columns of {path} after x y z have no names and were left out."
    lost = others and intensity is None
    return Columns(xyz, intensity, rgb, normals), (ignored,) if lost else ()


def _normals(values: np.ndarray, extra: list[int], tolerance: float) -> Optional[tuple[int, ...]]:
    """Return the first three consecutive columns that are vectors of length 1; zeros and nan are unknown."""
    for start in range(len(extra) - 2):
        columns = extra[start : start + 3]
        length = np.linalg.norm(values[:, columns], axis=1)
        known = length[np.isfinite(length) & (length > 0)]
        whole = np.all(values[:, columns] % 1 == 0)
        # Colours of a dark picture can be single ones, too.
        enough = 2 * len(known) > len(length) if whole else len(known) > 0
        if enough and np.all(np.abs(known - 1) < tolerance):
            return tuple(columns)
    return None


def _colour(
    values: np.ndarray, extra: list[int], intensity_first: bool, settings: TextSettings
) -> Optional[tuple[int, ...]]:
    """Return the columns of red, green and blue among three or four; None if there are none, or in doubt."""
    found = _colour_at(values, extra)
    if len(found) < 2:
        return found[0] if found else None
    if intensity_first:
        return found[1]
    # Intensity follows the colours less closely than they follow each other.
    first, last = (_agreement(values[:, columns]) for columns in found)
    if abs(first - last) < settings.clearer_agreement or len(values) < settings.fewest_for_agreement:
        return None
    return found[0] if first > last else found[1]


def _colour_at(values: np.ndarray, extra: list[int]) -> list[tuple[int, ...]]:
    """Return the first and the last three of three or four columns, as far as they look like colour."""
    if len(extra) not in (3, 4):
        return []
    candidates = [tuple(extra[:3]), tuple(extra[1:])] if len(extra) == 4 else [tuple(extra)]
    colours = [columns for columns in candidates if _looks_like_colour(values[:, columns])]
    # Colours have one range, and intensity often another.
    for have_one_range in (_have_one_depth, _were_widened, _reach_alike):
        one = [columns for columns in colours if have_one_range(values[:, columns])]
        if len(one) == 1 < len(colours):
            return one
    return colours


def _have_one_depth(values: np.ndarray) -> bool:
    """Whether all three columns fit into 8 bits, or none of them does."""
    return len({column.max() <= 255 for column in values.T}) == 1


def _were_widened(values: np.ndarray) -> bool:
    """Whether all three columns are colours of 8 bits, brought to 16."""
    return any(not np.any(values % factor) and values.max() > 255 for factor in (256, 257))


def _reach_alike(values: np.ndarray) -> bool:
    """Whether the largest value of no column is less than a sixteenth of that of another."""
    largest = values.max(axis=0)
    return bool(16 * largest.min() > largest.max())


def _agreement(values: np.ndarray) -> float:
    """Return the smallest correlation between three columns."""
    with np.errstate(invalid="ignore", divide="ignore"):
        correlations = np.corrcoef(values.T)
    return float(np.nan_to_num(correlations).min())


def _counting(values: np.ndarray, elsewhere: Optional[np.ndarray], extra: list[int]) -> Optional[int]:
    """Return the column that could be the intensity but never falls along the file; None if all do."""
    if len(values) <= FEWEST_COUNTED or len(extra) not in (1, 4):
        return None
    parts = [part for part in (values, elsewhere) if part is not None and len(part)]
    found = [column for column in extra if not any(np.any(np.diff(part[:, column]) < 0) for part in parts)]
    return found[0] if len(found) == 1 and found[0] in (extra[0], extra[-1]) else None


def _is_label(rows: list[list[str]], values: np.ndarray, numeric: list[int]) -> bool:
    """Whether the first numeric column only numbers the points.

    It does if it counts them, or if none of its values repeats or has decimals, while the next three columns
    have decimals.
    """
    labels = [row[numeric[0]] for row in rows]
    coordinates = values[:, numeric[1:4]]
    whole = not any(re.search("[.,]", label) for label in labels)
    fractional = np.all(np.any(coordinates % 1 > 0, axis=0))
    counted = values[:, numeric[0]] - np.arange(len(rows))
    if len(rows) > FEWEST_COUNTED and counted[0] in (0, 1) and np.all(counted == counted[0]):
        return True
    return whole and fractional and len(rows) > 1 and len(set(labels)) == len(rows)


def _may_be_label(
    rows: list[list[str]], values: np.ndarray, numeric: list[int], settings: TextSettings
) -> bool:
    """Whether the first numeric column may number the points or their scans, or state the time of each.

    Numbers are whole while the next three columns have decimals; times always rise. The fourth column then is
    z and not intensity, of which decimals are a part of 1.
    """
    first, fourth = values[:, numeric[0]], values[:, numeric[3]]
    if not np.any(fourth % 1) or np.abs(fourth).max() <= 1:
        return False
    written = [rows[0][numeric[0]], rows[-1][numeric[0]]]
    whole = not np.any(first % 1) and not any(re.search("[.,]", field) for field in written)
    fractional = np.all(np.any(values[:, numeric[1:4]] % 1 > 0, axis=0))
    rises = len(first) >= settings.fewest_for_agreement and bool(np.all(np.diff(first) > 0))
    return bool(whole and fractional) or rises


def _may_be_indices(values: np.ndarray, numeric: list[int]) -> bool:
    """Whether the first two columns may be the row and the column of each point in its scan.

    They are whole, the next three have decimals, and these are no shares of 1. One at least begins at 0 or 1,
    as numbers of rows do, and coordinates seldom; the other may begin behind empty cells.
    """
    if len(numeric) < 5:
        return False
    indices, others = values[:, numeric[:2]], values[:, numeric[2:5]]
    counted = np.all(indices % 1 == 0) and np.all(indices >= 0) and np.any(indices.min(axis=0) <= 1)
    return bool(counted and np.all(np.any(others % 1 > 0, axis=0)) and np.all(np.abs(others).max(axis=0) > 1))


def _looks_like_colour(values: np.ndarray) -> bool:
    """Whether three columns are 0..255 or 0..65535 in whole numbers, or 0..1."""
    known = values[np.isfinite(values).all(axis=1)]
    if not len(known) or known.min() < 0:
        return False
    if np.all(known % 1 == 0):
        return bool(1 < known.max() <= 65535)
    return bool(known.max() <= 1)
