"""Separator and decimal sign are found from the lines themselves."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.tables.dialect import (
    Dialect,
    decimal_signs,
    delimiter_and_width,
    ends_cut_off,
    is_comment,
    is_count,
    is_number,
    is_row,
    split,
    stated_delimiter,
)

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
    assert decimal_signs(SCAN, [row], delimiter, False)[0] == sign


@pytest.mark.parametrize(("row", "delimiter"), [(["1,5", "2.5", "3"], ";"), (["1", "5", "2", "5"], ",")])
def test_commas_of_two_meanings_are_refused(row, delimiter):
    with pytest.raises(InputError, match="can be decimal signs or separators"):
        decimal_signs(SCAN, [row], delimiter, False)[0]


def test_a_header_settles_what_commas_between_whole_numbers_are():
    assert decimal_signs(SCAN, [["1", "5", "2", "5"]], ",", True) == (".", "")


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


@pytest.mark.parametrize(
    ("rows", "signs", "value"),
    [
        ([["5.334.567,397", "512,276"]], (",", "."), 5334567.397),
        ([["5,334,567.397", "512.276"]], (".", ","), 5334567.397),
        ([["2'600'123.5", "512.5"]], (".", "'"), 2600123.5),
        ([["2\u202f600\u202f123,5", "512,5"]], (",", "\u202f"), 2600123.5),
        ([["5.334.567", "512,276"]], (",", "."), 5334567),
        ([["5334567", "512,276"]], (",", ""), 5334567),
    ],
)
def test_separators_of_thousands_are_recognised_where_they_are_certain(rows, signs, value):
    assert decimal_signs(SCAN, rows, ";", True) == signs
    assert Dialect(";", signs[0], 2, signs[1]).number(rows[0][0]) == value


def test_thousands_separated_in_two_ways_are_refused():
    with pytest.raises(InputError, match="separate thousands in several ways"):
        decimal_signs(SCAN, [["1.234.567,8", "1,234,567.8"]], ";", True)


def test_a_delimiter_between_quotes_is_part_of_its_field():
    assert split('"wall 101, north",1.5,2.5', ",") == ["wall 101, north", "1.5", "2.5"]
    assert split('"wall 101" 1.5 2.5', " ") == ["wall 101", "1.5", "2.5"]
    assert split('"a ""b""",1', ",") == ['a "b"', "1"]
    assert ",".join(Dialect(",", ".", 2).fields('"a, b",1\n')) == '"a, b",1'


def test_a_first_line_may_state_the_separator():
    assert stated_delimiter(["sep=;\n", "1;2;3"]) == ";"
    assert is_comment("sep=;\n")
    assert delimiter_and_width(SCAN, ["sep=,\n", "1,2,3,4\n"]) == (",", 4)


@pytest.mark.parametrize("line", [",,,\n", ";;;", "\t\t\n", "\x1a"])
def test_a_line_of_separators_alone_is_empty(line):
    assert is_comment(line)


@pytest.mark.parametrize("field", ["nan", "-NaN", "inf", "-1.#IND", "1.#QNAN", "nan(ind)"])
def test_numbers_that_a_program_does_not_know_count_as_numbers_but_have_no_value(field):
    assert is_number(field)
    assert not np.isfinite(Dialect(" ", ".", 1).number(field))


@pytest.mark.parametrize(
    ("lines", "cut"),
    [
        (["1 2 71.25\n", "1 2 71.25\n", "1 2 7"], True),
        (["1 2 71.25\n", "1 2 71.25\n", "1 2 71.2"], True),
        (["1 2 71.25\n", "1 2 71.25\n", "1 2 71.2\n"], False),
        (["1 2 71.25\n", "1 2 71.2\n", "1 2 7"], False),
        (["1 2 71\n", "1 2 72\n", "1 2 7"], False),
        (["1 2 wall\n", "1 2 wall\n", "1 2 wa"], False),
        (["1 2 71.25\n", "1 2 71.25\n", "1 2 1e-05"], False),
        (["1 2 wall\n", "1 2 12\n", "1 2 wall"], False),
    ],
)
def test_a_last_number_with_fewer_decimals_than_all_others_and_without_line_end_is_cut_off(lines, cut):
    assert ends_cut_off(lines, " ") is cut


def test_a_number_between_quotes_and_commas_may_be_a_thousand():
    rows = [["1,234", "2,345", "3.5"], ["1,235", "2,346", "4.5"]]
    assert decimal_signs(SCAN, [row[:2] for row in rows], ";", True) == (",", "")
    with pytest.raises(InputError, match=r"commas in .* can be decimal signs or separators"):
        decimal_signs(SCAN, [row[:2] for row in rows], ",", True)


@pytest.mark.parametrize(
    ("lines", "problem"),
    [
        (["#1 1 2 3", "#2 4 5 6"], "all lines with numbers begin with #"),
        (['<?xml version="1.0"?>', "<points>"], "is XML, not a table of numbers"),
    ],
)
def test_what_is_no_table_is_refused_with_the_reason(lines, problem):
    with pytest.raises(InputError, match=problem):
        delimiter_and_width(SCAN, lines)
