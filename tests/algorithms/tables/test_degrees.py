"""Coordinates that look like degrees are said."""

from pathlib import Path

import pytest
from ichnograph.algorithms.tables.degrees import degree_warning
from ichnograph.algorithms.tables.dialect import Dialect

SCAN = Path("scan.xyz")


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("11.50078712 48.10031934 508.203", True),
        ("-33.8567844 151.2152967 4.25", True),
        ("11.500787 48.100319 508", True),
        ("11.501 48.100 508.203", False),
        ("11.50078712 48.10031934 508.20312345", False),
        ("691234.12345678 48.10031934 508.203", False),
        ("100.1234567 120.1234567 3.5", False),
    ],
)
def test_many_more_decimals_than_those_of_heights_are_those_of_degrees(row, said):
    rows = [row.split()] * 3
    assert bool(degree_warning(SCAN, rows, Dialect(" ", ".", 3))) == said


def test_one_row_of_another_kind_shows_that_it_is_chance():
    rows = [["11.5007871", "48.1003193", "508.2"], ["11.5", "48.1", "508.2"]]
    assert degree_warning(SCAN, rows, Dialect(" ", ".", 3)) == ()
    assert degree_warning(SCAN, [], Dialect(" ", ".", 3)) == ()
