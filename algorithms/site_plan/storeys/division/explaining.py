"""What the cut leaves before walls: furniture whose back is a better face than its front."""

import numpy as np

from ....geometry.linked_parts import label_linked
from ..settings import CutSettings

PASSES = 300
"""Most groups of cells that are given back."""

LEAST = 1e-6
"""A change for the better is at least so much, m2."""


def give_back(
    is_room: np.ndarray,
    unseen: np.ndarray,
    sides: np.ndarray,
    lengths: np.ndarray,
    cost: np.ndarray,
    tall: np.ndarray,
    settings: CutSettings = CutSettings(),
) -> np.ndarray:
    """Make room of what is solid before a face that would otherwise stand inside of solid.

    A tall face must have been seen from somewhere: with solid, or with room, on both of its sides it is not
    explained, which costs. Cells that no tall face parts go together; the best group comes first.

    Parameters
    ----------
    is_room : ndarray of bool, shape (cells + 1,)
        The last cell is what lies outside, and is kept.
    unseen : ndarray of float, shape (cells,)
        What it costs to call a cell room in place of solid, m2.
    sides : ndarray of int, shape (borders, 2)
        The cells on both sides of a border.
    lengths, cost : ndarray of float, shape (borders,)
        Metres, and what a border between room and solid costs, m2.
    tall : ndarray of float, shape (borders,)
        How full a border is above furniture, 0 to 1.
    settings : CutSettings

    Returns
    -------
    ndarray of bool, shape (cells + 1,)
    """
    is_room, count = is_room.copy(), len(is_room)
    # A border that comes to be costs, but then explains its face.
    gain = cost - settings.unexplained_m * lengths * tall
    parts = tall >= settings.parting
    for _ in range(PASSES):
        solid = ~is_room
        first, second = sides[solid[sides].all(axis=1) & ~parts].T % count
        group = label_linked(first, second, count)
        change = np.bincount(group[:-1], unseen * solid[:-1], count)
        for own, other in (sides.T, sides.T[::-1]):
            rim = solid[own] & (group[own] != group[other])
            np.add.at(change, group[own[rim]], np.where(is_room[other], -gain, gain)[rim])
        change[group[-1]] = 0
        best = int(np.argmin(change))
        if change[best] > -LEAST:
            break
        is_room[solid & (group == best)] = True
    return is_room
