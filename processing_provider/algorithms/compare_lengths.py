"""The algorithm `comparelengths`."""

from functools import partial
from pathlib import Path
from typing import Any

from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_TABLES
from ..log import Log
from ..parameters.destinations import HtmlDestination, TableDestination
from ..parameters.files import TableFile


class CompareLengthsAlgorithm(Algorithm):
    """Compare the lengths of a schedule with tape measurements."""

    key = "comparelengths"
    title = "Compare lengths of a facade"
    chapter = "Facade"
    summary = "Compares the lengths of a schedule with tape measurements."
    about = (
        "Widths, heights and sills are paired by the id of the detail. The table and the report give "
        "automatic minus manual length, its mean and its standard deviation, as table 1 of Aitelkadi, "
        "Tahiri, Simonetto, Sebari and Boulaassal (2014)."
    )
    words = ("facade", "accuracy", "lengths", "tape", "validation", "schedule", "comparison")
    needs = FOR_TABLES
    inputs = (
        TableFile("SCHEDULE", "Schedule", "The csv file that facadedetails writes."),
        TableFile(
            "REFERENCE",
            "Manual lengths",
            "A csv file with the columns id and any of width, height and sill, empty where not measured, or "
            "with the columns id, dimension and length. Lengths in metres, separated by commas or "
            "semicolons, with the ids of the schedule.",
        ),
    )
    destinations = (
        TableDestination("TABLE", "Table", "CSV file with a row for each length that both files have."),
        HtmlDestination(
            "REPORT", "Report of the lengths", "HTML page with the table and a plot.", optional=True
        ),
    )
    numbers = (
        ("MEAN_DIFFERENCE", "Mean of automatic minus manual length (m)"),
        ("STD_DIFFERENCE", "Standard deviation of the differences (m)"),
        ("MAX_DIFFERENCE", "Largest absolute difference (m)"),
        ("COUNT", "Number of lengths compared"),
    )

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Pair the lengths."""
        from ...algorithms.evaluation.length_lists import read_reference, read_schedule
        from ...algorithms.evaluation.lengths import compare_lengths
        from ...algorithms.evaluation.lengths_table import write_table

        comparison = compare_lengths(
            read_schedule(Path(values["SCHEDULE"])), read_reference(Path(values["REFERENCE"]))
        )
        log.warn(comparison.warnings)
        log.info(
            f"{len(comparison.lengths)} lengths: mean difference {1000 * comparison.mean:.1f} mm, "
            f"standard deviation {1000 * comparison.std:.1f} mm."
        )
        writers = {"TABLE": partial(write_table, comparison=comparison)}
        if values["REPORT"]:
            from ...algorithms.evaluation.lengths_report import write_lengths_report

            writers["REPORT"] = partial(write_lengths_report, comparison=comparison)
        return Outcome(
            writers,
            {
                "MEAN_DIFFERENCE": comparison.mean,
                "STD_DIFFERENCE": comparison.std,
                "MAX_DIFFERENCE": comparison.largest,
                "COUNT": len(comparison.lengths),
            },
        )
