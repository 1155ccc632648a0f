"""Lines of numbers become an array, or an error that names the line."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.number_table import read_numbers
from ichnograph.algorithms.errors import InputError

SCAN = Path("scan.ptx")


def test_blanks_and_tabs_separate_and_nan_is_a_number():
    table = read_numbers(SCAN, ["1 2.5\t-3e2\n", "  4 nan 6\n"], first=11, width=3)
    np.testing.assert_array_equal(table, [[1, 2.5, -300], [4, np.nan, 6]])


def test_a_line_that_ends_in_nan_is_complete():
    table = read_numbers(SCAN, ["1 2 3\n", "4 5 nan\n"], first=11, width=3)
    np.testing.assert_array_equal(table, [[1, 2, 3], [4, 5, np.nan]])


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ("4 5\n", "has 2 numbers instead of 3"),
        ("4 5 6 7\n", "has 4 numbers instead of 3"),
        ("4 five 6\n", "holds something that is not a number"),
        ("\n", "has 0 numbers instead of 3"),
    ],
)
def test_the_first_irregular_line_is_named_by_its_number_in_the_file(line, problem):
    with pytest.raises(InputError, match=f"Line 12 of scan.ptx {problem}; copy or export the file again"):
        read_numbers(SCAN, ["1 2 3\n", line, "7 8\n"], first=11, width=3)
