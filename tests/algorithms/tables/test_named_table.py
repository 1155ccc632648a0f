"""Tables with a header are read whatever separates their fields, and refused where a row does not fit."""

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.tables.column_names import LENGTHS
from ichnograph.algorithms.tables.named_table import read_named_table


@pytest.fixture
def table(tmp_path):
    def table(content):
        path = tmp_path / "tape.csv"
        path.write_text(content, encoding="utf-8")
        return read_named_table(path, LENGTHS, ("id", "width"), ("width", "height"))

    return table


@pytest.mark.parametrize(
    ("content", "line"),
    [
        ("id,width\n1,0.9\n", 2),
        ("sep=;\nid;width\n1;0,9\n", 3),
        ("# by hand\n\nid|width\n1|0.9\n", 4),
        ("id\twidth\n1\t0.9\n", 2),
        ("id width\n1 0.9\n", 2),
        ("id,width,\n1,0.9,\n", 2),
        ("id,width\n,\n1,0.9,,\n", 3),
        ('id,width\n"1","0,9"\n', 2),
        ("id;width;\n1;0,9\n", 2),
        ("The windows of 2026\n\nid;width\n1;0,9\n", 4),
    ],
)
def test_rows_are_found_by_their_lines_whatever_separates_their_fields(table, content, line):
    found = table(content)

    assert list(found.rows) == [line]
    assert found.text(line, "id") == "1"
    assert found.dialect.number(found.text(line, "width")) == 0.9
    assert found.text(line, "height") == ""


def test_units_are_those_of_the_header_or_of_a_line_below_it(table):
    assert table("id,width [mm]\n1,900\n").metres("width") == 1e-3
    assert table("id,width\n,[cm]\n1,90\n").metres("width") == 1e-2
    assert table("id,width\n1,90\n").metres("width") == 1
    with pytest.raises(InputError, match="gives lengths in ft"):
        table("id,width [ft]\n1,3\n").metres("width")


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("id,height\n1,2\n", "has no column width; add or rename it"),
        ("", "has no column id, width"),
        ("id,width\n1,0,9\n", "Line 2 of .* has 3 fields where the header names 2 columns"),
        ("id,width\n1\n", "Line 2 of .* has 1 fields where the header names 2 columns"),
        ("id;width;height\n1;0,9;1.2\n", "commas .* can be decimal signs or separators"),
    ],
)
def test_a_table_that_does_not_fit_its_header_is_refused(table, content, problem):
    with pytest.raises(InputError, match=problem):
        table(content)


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("id;width [mm];height\n1;900;1600\n", "states the unit of some columns only"),
        ("# units: mm\n# units: cm\nid;width\n1;900\n", "state several units, mm and cm"),
        ("id;width;width\n1;0,9;1,6\n", "has several columns called width"),
        ("id,width,height\n1,0,9\n2,1,2\n", "commas in .* can be decimal signs or separators"),
        ("id;width;height\n1;0,9;1,600\n2;0,8;1,200\n3;0,8;1,5", "The number at the end of .* is cut off"),
        ('id,width,height\n1,"1,900","1,600"\n', "commas in .* can be decimal signs or separators"),
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(table, content, problem):
    with pytest.raises(InputError, match=problem):
        table(content)


def test_a_remark_before_the_names_states_the_unit_of_all_columns(table):
    assert table("# units: mm\nid;width;height\n1;900;1600\n").metres("height") == 1e-3


def test_rows_that_begin_as_remarks_do_are_said(table):
    (said,) = table("id;width;height\n#1;0,9;1,6\n2;0,9;1,6\n").warnings
    assert "1 rows of" in said
    assert "the first in line 2, begin as remarks do" in said
