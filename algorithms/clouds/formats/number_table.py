"""Lines of numbers, separated by blanks, as an array."""

import io
from pathlib import Path

import numpy as np
import pandas as pd

from ...errors import InputError
from ...tables.dialect import LOST, NUMBER, ends_cut_off
from ..source import truncated


def read_numbers(path: Path, lines: list[str], first: int, width: int) -> np.ndarray:
    """Return the numbers in `lines` of `path`, shape (n, width); `nan` counts as a number.

    Parameters
    ----------
    first : int
        Number of the first line in the file, for messages.

    Raises
    ------
    InputError
        Naming the first line that is not `width` numbers.
    """
    if lines and ends_cut_off(lines[-50:], " "):
        raise truncated(path, f"the number at the end of its last line {first + len(lines) - 1} is cut off")
    if any("\0" in line for line in lines):
        raise InputError(
            f"{path} holds a character 0 among its numbers, so it is damaged; copy or export it again."
        )
    try:
        table = pd.read_csv(
            io.StringIO("".join(lines)), header=None, sep=r"\s+", dtype=np.float64, low_memory=False
        )
        # A line that is too short shows as a missing last field.
        sound = table.shape == (len(lines), width) and not table[width - 1].isna().any()
    except (ValueError, OverflowError):
        sound = False
    return table.to_numpy() if sound else np.array(_checked(path, lines, first, width))


def _checked(path: Path, lines: list[str], first: int, width: int) -> list[list[float]]:
    rows = []
    for position, line in enumerate(lines, start=first):
        fields = line.split()
        try:
            rows.append([_number(field) for field in fields])
        except ValueError:
            raise _unusable(path, position, "holds something that is not a number") from None
        if len(fields) != width:
            raise _unusable(path, position, f"has {len(fields)} numbers instead of {width}")
    return rows


def _number(field: str) -> float:
    # Programs write what is not a number in several ways; Python allows underscores, which no program means.
    if LOST.fullmatch(field):
        return np.nan
    if not NUMBER.fullmatch(field):
        raise ValueError(field)
    return float(field)


def _unusable(path: Path, position: int, problem: str) -> InputError:
    return InputError(f"Line {position} of {path} {problem}; copy or export the file again.")
