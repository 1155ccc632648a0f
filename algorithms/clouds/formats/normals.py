"""Normals of surfaces among the further attributes of points."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Optional

import numpy as np

from ...tables.column_names import CLOUD, recognised
from ..settings import TextSettings

ROLES = {role: CLOUD[role] for role in ("nx", "ny", "nz")}


def find_normals(names: Sequence[str]) -> Optional[tuple[int, int, int]]:
    """Return the positions of the three components among `names`; None if any is missing."""
    found = recognised(list(names), ROLES)
    return (found["nx"], found["ny"], found["nz"]) if len(found) == len(ROLES) else None


def unnamed_normals(
    path: Path, columns: Mapping[str, np.ndarray], settings: TextSettings = TextSettings()
) -> tuple[str, ...]:
    """Return a sentence on attributes that seem to be normals but have other names.

    Parameters
    ----------
    path : Path
    columns : mapping of str to ndarray, shape (n,)
        Samples of the further attributes by name, in the order of the file.
    settings : TextSettings
    """
    names = list(columns)
    if find_normals(names) is not None:
        return ()
    for three in zip(names, names[1:], names[2:]):
        vectors = np.stack([columns[name].astype(np.float64) for name in three], axis=1)
        lengths = np.linalg.norm(vectors, axis=1)
        known = lengths[np.isfinite(lengths) & (lengths > 0)]
        # Marks of classes are whole.
        are_units = 2 * len(known) > len(lengths) and np.all(np.abs(known - 1) < settings.unit_length)
        if are_units and np.any(vectors % 1 > 0):
            return (
                f"{', '.join(three)} of {path} seem to be normals; they are not turned if the cloud is, "
                "unless they are called nx, ny and nz.",
            )
    return ()
