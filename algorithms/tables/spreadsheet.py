"""Cells of tables that a spreadsheet would run as formulas."""

from typing import Any

FULL_WIDTH = tuple("\uff1d\uff0b\uff0d\uff20")
"""The same signs as East Asian programs write them."""

FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", *FULL_WIDTH)
"""What a formula, or a command of another program, begins with."""


def safe_cell(value: Any) -> Any:
    """Return a text so that spreadsheets show it; other values, and texts that are numbers, unchanged.

    An apostrophe marks a cell as text.

    >>> safe_cell("=1+1"), safe_cell("-1.5"), safe_cell(-1.5)
    ("'=1+1", '-1.5', -1.5)
    """
    if not isinstance(value, str) or not value.lstrip(" ").startswith(FORMULA):
        return value
    try:
        float(value)
    except ValueError:
        return f"'{value}"
    return value
