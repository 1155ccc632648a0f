"""Normals of surfaces among the further attributes of points."""

from collections.abc import Sequence
from typing import Optional

from ...tables.column_names import CLOUD, recognised

ROLES = {role: CLOUD[role] for role in ("nx", "ny", "nz")}


def find_normals(names: Sequence[str]) -> Optional[tuple[int, int, int]]:
    """Return the positions of the three components among `names`; None if any is missing."""
    found = recognised(list(names), ROLES)
    return (found["nx"], found["ny"], found["nz"]) if len(found) == len(ROLES) else None
