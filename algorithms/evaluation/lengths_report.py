"""The report of a comparison of lengths: table 1 of the facade paper, and a plot."""

import math
from pathlib import Path

from ..reporting.charts import bar_chart
from ..reporting.numbers import number
from ..reporting.page import write_page
from .lengths import Length, LengthComparison

TEMPLATE = Path(__file__).parent / "templates" / "lengths.html"

MILLIMETRES = 1000


def write_lengths_report(path: Path, comparison: LengthComparison) -> None:
    """Write the report as HTML.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    names = [f"{item.id} {item.dimension}" for item in comparison.lengths]
    write_page(
        path,
        TEMPLATE,
        mean_mm=MILLIMETRES * comparison.mean,
        std_mm=MILLIMETRES * comparison.std,
        largest_mm=MILLIMETRES * comparison.largest,
        warnings=comparison.warnings,
        chart=bar_chart(names, {"automatic minus manual": MILLIMETRES * comparison.differences}, "mm"),
        rows=[_row(item) for item in comparison.lengths],
    )


def _row(item: Length) -> tuple[str, ...]:
    return (
        item.id,
        item.dimension,
        number(item.automatic, 4),
        number(item.manual, 4),
        number(MILLIMETRES * item.difference, 1),
        number(item.difference / item.std if item.std else math.nan, 1),
    )
