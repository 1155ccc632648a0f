"""The report of a comparison of lengths."""

import re

from ichnograph.algorithms.evaluation.lengths import Length, LengthComparison
from ichnograph.algorithms.evaluation.lengths_report import write_lengths_report
from ichnograph.algorithms.reporting.numbers import MISSING

COMPARISON = LengthComparison(
    (
        Length("1", "width", 1.204, 1.2, 0.002),
        Length("1", "height", 1.502, 1.5, float("nan")),
        Length("<b>", "width", 0.998, 1.0, 0.001),
    ),
    ("schedule.csv has no width of 9.",),
)


def test_it_shows_every_length_and_what_they_say_together(tmp_path):
    write_lengths_report(tmp_path / "report.html", COMPARISON)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")

    rows = [re.findall(r"<td[^>]*>(.*?)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", page)][1:]
    assert rows == [
        ["1", "width", "1.2040", "1.2000", "4.0", "2.0"],
        ["1", "height", "1.5020", "1.5000", "2.0", MISSING],
        ["&lt;b&gt;", "width", "0.9980", "1.0000", "-2.0", "-2.0"],
    ]
    assert "3 lengths: mean difference 1.3 mm, standard deviation 3.1 mm, largest 4.0 mm." in page
    assert "schedule.csv has no width of 9." in page
    assert page.count("<svg") == 1
