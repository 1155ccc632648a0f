"""Normals of surfaces among the further attributes of points."""

import re
from collections.abc import Sequence
from typing import Optional

NAMES = (
    ("nx", "normalx", "normalsx", "normals:0", "nor:normalx", "scalarnx"),
    ("ny", "normaly", "normalsy", "normals:1", "nor:normaly", "scalarny"),
    ("nz", "normalz", "normalsz", "normals:2", "nor:normalz", "scalarnz"),
)
"""What the components are called, in the spelling of `simplified`."""


def simplified(name: str) -> str:
    """Return a column's name in lower case, free of units, blanks, underscores and hyphens."""
    return re.sub(r"[\[(].*?[\])]|[\s_-]", "", name.lower())


def find_normals(names: Sequence[str]) -> Optional[tuple[int, int, int]]:
    """Return the positions of the three components among `names`; None if any is missing."""
    keys = [simplified(name) for name in names]
    found = [
        next(keys.index(alias) for alias in aliases if alias in keys)
        for aliases in NAMES
        if not set(aliases).isdisjoint(keys)
    ]
    return (found[0], found[1], found[2]) if len(found) == 3 else None
