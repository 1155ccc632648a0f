"""Lines of numbers, separated by blanks, as an array."""

import io
from pathlib import Path

import numpy as np
import pandas as pd

from ...errors import InputError


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
            rows.append([float(field) for field in fields])
        except ValueError:
            raise _unusable(path, position, "holds something that is not a number") from None
        if len(fields) != width:
            raise _unusable(path, position, f"has {len(fields)} numbers instead of {width}")
    return rows


def _unusable(path: Path, position: int, problem: str) -> InputError:
    return InputError(f"Line {position} of {path} {problem}; copy or export the file again.")
