"""The algorithm `comparelengths`."""

from functools import partial

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.destinations import HtmlDestination, TableDestination
from ..parameters.files import TableFile


class CompareLengthsAlgorithm(Algorithm):
    """Compare the lengths of a schedule with those of a tape."""

    key = "comparelengths"
    title = "Compare lengths of a facade"
    chapter = "Facade"
    summary = "Compares the lengths of a schedule with lengths that were measured by hand."
    about = (
        "Widths, heights and sills are paired by the id of the detail. The table and the report give "
        "automatic minus manual length, its mean and its standard deviation, as table 1 of Aitelkadi, "
        "Tahiri, Simonetto, Sebari and Boulaassal (2014)."
    )
    words = ("facade", "accuracy", "lengths", "tape", "validation", "schedule", "comparison")
    inputs = (
        TableFile("SCHEDULE", "Schedule", "The csv file that facadedetails writes."),
        TableFile(
            "REFERENCE",
            "Manual lengths",
            "A csv file with the columns id and any of width, height, sill, empty where not measured; or "
            "with id, dimension and length. In metres, separated by commas or semicolons; the ids are those "
            "of the schedule.",
        ),
    )
    destinations = (
        TableDestination("TABLE", "Table", "CSV file with a row for each length that is in both."),
        HtmlDestination("REPORT", "Report", "HTML page with the table and a plot.", optional=True),
    )
    numbers = (
        ("MEAN_DIFFERENCE", "Mean of automatic minus manual length (m)"),
        ("STD_DIFFERENCE", "Standard deviation of the differences (m)"),
        ("MAX_DIFFERENCE", "Largest absolute difference (m)"),
        ("COUNT", "Number of lengths compared"),
    )

    def compute(self, values: dict, log: Log) -> Outcome:
        """Pair the lengths."""
        from ...algorithms.evaluation.lengths import compare_lengths, write_table
        from ...algorithms.evaluation.lengths_report import write_lengths_report

        comparison = compare_lengths(values["SCHEDULE"], values["REFERENCE"])
        log.warn(comparison.warnings)
        log.info(
            f"{len(comparison.lengths)} lengths: mean difference {1000 * comparison.mean:.1f} mm, "
            f"standard deviation {1000 * comparison.std:.1f} mm."
        )
        return Outcome(
            {
                "TABLE": partial(write_table, comparison=comparison),
                "REPORT": partial(write_lengths_report, comparison=comparison),
            },
            {
                "MEAN_DIFFERENCE": comparison.mean,
                "STD_DIFFERENCE": comparison.std,
                "MAX_DIFFERENCE": comparison.largest,
                "COUNT": len(comparison.lengths),
            },
        )
