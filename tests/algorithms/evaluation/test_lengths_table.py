"""The table of a comparison of lengths."""

from ichnograph.algorithms.evaluation.lengths import Length, LengthComparison
from ichnograph.algorithms.evaluation.lengths_table import write_table


def test_there_is_a_row_for_each_length_and_what_is_not_known_is_empty(tmp_path):
    lengths = (Length("1", "width", 1.204, 1.2, 0.002), Length("2", "sill", 0.998, 1.0, float("nan")))
    write_table(tmp_path / "table.csv", LengthComparison(lengths, ()))

    assert (tmp_path / "table.csv").read_text().splitlines() == [
        "id,dimension,automatic,manual,difference,std",
        "1,width,1.204,1.2,0.004,0.002",
        "2,sill,0.998,1.0,-0.002,",
    ]
