"""Lines become numbers; what is not a point is passed over or named by its line."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.text_layout import read_layout
from ichnograph.algorithms.clouds.formats.text_rows import RowParser
from ichnograph.algorithms.errors import InputError


@pytest.fixture
def rows(tmp_path):
    def rows(content="1.5 2.5 3.5\n4.5 5.5 6.5\n"):
        path = tmp_path / "scan.txt"
        path.write_text(content, encoding="utf-8")
        return RowParser(path, read_layout(path))

    return rows


def test_regular_lines_are_numbers(rows):
    values, announced = rows().parse(["7.5 8.5 9.5\n"], 3)
    np.testing.assert_array_equal(values, [[7.5, 8.5, 9.5]])
    assert announced == 0


@pytest.mark.parametrize(
    ("line", "is_point"), [("1 2 3\n", True), ("# 1 2 3\n", False), ("nan 2 3\n", False)]
)
def test_remarks_and_rows_without_coordinates_are_no_points(rows, line, is_point):
    parser = rows()
    assert parser.is_point(line) is is_point
    assert len(parser.parse([line, "1 2 3\n"], 1)[0]) == 1 + is_point


def test_a_row_whose_last_unused_field_is_missing_is_named(rows):
    parser = rows("x,y,z,nx,ny,nz\n1.5,2.5,3.5,0,0,1\n")
    with pytest.raises(InputError, match=r"Line 7 of .* has 5 columns instead of 6"):
        parser.parse(["1.5,2.5,3.5,0,0,1\n", "1.5,2.5,3.5,0,0\n"], 6)


def test_a_missing_and_a_surplus_field_do_not_make_up_for_each_other(rows):
    parser = rows("x,y,z,class\n1.5,2.5,3.5,wall\n")
    with pytest.raises(InputError, match=r"Line 2 of .* has 3 columns instead of 4"):
        parser.parse(["1,2,3\n", "1,2,3,4,5\n"], 2)


def test_counts_of_further_scans_are_added_up(rows):
    parser = rows("1\n1.5 2.5 3.5\n")
    assert parser.parse(["1.5 2.5 3.5\n", "2\n", "1 2 3\n"], 2)[1] == 2


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ("1.5 2.5 7\x001.5\n", "Line 100 of .* holds a character 0, so the file is damaged"),
        ("1.5 2.5 3,5\n", "Line 100 of .* has '3,5' where a number is expected"),
    ],
)
def test_damage_beyond_the_examined_beginning_is_named(rows, line, problem):
    with pytest.raises(InputError, match=problem):
        rows().parse([line], 100)
