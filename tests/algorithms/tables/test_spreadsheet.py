"""What a spreadsheet would run is marked as text."""

import pytest
from ichnograph.algorithms.tables.spreadsheet import safe_cell


@pytest.mark.parametrize("text", ["=cmd|' /C calc'!A0", "+1+1", "-1+1", "@SUM(1)", "\tx", " =1"])
def test_formulas_get_an_apostrophe(text):
    assert safe_cell(text) == f"'{text}"


@pytest.mark.parametrize("value", ["wall", "-1.5", "+3", "", 7, -1.5, None])
def test_everything_else_is_unchanged(value):
    assert safe_cell(value) == value
