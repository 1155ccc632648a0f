"""How numbers become lines of text: separator, decimal sign, comments."""

import codecs
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...errors import InputError

BYTE_ORDER_MARKS = {
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}

COMMENTS = ("#", "//", ";")
NUMBER = re.compile(r"[+-]?((\d+(\.\d*|,\d+)?|[.,]\d+)([eE][+-]?\d+)?|nan|inf(inity)?)", re.IGNORECASE)

COMMA_BLANK = re.compile(r",\s+\S")


@dataclass(frozen=True)
class Dialect:
    """How numbers become lines of text.

    Attributes
    ----------
    delimiter : str
        " " means any run of blanks and tabs.
    decimal : str
    width : int
        Number of columns.
    """

    delimiter: str
    decimal: str
    width: int

    def split(self, line: str) -> list[str]:
        """Return the fields of a line."""
        return split(line, self.delimiter)

    def fields(self, line: str) -> list[str]:
        """Return the fields of a line unchanged; joined by the delimiter, they are the line."""
        return line.split() if self.delimiter == " " else line.rstrip("\n").split(self.delimiter)

    def number(self, field: str) -> float:
        """Return the value of a field; nan if it is not a number."""
        return float(field.replace(self.decimal, ".")) if NUMBER.fullmatch(field) else np.nan


def split(line: str, delimiter: str) -> list[str]:
    """Return the fields of a line, free of blanks and quotes."""
    line = line.replace('"', "")
    if delimiter == " ":
        return line.split()
    return [field.strip() for field in line.split(delimiter)]


def is_comment(line: str) -> bool:
    """Whether a line is empty or a remark."""
    return not line.strip() or line.lstrip().startswith(COMMENTS)


def is_count(line: str) -> bool:
    """Whether a line is a single integer, as it precedes the points of a PTS scan."""
    return line.strip().isdecimal()


def delimiter_and_width(path: Path, lines: list[str]) -> tuple[str, int]:
    """Return the delimiter and the number of columns that most lines of numbers have."""
    shapes: Counter[tuple[str, int]] = Counter()
    for line in lines:
        if is_comment(line):
            continue
        # A comma before a blank ends a column; without one it may be a decimal sign.
        order = (";", "\t", ",", " ") if COMMA_BLANK.search(line) else (";", "\t", " ", ",")
        for delimiter in order:
            fields = split(line, delimiter)
            if sum(bool(NUMBER.fullmatch(field)) for field in fields) >= 3:
                shapes[delimiter, len(fields)] += 1
                break
    if not shapes:
        raise InputError(
            f"{path} holds no points because no line has three numbers separated by comma, "
            "semicolon, blank or tab; export it again as x y z."
        )
    return shapes.most_common(1)[0][0]


def is_row(line: str, delimiter: str, width: int) -> bool:
    """Whether a line holds as many fields as most, and at least three numbers."""
    fields = split(line, delimiter)
    numbers = sum(bool(NUMBER.fullmatch(field)) for field in fields)
    return not is_comment(line) and len(fields) == width and numbers >= 3


def decimal_sign(path: Path, rows: list[list[str]], delimiter: str, names: dict[str, int]) -> str:
    """Return the decimal sign in `rows`; `names` are the columns that a header names, if there is one."""
    fields = [field for row in rows for field in row if NUMBER.fullmatch(field)]
    commas = any("," in field for field in fields)
    points = any("." in field for field in fields)
    # Four whole numbers between commas may as well be two with decimal commas.
    doubtful = delimiter == "," and not points and not names and len(rows[0]) > 3
    if doubtful or (commas and points):
        raise InputError(
            f"The commas in {path} can be decimal signs or separators; "
            "write decimal points, or separate the columns by semicolons."
        )
    return "," if commas else "."
