"""Separator and decimal sign are found from the lines themselves."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.text_dialect import (
    Dialect,
    decimal_sign,
    delimiter_and_width,
    is_comment,
    is_count,
    is_row,
    split,
)
from ichnograph.algorithms.errors import InputError

SCAN = Path("scan.txt")


@pytest.mark.parametrize(
    ("line", "delimiter", "width"),
    [
        ("1.5 2.5 3.5", " ", 3),
        ("1,5 2,5 3,5", " ", 3),
        ("1.5,2.5,3.5,7", ",", 4),
        ("1.5, 2.5, 3.5", ",", 3),
        ("1,5;2,5;3,5", ";", 3),
        ("1.5\t2.5\t3.5\tA 1", "\t", 4),
    ],
)
def test_the_delimiter_is_the_one_that_leaves_three_numbers(line, delimiter, width):
    assert delimiter_and_width(SCAN, ["# remark", line, line]) == (delimiter, width)


def test_most_lines_decide():
    assert delimiter_and_width(SCAN, ["1 2 3 4", "1 2 3", "4 5 6"]) == (" ", 3)


def test_a_file_without_three_numbers_in_a_line_is_refused():
    with pytest.raises(InputError, match="holds no points because no line has three numbers"):
        delimiter_and_width(SCAN, ["a b c", "1 2"])


@pytest.mark.parametrize(
    ("row", "delimiter", "sign"),
    [(["1,5", "2", "3"], ";", ","), (["1.5", "2", "3"], ";", "."), (["1", "2", "3"], ",", ".")],
)
def test_the_decimal_sign_is_the_one_that_occurs(row, delimiter, sign):
    assert decimal_sign(SCAN, [row], delimiter, {}) == sign


@pytest.mark.parametrize(("row", "delimiter"), [(["1,5", "2.5", "3"], ";"), (["1", "5", "2", "5"], ",")])
def test_commas_of_two_meanings_are_refused(row, delimiter):
    with pytest.raises(InputError, match="can be decimal signs or separators"):
        decimal_sign(SCAN, [row], delimiter, {})


def test_a_header_settles_what_commas_between_whole_numbers_are():
    assert decimal_sign(SCAN, [["1", "5", "2", "5"]], ",", {"x": 0, "y": 1, "z": 2}) == "."


def test_quotes_and_blanks_around_fields_do_not_belong_to_them():
    assert split('"1" ; 2;"three 3"', ";") == ["1", "2", "three 3"]
    assert split("  1 \t 2  3\n", " ") == ["1", "2", "3"]


def test_fields_joined_by_the_delimiter_are_the_line():
    dialect = Dialect(";", ",", 3)
    assert ";".join(dialect.fields(' 1,5;"2";3\n')) == ' 1,5;"2";3'
    assert dialect.number("1,5") == 1.5
    assert np.isnan(dialect.number("wall"))


@pytest.mark.parametrize(
    ("line", "remark"), [("", True), ("  \n", True), ("// a", True), ("#1 2 3", True), ("1 2 3", False)]
)
def test_empty_lines_and_marked_ones_are_remarks(line, remark):
    assert is_comment(line) is remark


@pytest.mark.parametrize(
    ("line", "count"), [("1200\n", True), (" 7 ", True), ("1.5", False), ("1 2", False), ("", False)]
)
def test_a_count_is_a_single_whole_number(line, count):
    assert is_count(line) is count


@pytest.mark.parametrize(
    ("line", "row"), [("1 2 3 wall", True), ("1 2 3", False), ("# 1 2 3", False), ("a 1 2 b", False)]
)
def test_a_row_has_as_many_fields_as_most_and_three_numbers(line, row):
    assert is_row(line, " ", 4) is row
