"""Columns without names are recognised by what their numbers look like."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.text_columns import Columns, columns_by_count, columns_by_name
from ichnograph.algorithms.clouds.settings import TextSettings
from ichnograph.algorithms.errors import InputError

SCAN = Path("scan.txt")


def by_count(*rows, numeric_share=0.5):
    values = np.array(
        [[float(field) if field[0] in "-0123456789" else np.nan for field in row.split()] for row in rows]
    )
    return columns_by_count(
        SCAN, [row.split() for row in rows], values, TextSettings(numeric_share=numeric_share)
    )


def test_named_columns_are_used_by_their_names():
    names = {"x": 2, "y": 1, "z": 0, "red": 3, "green": 4, "blue": 5, "nx": 6, "ny": 7}
    assert columns_by_name(names) == Columns((2, 1, 0), None, (3, 4, 5), None)


def test_used_columns_are_coordinates_then_intensity_then_colour():
    assert Columns((0, 1, 2), 6, (3, 4, 5), (7, 8, 9)).used == (0, 1, 2, 6, 3, 4, 5)
    assert Columns((2, 1, 0)).used == (2, 1, 0)


@pytest.mark.parametrize(
    ("rows", "columns"),
    [
        (["1.5 2.5 3.5", "2.5 3.5 4.5"], Columns((0, 1, 2))),
        (["1.5 2.5 3.5 0.7", "2.5 3.5 4.5 0.8"], Columns((0, 1, 2), 3)),
        (["1.5 2.5 3.5 200 10 0", "2.5 3.5 4.5 7 8 9"], Columns((0, 1, 2), None, (3, 4, 5))),
        (["1.5 2.5 3.5 -12 200 10 0", "2.5 3.5 4.5 34 7 8 9"], Columns((0, 1, 2), 3, (4, 5, 6))),
        (["P1 1.5 2.5 3.5", "P2 2.5 3.5 4.5"], Columns((1, 2, 3))),
        (["1 1.5 2.5 3.5", "2 2.5 3.5 4.5"], Columns((1, 2, 3))),
        (["1.5 2.5 3.5 25 140 38 1133", "2.5 3.5 4.5 57 221 184 663"], Columns((0, 1, 2), 6, (3, 4, 5))),
        (["1.5 2.5 3.5 1133 25 140 38", "2.5 3.5 4.5 663 57 221 184"], Columns((0, 1, 2), 3, (4, 5, 6))),
        (["1.5 2.5 3.5 25 140 38 0.25", "2.5 3.5 4.5 57 221 184 0.5"], Columns((0, 1, 2), 6, (3, 4, 5))),
        (
            ["1.5 2.5 3.5 514 257 51400 1133", "2.5 3.5 4.5 65535 771 257 663"],
            Columns((0, 1, 2), 6, (3, 4, 5)),
        ),
        (
            ["1.5 2.5 3.5 900 50000 41000 42", "2.5 3.5 4.5 800 60 300 30771"],
            Columns((0, 1, 2), 3, (4, 5, 6)),
        ),
        (["1.5 2.5 3.5 0.1 0.2 0.9", "2.5 3.5 4.5 1 0.5 0.5"], Columns((0, 1, 2), None, (3, 4, 5))),
        (["1.5 2.5 3.5 0 0 1", "2.5 3.5 4.5 0.6 0.8 0"], Columns((0, 1, 2), normals=(3, 4, 5))),
        (
            ["1.5 2.5 3.5 200 10 0 0 0 1", "2.5 3.5 4.5 7 8 9 0.6 0 -0.8"],
            Columns((0, 1, 2), None, (3, 4, 5), (6, 7, 8)),
        ),
        (
            ["1.5 2.5 3.5 900 0 0 1", "2.5 3.5 4.5 800 0 1 0"],
            Columns((0, 1, 2), 3, normals=(4, 5, 6)),
        ),
    ],
)
def test_columns_follow_the_usual_order(rows, columns):
    assert by_count(*rows) == (columns, ())


def test_a_first_column_that_repeats_is_a_coordinate_where_the_fourth_can_be_an_intensity():
    assert by_count("1 1.5 2.5 0.5", "1 2.5 3.5 0.75")[0] == Columns((0, 1, 2), 3)
    assert by_count("1 1.5 2.5 350", "1 2.5 3.5 450")[0] == Columns((0, 1, 2), 3)


@pytest.mark.parametrize(
    "rows",
    [
        [f"{n // 2} {n * 7 % 11}.25 {n % 5}.5 {n % 3}.75" for n in range(20)],
        [f"{n // 2} {n * 7 % 11}.25 {n % 5}.5 {n % 3}.75 10 20 30" for n in range(20)],
        [f"{1000 + n / 8} {n * 7 % 11}.25 {n % 5}.5 {n % 3}.75" for n in range(200)],
    ],
)
def test_a_first_column_that_can_be_a_scan_or_a_time_is_asked_for(rows):
    with pytest.raises(InputError, match=r"first column of scan\.txt can be x, or the number or time"):
        by_count(*rows)


def test_a_first_column_that_counts_the_rows_is_no_coordinate_even_among_whole_ones():
    assert by_count(*(f"{n + 1} {n * 7 % 11} {n % 5} {n % 3}" for n in range(20)))[0].xyz == (1, 2, 3)


def test_columns_of_unknown_meaning_are_left_out_with_a_warning():
    columns, warnings = by_count("1.5 2.5 3.5 0.1 0.2", "2.5 3.5 4.5 0.3 0.4")
    assert columns == Columns((0, 1, 2))
    assert warnings == ("The columns of scan.txt after x y z have no names and were left out.",)


def test_a_column_of_words_with_some_numbers_is_no_coordinate():
    rows = ("1.5 2.5 7 3.5", "2.5 3.5 wall 4.5", "2.5 3.5 roof 4.5")
    assert by_count(*rows)[0].xyz == (0, 1, 3)
    assert by_count(*rows, numeric_share=0.3)[0].xyz == (0, 1, 2)


def test_fewer_than_three_columns_of_numbers_are_refused():
    with pytest.raises(InputError, match="has fewer than three columns of numbers"):
        by_count("1.5 wall 3.5", "2.5 roof 4.5")


def grey_scan(order):
    """Return rows of colours that agree, and of an intensity in the same range that does not."""
    random = np.random.default_rng(0)
    grey, intensity = random.integers(0, 230, 200), random.integers(0, 256, 200)
    columns = {"R": grey, "G": grey + random.integers(0, 20, 200), "B": grey + random.integers(0, 20, 200)}
    columns["I"] = intensity
    return [
        " ".join(["1.5 2.5 3.5", *(str(columns[name][row]) for name in order)]) for row in range(len(grey))
    ]


@pytest.mark.parametrize(
    ("order", "columns"),
    [("RGBI", Columns((0, 1, 2), 6, (3, 4, 5))), ("IRGB", Columns((0, 1, 2), 3, (4, 5, 6)))],
)
def test_colours_of_the_range_of_the_intensity_are_those_that_agree(order, columns):
    assert by_count(*grey_scan(order)) == (columns, ())


def test_four_columns_that_could_be_either_are_left_out_and_the_remedy_is_said():
    columns, warnings = by_count("1.5 2.5 3.5 10 20 30 40", "2.5 3.5 4.5 50 60 70 80")
    assert columns == Columns((0, 1, 2))
    assert "name the columns in a first line" in warnings[0]


def test_colour_is_recognised_by_its_values_elsewhere_if_the_beginning_is_black():
    rows = [f"{n}.25 {n % 5}.5 {n % 3}.75 0 0 0".split() for n in range(20)]
    values = np.array(rows, float)
    assert columns_by_count(SCAN, rows, values)[0].rgb is None
    elsewhere = np.array([[1.5, 2.5, 3.5, 200, 10, 30]])
    assert columns_by_count(SCAN, rows, values, elsewhere=elsewhere)[0].rgb == (3, 4, 5)


def test_rows_and_columns_of_a_scan_before_the_coordinates_are_asked_for():
    rows = [f"{n // 5} {n % 5} {n}.25 {2 * n}.5 {n % 3}.125 {n} {n} {n}" for n in range(20)]
    with pytest.raises(InputError, match="can be x and y, or the row and the column in the scan"):
        by_count(*rows)
    # Whole metres with colours of parts of 1 are a grid.
    grid = [f"{n // 5} {n % 5} {n}.25 0.{n} 0.5{n} 0.25" for n in range(20)]
    assert by_count(*grid)[0].xyz == (0, 1, 2)


def test_rows_that_begin_behind_empty_cells_are_asked_for():
    rows = [f"{n // 5} {40 + n % 5} {n}.25 {2 * n}.5 {n % 3}.125" for n in range(20)]
    with pytest.raises(InputError, match="can be x and y, or the row and the column in the scan"):
        by_count(*rows)


def test_a_grid_of_whole_metres_with_reflectance_and_deviation_is_read():
    grid = [f"{500 + n // 5} {100 + n % 5} {203 + n % 3}.41 -12.{n}5 4.{n}5" for n in range(20)]
    assert by_count(*grid)[0].xyz == (0, 1, 2)


RANDOM = np.random.default_rng(0).integers(0, 256, 60)


@pytest.mark.parametrize(
    "more",
    [
        pytest.param(lambda n: f"{n + 1}", id="number of the point"),
        pytest.param(lambda n: f"{300_000 + n / 100}", id="time"),
        pytest.param(lambda n: f"{n // 20}", id="scan"),
    ],
)
@pytest.mark.parametrize("colour", ["", "{0} {1} {2} "])
def test_what_never_falls_along_a_file_is_no_intensity(more, colour):
    rows = [
        f"{n * 7 % 11}.25 {n % 5}.5 {n % 3}.75 {colour.format(*RANDOM[n : n + 3])}{more(n)}"
        for n in range(50)
    ]
    columns, (warning,) = by_count(*rows)
    assert columns.intensity is None
    assert columns.rgb == ((3, 4, 5) if colour else None)
    assert f"Column {7 if colour else 4} of scan.txt has no name and counts the points" in warning


def test_a_dark_beginning_is_no_reason_to_leave_intensity_out():
    rows = [f"{n * 7 % 11}.25 {n % 5}.5 {n % 3}.75 0".split() for n in range(50)]
    elsewhere = np.column_stack([np.ones((60, 3)), RANDOM])
    assert columns_by_count(SCAN, rows, np.array(rows, float), elsewhere=elsewhere)[0].intensity == 3


@pytest.mark.parametrize("value", ["0", "255"])
@pytest.mark.parametrize("colour", ["", "{0} {1} {2} "])
def test_a_column_that_is_the_same_everywhere_is_left_out_without_a_word(value, colour):
    rows = [
        f"{n * 7 % 11}.25 {n % 5}.5 {n % 3}.75 {colour.format(*RANDOM[n : n + 3])}{value}" for n in range(50)
    ]
    assert by_count(*rows) == (Columns((0, 1, 2), None, (3, 4, 5) if colour else None), ())
