"""Find out how a text cloud is written: separator, decimal sign, header and columns."""

import codecs
import io
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from ...errors import InputError
from .normals import find_normals, simplified
from .value_ranges import intensity_scale, rgb_factor

SAMPLE_BYTES = 65536
BYTE_ORDER_MARKS = {
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}
COMMENTS = ("#", "//", ";")
NUMBER = re.compile(r"[+-]?((\d+(\.\d*|,\d+)?|[.,]\d+)([eE][+-]?\d+)?|nan|inf(inity)?)", re.IGNORECASE)

COMMA_BLANK = re.compile(r",\s+\S")

# What columns are called, in the spelling of `simplified`.
NAMES = {
    "x": ("x", "easting", "east", "e", "rechtswert", "points:0", "xcoordinate", "xcoord"),
    "y": ("y", "northing", "north", "n", "hochwert", "points:1", "ycoordinate", "ycoord"),
    "z": (
        *("z", "elevation", "height", "altitude", "h", "höhe", "hoehe"),
        *("points:2", "zcoordinate", "zcoord"),
    ),
    "intensity": ("intensity", "i", "reflectance", "reflectivity", "amplitude", "scalarintensity"),
    "red": ("r", "red", "rf", "rgb:0"),
    "green": ("g", "green", "gf", "rgb:1"),
    "blue": ("b", "blue", "bf", "rgb:2"),
}
DEGREES = {"lat", "latitude", "lon", "long", "longitude"}


