"""The inner face of a wall: a surface close to the wall and parallel to it, seen from the rooms."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from .settings import SideSettings


@dataclass(frozen=True)
class Face:
    """A surface parallel to a wall.

    Attributes
    ----------
    offset : float
        Distance from the wall (m).
    share : float
        Part of the wall that it covers.
    """

    offset: float
    share: float


def find_face(
    cells: np.ndarray, distances: np.ndarray, wall: int, settings: SideSettings = SideSettings()
) -> Optional[Face]:
    """Return the parallel surface that covers most of a wall, on one side of it.

    Parameters
    ----------
    cells : ndarray of int64, shape (n,)
        The pixel of the wall before or behind which each point lies.
    distances : ndarray of float64, shape (n,)
        Of the points from the wall, on this side of it (m).
    wall : int
        Number of pixels of the wall.
    settings : SideSettings
    """
    near = (distances >= settings.thinnest_m) & (distances <= settings.thickest_m)
    if not near.any():
        return None
    step = settings.flat_m
    bins = np.floor(distances[near] / step).astype(np.int64)
    held = np.unique(cells[near] * (bins.max() + 2) + bins)
    counts = np.bincount(held % (bins.max() + 2), minlength=bins.max() + 2)
    # A surface can lie across the limit of two bins.
    best = int(np.argmax(counts[:-1] + counts[1:]))
    within = near & (np.abs(distances - (best + 1) * step) <= step)
    share = len(np.unique(cells[within])) / max(wall, 1)
    return Face(float(np.median(distances[within])), float(share))
