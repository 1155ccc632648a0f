"""How numbers become lines of text: separator, decimal sign, thousands separator, quotes, comments."""

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ..errors import InputError

COMMENTS = ("#", "//", ";")
LOST = re.compile(r"[+-]?(nan(\(\w*\))?|inf(inity)?|\d\.#(IND|QNAN|SNAN|INF)\d*)", re.IGNORECASE)
"""How programs write a missing number."""

NUMBER = re.compile(rf"[+-]?(\d+(\.\d*|,\d+)?|[.,]\d+)([eE][+-]?\d+)?|{LOST.pattern}", re.IGNORECASE)

APART = "'\u2019\u00a0\u202f\u2009 "
"""What separates thousands and nothing else: apostrophes and blanks of fixed width."""

GROUPED = re.compile(
    rf"[+-]?\d{{1,3}}(?:(?P<apart>[{APART}])\d{{3}}(?:(?P=apart)\d{{3}})*(?:[.,]\d*)?"
    r"|,\d{3}(?:,\d{3})*\.\d*|\.\d{3}(?:\.\d{3})*,\d+|(?:,\d{3}){2,}|(?:\.\d{3}){2,})"
)
"""A number whose thousands are certainly separated; '1,234' alone may be a decimal number."""

_THOUSANDS = re.compile(r"[+-]?\d{1,3},\d{3}")
COMMA_BLANK = re.compile(r",\s+\S")
SEPARATOR_LINE = re.compile(r'"?sep=(.)"?\s*', re.IGNORECASE)
"""The first line by which a spreadsheet is told the separator."""