@dataclass(frozen=True)
class Dialect:
    """How numbers become lines of text.

    Attributes
    ----------
    delimiter : str
        " " stands for any run of blanks and tabs.
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
        """Return the fields of a line as they stand; put together by the delimiter, they are the line."""
        return line.split() if self.delimiter == " " else line.rstrip("\n").split(self.delimiter)

    def number(self, field: str) -> float:
        """Return the value of a field, not a number if it is none."""
        return float(field.replace(self.decimal, ".")) if NUMBER.fullmatch(field) else np.nan


@dataclass(frozen=True)
class Columns:
    """Where the values stand; columns count from 0.

    Attributes
    ----------
    xyz : tuple of 3 int
    intensity : int or None
    rgb : tuple of 3 int, or None
    normals : tuple of 3 int, or None
    """

    xyz: tuple[int, ...]
    intensity: Optional[int] = None
    rgb: Optional[tuple[int, ...]] = None
    normals: Optional[tuple[int, ...]] = None

    @property
    def used(self) -> tuple[int, ...]:
        """The columns of which the points of a site are made."""
        intensity = () if self.intensity is None else (self.intensity,)
        return (*self.xyz, *intensity, *(self.rgb or ()))


@dataclass(frozen=True)
class Layout:
    """How a text cloud is to be read.

    Attributes
    ----------
    encoding : str
    dialect : Dialect
    columns : Columns
    preamble : int
        Number of lines before the first point.
    announced : int or None
        Number of points that the count line of a PTS promises; None if there is none.
    intensity_scale : tuple of 2 float
        Summand, then factor, that bring the intensity to 0..65535.
    rgb_factor : float
        Brings the colour to 0..65535.
    middle : ndarray of float64, shape (3,)
        Median of the first coordinates.
    warnings : tuple of str
    """

    encoding: str
    dialect: Dialect
    columns: Columns
    preamble: int
    announced: Optional[int]
    intensity_scale: tuple[float, float]
    rgb_factor: float
    middle: np.ndarray
    warnings: tuple[str, ...]


def sniff(path: Path) -> Layout:
    """Find out from the beginning of `path` how it is written.

    Raises
    ------
    InputError
        If the file is not text, holds no points, or can be read in more than one way.
    """
    encoding, lines = _first_lines(path)
    delimiter, width = delimiter_and_width(path, lines)
    numbers = [index for index, line in enumerate(lines) if _is_row(line, delimiter, width)]
    rows = [split(lines[index], delimiter) for index in numbers]
    names, announced = read_preamble(path, lines[: numbers[0]], delimiter, width)
    dialect = Dialect(delimiter, decimal_sign(path, rows, delimiter, names), width)
    values = np.array([[dialect.number(field) for field in row] for row in rows])
    columns, warnings = (_columns_by_name(names), ()) if names else _columns_by_count(path, rows, values)
    return Layout(
        encoding=encoding,
        dialect=dialect,
        columns=columns,
        preamble=numbers[0],
        announced=announced,
        intensity_scale=(
            (0.0, 1.0)
            if columns.intensity is None
            else intensity_scale(values[:, columns.intensity], path.suffix.lower() == ".pts")
        ),
        rgb_factor=rgb_factor(values[:, columns.rgb]) if columns.rgb else 1.0,
        middle=_middle(path, values[:, columns.xyz]),
        warnings=warnings,
    )


def split(line: str, delimiter: str) -> list[str]:
    """Return the fields of a line, free of blanks and quotes."""
    line = line.replace('"', "")
    if delimiter == " ":
        return line.split()
    return [field.strip() for field in line.split(delimiter)]


def is_comment(line: str) -> bool:
    """Tell whether a line is empty or a remark."""
    return not line.strip() or line.lstrip().startswith(COMMENTS)


def is_count(line: str) -> bool:
    """Tell whether a line is a lone integer, as it precedes the points of a PTS scan."""
    return line.strip().isdecimal()


def _first_lines(path: Path) -> tuple[str, list[str]]:
    with path.open("rb") as stream:
        sample = stream.read(SAMPLE_BYTES)
        goes_on = bool(stream.read(1))
    marks = [name for mark, name in BYTE_ORDER_MARKS.items() if sample.startswith(mark)]
    encoding = marks[0] if marks else "utf-8"
    if encoding != "utf-16" and b"\0" in sample:
        raise InputError(f"{path} is not a text file; give it the extension of its format.")
    lines = list(io.StringIO(sample.decode(encoding, errors="replace"), newline=None))
    if lines and lines[0].lower().startswith("ncols"):
        raise InputError(f"{path} is a raster grid, not a point cloud; choose the cloud itself.")
    return encoding, lines[:-1] if goes_on else lines


def delimiter_and_width(path: Path, lines: list[str]) -> tuple[str, int]:
    """Return what most lines of numbers have in common."""
    shapes = Counter()
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
            f"{path} holds no points, for no line has three numbers separated by comma, "
            "semicolon, blank or tab; export it again as x y z."
        )
    return shapes.most_common(1)[0][0]


def _is_row(line: str, delimiter: str, width: int) -> bool:
    fields = split(line, delimiter)
    numbers = sum(bool(NUMBER.fullmatch(field)) for field in fields)
    return not is_comment(line) and len(fields) == width and numbers >= 3


def read_preamble(
    path: Path, lines: list[str], delimiter: str, width: int, roles: dict[str, tuple] = NAMES
) -> tuple[dict[str, int], Optional[int]]:
    """Return the known names with their columns, and the promised number of points."""
    names: dict[str, int] = {}
    announced = None
    for number, line in enumerate(lines, start=1):
        fields = split(line.strip().lstrip("#/;"), delimiter)
        if is_count(line):
            announced = (announced or 0) + int(line)
        elif len(fields) == width:
            names = _recognise(fields, roles) or names
        if is_count(line) or (is_comment(line) and not _speaks_of_degrees(fields)):
            continue
        if all(NUMBER.fullmatch(field) for field in fields):
            raise InputError(
                f"{path} has {len(fields)} columns in line {number} where most lines have "
                f"{width}; correct or remove that line."
            )
        named = _recognise(fields, roles)
        if (named and len(fields) != width) or (len(fields) == width and not names):
            raise _unclear_header(path, number, fields, width)
    return names, announced


def _recognise(fields: list[str], roles: dict[str, tuple]) -> dict[str, int]:
    """Return the column of every known name; nothing unless x, y and z are among them."""
    keys = [simplified(field) for field in fields]
    found = {}
    for role, aliases in roles.items():
        column = next((keys.index(alias) for alias in aliases if alias in keys), None)
        if column is not None:
            found[role] = column
    found.update(zip(("nx", "ny", "nz"), find_normals(fields) or ()))
    return found if {"x", "y", "z"} <= found.keys() else {}


def _speaks_of_degrees(fields: list[str]) -> bool:
    # A single such word may be prose, as the long wall.
    return len(DEGREES & {simplified(field) for field in fields}) > 1


def _unclear_header(path: Path, number: int, fields: list[str], width: int) -> InputError:
    if DEGREES & {simplified(field) for field in fields}:
        return InputError(
            f"{path} has geographic coordinates in degrees; "
            "reproject it to a projected coordinate reference system in metres."
        )
    return InputError(
        f"The header in line {number} of {path} does not name the {width} columns of the lines "
        "below; name them, with x, y and z or easting, northing and height among them."
    )


def decimal_sign(path: Path, rows: list[list[str]], delimiter: str, names: dict[str, int]) -> str:
    """Return the sign that `rows` have; `names` are the columns that a header names, if there is one."""
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


def _columns_by_name(names: dict[str, int]) -> Columns:
    return Columns(
        xyz=(names["x"], names["y"], names["z"]),
        intensity=names.get("intensity"),
        rgb=_triple(names, "red", "green", "blue"),
        normals=_triple(names, "nx", "ny", "nz"),
    )


def _triple(names: dict[str, int], *roles: str) -> Optional[tuple[int, ...]]:
    return tuple(names[role] for role in roles) if set(roles) <= names.keys() else None


def _columns_by_count(
    path: Path, rows: list[list[str]], values: np.ndarray
) -> tuple[Columns, tuple[str, ...]]:
    """Guess the columns as most programs write them: x y z, then intensity, then colour."""
    shares = np.mean([_are_numbers(row) for row in rows], axis=0)
    numeric = np.flatnonzero(shares >= 0.5).tolist()
    if len(numeric) > 3 and _is_label(rows, values, numeric):
        numeric = numeric[1:]
    if len(numeric) < 3:
        raise InputError(f"{path} has fewer than three columns of numbers; export it as x y z.")
    xyz, extra = tuple(numeric[:3]), tuple(numeric[3:])
    if len(extra) in (3, 4) and _look_like_colour(values[:, extra[-3:]]):
        return Columns(xyz, extra[0] if len(extra) == 4 else None, extra[-3:]), ()
    if len(extra) == 1:
        return Columns(xyz, extra[0]), ()
    ignored = f"The columns of {path} after x y z have no names and were left out."
    return Columns(xyz), (ignored,) if extra else ()


def _are_numbers(row: list[str]) -> list[bool]:
    return [bool(NUMBER.fullmatch(field)) for field in row]


def _is_label(rows: list[list[str]], values: np.ndarray, numeric: np.ndarray) -> bool:
    """Tell whether the first numeric column only numbers the points.

    That is when nothing in it repeats or has decimals, while the next three columns have.
    """
    labels = [row[numeric[0]] for row in rows]
    coordinates = values[:, numeric[1:4]]
    whole = not any(re.search("[.,]", label) for label in labels)
    fractional = np.all(np.any(coordinates % 1 > 0, axis=0))
    return whole and fractional and len(rows) > 1 and len(set(labels)) == len(rows)


def _look_like_colour(values: np.ndarray) -> bool:
    whole = np.all(values % 1 == 0)
    return bool(whole and values.min() >= 0 and 1 < values.max() <= 65535)


def _middle(path: Path, xyz: np.ndarray) -> np.ndarray:
    finite = xyz[np.isfinite(xyz).all(axis=1)]
    if not len(finite):
        raise InputError(f"{path} has coordinates that are not numbers; export it again.")
    return np.median(finite, axis=0)
