"""Which points are far from a site: reflections, and what else no surveyor meant."""

from itertools import product

import numpy as np

from ..geometry.linked_parts import label_linked
from .settings import StraySettings


def stray_cells(
    cells: np.ndarray, counts: np.ndarray, edge_m: float, settings: StraySettings = StraySettings()
) -> np.ndarray:
    """Return which cells of a grid hold stray points.

    Cells within the gap between parts of each other are one part. A part is stray if it holds hardly any of
    the points, or few and thinly spread.

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
    reach = max(round(settings.part_gap_m / 2 / edge_m), 1)
    blocks, member = np.unique(cells // reach, axis=0, return_inverse=True)
    part = _connected(blocks)[member.ravel()]
    points = np.bincount(part, weights=counts)
    share = points / points.sum()
    cover = points / np.bincount(part)
    thin = cover < settings.sparse_cover * cover[np.argmax(points)]
    stray = ((share < settings.sparse_share) & thin) | (share < settings.stray_share)
    stray[np.argmax(points)] = False
    return np.asarray(stray[part])


def _connected(blocks: np.ndarray) -> np.ndarray:
    """Label blocks, shape (n, axes), so that those that touch, also by a corner, have one label."""
    number = {tuple(block): i for i, block in enumerate(blocks.tolist())}
    around = list(product((-1, 0, 1), repeat=blocks.shape[1]))
    near = ((i, tuple(map(sum, zip(block, step)))) for block, i in number.items() for step in around)
    first, second = np.array([(i, number[block]) for i, block in near if block in number]).T
    return label_linked(first, second, len(blocks))
