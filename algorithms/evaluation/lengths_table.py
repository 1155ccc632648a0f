"""The table of a comparison of lengths."""

from pathlib import Path

import pandas as pd

from ..files import atomic_output
from ..tables.spreadsheet import safe_cell
from .lengths import LengthComparison

COLUMNS = ("id", "dimension", "automatic", "manual", "difference", "std")


def write_table(path: Path, comparison: LengthComparison) -> None:
    """Write the lengths as csv, in metres.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    rows = [
        (safe_cell(item.id), item.dimension, item.automatic, item.manual, round(item.difference, 5), item.std)
        for item in comparison.lengths
    ]
    with atomic_output(path) as temporary:
        pd.DataFrame(rows, columns=list(COLUMNS)).to_csv(temporary, index=False, lineterminator="\n")
