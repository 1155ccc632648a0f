"""Which column of a text cloud holds what, by the names in its header or by what the numbers look like."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ...errors import InputError
from .text_dialect import NUMBER


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
    path: Path, rows: list[list[str]], values: np.ndarray, numeric_share: float
) -> tuple[Columns, tuple[str, ...]]:
    """Guess the columns as most programs write them: x y z, then intensity, then colour."""
    shares = np.mean([_are_numbers(row) for row in rows], axis=0)
    numeric = np.flatnonzero(shares >= numeric_share).tolist()
    if len(numeric) > 3 and _is_label(rows, values, numeric):
        numeric = numeric[1:]
    if len(numeric) < 3:
        raise InputError(f"{path} has fewer than three columns of numbers; export it as x y z.")
    xyz, extra = tuple(numeric[:3]), tuple(numeric[3:])
    if len(extra) in (3, 4) and _look_like_colour(values[:, extra[-3:]]):
        return Columns(xyz, extra[0] if len(extra) == 4 else None, extra[-3:]), ()
    if len(extra) == 1:
        return Columns(xyz, extra[0]), ()
    ignored = f"The columns of {path} after x y z have no names and were left out."
    return Columns(xyz), (ignored,) if extra else ()


def _are_numbers(row: list[str]) -> list[bool]:
    return [bool(NUMBER.fullmatch(field)) for field in row]


def _is_label(rows: list[list[str]], values: np.ndarray, numeric: list[int]) -> bool:
    """Whether the first numeric column only numbers the points.

    It does if none of its values repeats or has decimals, while the next three columns have decimals.
    """
    labels = [row[numeric[0]] for row in rows]
    coordinates = values[:, numeric[1:4]]
    whole = not any(re.search("[.,]", label) for label in labels)
    fractional = np.all(np.any(coordinates % 1 > 0, axis=0))
    return whole and fractional and len(rows) > 1 and len(set(labels)) == len(rows)


def _look_like_colour(values: np.ndarray) -> bool:
    whole = np.all(values % 1 == 0)
    return bool(whole and values.min() >= 0 and 1 < values.max() <= 65535)
