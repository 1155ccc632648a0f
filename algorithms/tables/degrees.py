"""Geographic coordinates in columns whose names do not say so."""

from collections.abc import Iterable
from pathlib import Path

from .dialect import Dialect

LIMITS = (180.0, 90.0)
"""The largest longitude and latitude, in either order."""

FINER = 3
"""By how many decimals degrees are written more finely than heights: a degree is 100 km."""

FEWEST_DECIMALS = 6
"""Of degrees that are exact to a decimetre."""


def degree_warning(path: Path, rows: Iterable[list[str]], dialect: Dialect) -> tuple[str, ...]:
    """Return a sentence if the first two of three columns seem to be longitude and latitude.

    They do if they are in the range of degrees, and written with many more decimals than the third.

    Parameters
    ----------
    path : Path
    rows : iterable of list of str
        The fields of x, y and z.
    dialect : Dialect
    """
    rows = list(rows)
    if not rows or not all(_may_be_degrees(row, dialect) for row in rows):
        return ()
    return (
        f"x and y of {path} seem to be degrees, because they have many more decimals than z; reproject them "
        "to a projected coordinate reference system in metres.",
    )


def _may_be_degrees(row: list[str], dialect: Dialect) -> bool:
    x, y, z = (_decimals(field, dialect) for field in row)
    first, second = sorted(abs(dialect.number(field)) for field in row[:2])
    in_range = first <= LIMITS[1] and second <= LIMITS[0]
    return in_range and min(x, y) >= max(z + FINER, FEWEST_DECIMALS)


def _decimals(field: str, dialect: Dialect) -> int:
    return len(field.partition(dialect.decimal)[2])
