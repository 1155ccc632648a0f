"""Which points are far from a site: reflections, and what else no surveyor meant."""

import numpy as np

from ..geometry.linked_parts import label_near
from .settings import StraySettings


def stray_cells(
    cells: np.ndarray, counts: np.ndarray, edge_m: float, settings: StraySettings = StraySettings()
) -> np.ndarray:
    """Return which cells of a grid hold stray points.

    Points within the gap between parts of each other belong to one part, wherever the cells begin. A part is
    stray if it holds hardly any of the points, or few and thinly spread.

    Parameters
    ----------
    cells : ndarray of int64, shape (n, 2) or (n, 3)
        Numbers of the cells that hold points.
    counts : ndarray, shape (n,)
        How many each holds.
    edge_m : float
        Edge of a cell, metres.
    settings : StraySettings

    Returns
    -------
    ndarray of bool, shape (n,)
    """
    reach = int(np.ceil(settings.part_gap_m / 2 / edge_m))
    blocks, member = np.unique(cells // reach, axis=0, return_inverse=True)
    # Points within a gap of each other lie in blocks of half a gap that are at most two apart.
    part = label_near(blocks, 2)[member.ravel()]
    points = np.bincount(part, weights=counts)
    share = points / points.sum()
    cover = points / np.bincount(part)
    thin = cover < settings.sparse_cover * cover[np.argmax(points)]
    stray = ((share < settings.sparse_share) & thin) | (share < settings.stray_share)
    stray[np.argmax(points)] = False
    return np.asarray(stray[part])
