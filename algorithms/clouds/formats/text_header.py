"""The lines before the first point: names of columns, and how many points follow."""

from pathlib import Path
from typing import Optional

from ...errors import InputError
from .normals import find_normals, simplified
from .text_dialect import NUMBER, is_comment, is_count, split

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
"""What columns are called, in the spelling of `simplified`."""

DEGREES = {"lat", "latitude", "lon", "long", "longitude"}


def read_preamble(
    path: Path, lines: list[str], delimiter: str, width: int, roles: dict[str, tuple[str, ...]] = NAMES
) -> tuple[dict[str, int], Optional[int]]:
    """Return the known names with their columns, and the announced number of points."""
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


def _recognise(fields: list[str], roles: dict[str, tuple[str, ...]]) -> dict[str, int]:
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
    # A single such word may be prose, as in "the long wall".
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
