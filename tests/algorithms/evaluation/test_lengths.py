"""Automatic beside manual lengths, as the paper's table 1."""

import numpy as np
import pandas as pd
import pytest
from ichnograph.algorithms.errors import InputError, NothingFoundError
from ichnograph.algorithms.evaluation.lengths import compare_lengths, write_table
from ichnograph.algorithms.evaluation.lengths_report import write_lengths_report

SCHEDULE = """id,kind,width,height,sill,width_std,height_std
1,recess,1.204,1.502,0.900,0.002,0.004
2,opening,0.998,2.006,0.000,,0.003
"""


@pytest.fixture
def compare(tmp_path):
    def compare(reference, schedule=SCHEDULE, encoding="utf-8"):
        (tmp_path / "schedule.csv").write_text(schedule)
        (tmp_path / "tape.csv").write_text(reference, encoding=encoding)
        return compare_lengths(tmp_path / "schedule.csv", tmp_path / "tape.csv")

    return compare


def test_lengths_are_paired_by_id_and_dimension(compare):
    found = compare("id,width,height\n1,1.200,1.500\n2,1.000,\n")

    assert [(item.id, item.dimension) for item in found.lengths] == [
        ("1", "width"), ("1", "height"), ("2", "width"),
    ]  # fmt: skip
    np.testing.assert_allclose(found.differences, [0.004, 0.002, -0.002], atol=1e-9)


def test_mean_standard_deviation_and_largest_are_those_of_the_differences(compare):
    found = compare("id,width,height\n1,1.200,1.500\n2,1.000,\n")

    assert found.mean == pytest.approx(0.004 / 3)
    assert found.std == pytest.approx(np.std([0.004, 0.002, -0.002], ddof=1))
    assert found.largest == pytest.approx(0.004)


def test_a_single_length_has_no_standard_deviation(compare):
    assert np.isnan(compare("id,width\n1,1.2\n").std)


@pytest.mark.parametrize("reference", [
    "id,dimension,length\n1,width,1.2\n2,Height,2.0\n",
    "ID; Width; Height\n1; 1,2;\n2; ; 2,0\n",
    "\ufeffid,width,height\r\n1,1.2,\r\n\r\n2,,2.0\r\n",
], ids=["long", "semicolons and decimal commas", "spreadsheet"])  # fmt: skip
def test_the_reference_may_be_written_in_several_ways(compare, reference):
    found = compare(reference)
    assert [(item.id, item.dimension, item.manual) for item in found.lengths] == [
        ("1", "width", 1.2), ("2", "height", 2.0),
    ]  # fmt: skip


def test_what_the_schedule_does_not_have_is_named(compare):
    (warning,) = compare("id,width\n1,1.2\n9,3.0\n").warnings
    assert "width of 9" in warning


def test_without_a_common_length_there_is_nothing_to_compare(compare):
    with pytest.raises(NothingFoundError, match="ids"):
        compare("id,width\n9,1.2\n")


@pytest.mark.parametrize(("reference", "named"), [
    ("name,width\n1,1.2\n", "id"),
    ("id,breadth\n1,1.2\n", "width"),
    ("id,width\n1,wide\n", "Line 2"),
    ("id,dimension,length\n1,depth,1.2\n", "depth"),
    ("", "id"),
])  # fmt: skip
def test_a_bad_reference_is_refused_by_name(compare, reference, named):
    with pytest.raises(InputError, match=named):
        compare(reference)


def test_a_file_that_is_missing_is_named(tmp_path):
    with pytest.raises(InputError, match=r"none\.csv"):
        compare_lengths(tmp_path / "none.csv", tmp_path / "none.csv")


def test_the_table_and_the_report_show_every_length(compare, tmp_path):
    found = compare("id,width,height\n1,1.200,1.500\n2,1.000,\n")
    write_table(tmp_path / "table.csv", found)
    write_lengths_report(tmp_path / "report.html", found)
    table, page = pd.read_csv(tmp_path / "table.csv"), (tmp_path / "report.html").read_text()

    assert table["difference"].tolist() == [0.004, 0.002, -0.002]
    assert "1.2040" in page and "<svg" in page and "mean difference 1.3" in page