EMPTY = ' \t\r\n,;|"\x1a'
"""What a line without any content consists of; the last is the end of a file in DOS."""


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
    thousands : str
        Empty without a separator of thousands.
    """

    delimiter: str
    decimal: str
    width: int
    thousands: str = ""

    def split(self, line: str) -> list[str]:
        """Return the fields of a line."""
        return split(line, self.delimiter)

    def fields(self, line: str) -> list[str]:
        """Return the fields of a line unchanged; joined by the delimiter, they are the line."""
        return raw_fields(line.rstrip("\n"), self.delimiter)

    def number(self, field: str) -> float:
        """Return the value of a field; nan if it is not a number."""
        if not is_number(field):
            return np.nan
        if self.thousands:
            field = field.replace(self.thousands, "")
        try:
            return float(field.replace(self.decimal, "."))
        except ValueError:
            return np.nan


def raw_fields(line: str, delimiter: str) -> list[str]:
    """Return the fields of a line as they are written, a delimiter between quotes being part of its field."""
    quoted = '"' in line and line.count('"') % 2 == 0
    if delimiter == " ":
        return re.findall(r'(?:"[^"]*"|[^\s"])+', line) if quoted else line.split()
    if not quoted:
        return line.split(delimiter)
    # The pieces between quotes alternate with those within them.
    fields, start, inside = [], 0, False
    for position, sign in enumerate(line):
        if sign == '"':
            inside = not inside
        elif sign == delimiter and not inside:
            fields.append(line[start:position])
            start = position + 1
    return [*fields, line[start:]]


def split(line: str, delimiter: str) -> list[str]:
    """Return the fields of a line, free of blanks and quotes."""
    fields = raw_fields(line, delimiter)
    if '"' in line:
        fields = [field.replace('""', "\0").replace('"', "").replace("\0", '"') for field in fields]
    return fields if delimiter == " " else [field.strip() for field in fields]


def is_number(field: str) -> bool:
    """Whether a field is a number, or one that a program wrote as nan or infinite."""
    return bool(NUMBER.fullmatch(field) or GROUPED.fullmatch(field))


def is_comment(line: str) -> bool:
    """Whether a line is empty, has nothing but separators, or is a remark."""
    text = line.strip(EMPTY)
    return not text or line.lstrip().startswith(COMMENTS) or bool(SEPARATOR_LINE.fullmatch(line.strip()))


def is_remark(line: str, delimiter: str, width: int) -> bool:
    """Whether a line is a remark, and not a row whose first field, a name, is empty or begins as they do.

    A sign that is a field of its own, as in '# 500000 5700000 0', always begins a remark.
    """
    if not is_comment(line):
        return False
    fields = split(line, delimiter)
    return len(fields) != width or sum(map(is_number, fields)) < 3 or fields[0] in COMMENTS


def is_count(line: str) -> bool:
    """Whether a line is a single integer, as it precedes the points of a PTS scan."""
    text = line.strip()
    return text.isdecimal() and text.isascii() and len(text) < 13


def stated_delimiter(lines: list[str]) -> Optional[str]:
    """Return the delimiter that a first line such as 'sep=;' states; None without it."""
    match = SEPARATOR_LINE.fullmatch(lines[0].strip("\ufeff\r\n")) if lines else None
    return match and match.group(1)


def delimiter_and_width(path: Path, lines: list[str]) -> tuple[str, int]:
    """Return the delimiter and the number of columns that most lines of numbers have."""
    shapes: Counter[tuple[str, int]] = Counter()
    stated = stated_delimiter(lines)
    for line in lines:
        if is_comment(line):
            continue
        # A comma before a blank ends a column; without one it may be a decimal sign.
        order = (";", "\t", "|", ",", " ") if COMMA_BLANK.search(line) else (";", "\t", "|", " ", ",")
        for delimiter in (stated,) if stated else order:
            fields = split(line, delimiter)
            if sum(map(is_number, fields)) >= 3:
                shapes[delimiter, len(fields)] += 1
                break
    if not shapes:
        if any(_numbers(line.lstrip(" \t#/;")) >= 3 for line in lines if is_comment(line)):
            raise InputError(
                f"{path} holds no points because all lines with numbers begin with #, // or ;, as remarks "
                "do; remove these signs."
            )
        if lines and lines[0].lstrip("\ufeff \t").startswith("<"):
            raise InputError(f"{path} is XML, not a table of numbers; export it again as x y z.")
        raise InputError(
            f"{path} holds no points because no line has three numbers separated by comma, "
            "semicolon, blank or tab; export it again as x y z."
        )
    return shapes.most_common(1)[0][0]


def _numbers(line: str) -> int:
    """Return how many numbers a line has, by the separator that leaves most."""
    return max(sum(map(is_number, split(line, delimiter))) for delimiter in (";", "\t", "|", ",", " "))


def is_row(line: str, delimiter: str, width: int) -> bool:
    """Whether a line holds as many fields as most, and at least three numbers."""
    fields = split(line, delimiter)
    return not is_comment(line) and len(fields) == width and sum(map(is_number, fields)) >= 3


def decimal_signs(path: Path, rows: list[list[str]], delimiter: str, named: bool) -> tuple[str, str]:
    """Return the decimal sign in `rows` and the separator of thousands, empty without one.

    Parameters
    ----------
    path : Path
    rows : list of list of str
        Fields of the columns of numbers.
    delimiter : str
    named : bool
        Whether a header names the columns.

    Raises
    ------
    InputError
        If commas or points can be either.
    """
    fields = [field for row in rows for field in row if is_number(field)]
    thousands, decimal = _grouping(path, fields)
    if decimal:
        return decimal, thousands
    rest = [field.replace(thousands, "") for field in fields] if thousands else fields
    commas = any("," in field for field in rest)
    points = any("." in field and not LOST.fullmatch(field) for field in rest)
    # Four whole numbers between commas may as well be two with decimal commas, and '1,234' between quotes a
    # thousand.
    grouped = commas and all(_THOUSANDS.fullmatch(field) for field in rest if "," in field)
    doubtful = delimiter == "," and not points and (grouped or (not named and len(rows[0]) > 3))
    if doubtful or (commas and points):
        raise InputError(
            f"The commas in {path} can be decimal signs or separators; "
            "write decimal points, or separate the columns by semicolons."
        )
    return "," if commas else ".", thousands


def _grouping(path: Path, fields: list[str]) -> tuple[str, str]:
    """Return the separator of thousands and the decimal sign, as far as numbers with several signs show."""
    found = set()
    for field in fields:
        if GROUPED.fullmatch(field) and not NUMBER.fullmatch(field):
            signs = re.sub(r"[+\-\d]", "", field)
            found.add((signs[0], signs[-1] if signs[-1] != signs[0] else ""))
    separators, decimals = {first for first, _ in found}, {last for _, last in found if last}
    if len(separators) > 1 or len(decimals) > 1 or separators & decimals:
        raise InputError(
            f"The numbers in {path} separate thousands in several ways; write them without such separators."
        )
    thousands = separators.pop() if separators else ""
    return thousands, decimals.pop() if decimals else {",": ".", ".": ","}.get(thousands, "")


def ends_cut_off(lines: list[str], delimiter: str) -> bool:
    """Whether the last number of a file is cut off.

    It is if no line end follows, and the number has fewer decimals than the others of its column, which all
    have one number of decimals. A last field that is not a plain number, such as 1e-05 or a remark, is whole.

    Parameters
    ----------
    lines : list of str
        Some of the last lines of the file, without remarks.
    delimiter : str
    """
    if len(lines) < 3 or lines[-1].endswith(("\n", "\r")):
        return False
    *others, last = [split(line, delimiter) for line in lines]
    decimals = {_decimals(fields[-1]) for fields in others if len(fields) == len(last)}
    (usual,) = decimals if len(decimals) == 1 else (0,)
    return 0 <= _decimals(last[-1]) < usual


def _decimals(field: str) -> int:
    """Return how many decimals a number has, -1 if the field is not a plain number."""
    match = re.fullmatch(r"[+-]?\d*(?:[.,](\d*))?", field)
    return len(match.group(1) or "") if match else -1
