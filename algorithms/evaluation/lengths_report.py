"""The report of a comparison of lengths: table 1 of the facade paper, and a plot."""

from pathlib import Path

from ..reporting.charts import bar_chart
from ..reporting.html import figure, notes, number, paragraph, section, table, write_page
from .lengths import LengthComparison

MILLIMETRES = 1000


def write_lengths_report(path: Path, comparison: LengthComparison) -> None:
    """Write the report as HTML.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    header = ("Detail", "Dimension", "Automatic (m)", "Manual (m)", "Difference (mm)", "Difference / std")
    rows = [
        (
            item.id,
            item.dimension,
            number(item.automatic, 4),
            number(item.manual, 4),
            number(MILLIMETRES * item.difference, 1),
            number(item.difference / item.std if item.std else float("nan"), 1),
        )
        for item in comparison.lengths
    ]
    names = [f"{item.id} {item.dimension}" for item in comparison.lengths]
    chart = bar_chart(names, {"automatic minus manual": MILLIMETRES * comparison.differences}, "mm")
    write_page(
        path,
        "Automatic and manual lengths",
        paragraph(
            f"{len(comparison.lengths)} lengths: mean difference {number(MILLIMETRES * comparison.mean, 1)} "
            f"mm, standard deviation {number(MILLIMETRES * comparison.std, 1)} mm, largest "
            f"{number(MILLIMETRES * comparison.largest, 1)} mm. "
            "Aitelkadi and others (2014) report 4 mm and 6 mm for 19 lengths.",
        ),
        notes(comparison.warnings),
        section("Differences", figure(chart, "Automatic minus manual length.")),
        section("Lengths", table(header, rows, words=(0, 1))),
    )
