"""What the cut cannot see: that a tall face was seen from one side, and has a wall on the other.

Furniture is left before walls whose back is a better face than its front, and thin partitions are lost where
the noise of floor and ceiling fills their core.
"""

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


def fill_between(
    is_room: np.ndarray,
    unseen: np.ndarray,
    areas: np.ndarray,
    sides: np.ndarray,
    lengths: np.ndarray,
    cost: np.ndarray,
    closed: np.ndarray,
    settings: CutSettings = CutSettings(),
) -> np.ndarray:
    """Make solid of cells between the two faces of a partition that would otherwise have room on both sides.

    The opposite of `give_back`, cell by cell: so that pieces of a partition between crossing lines are judged
    together, what is shorter or thinner than partitions becomes room again in the end. Parameters as those of
    `give_back`, but two.

    Parameters
    ----------
    areas : ndarray of float, shape (cells,)
        Of the cells, m2.
    closed : ndarray of float, shape (borders,)
        How full a border is at eye level and above, 0 to 1, so that openings are empty.
    """
    found, count = is_room.copy(), len(is_room)
    gain = cost - settings.unexplained_m * lengths * closed
    hidden = np.append(-unseen < settings.filled_core * areas, False)
    areas = np.append(areas, np.inf)
    # Each round fills one cell, so that it ends.
    while True:
        change, rim, faced = np.append(-unseen, np.inf), np.zeros(count), np.zeros(count)
        for own, other in (sides.T, sides.T[::-1]):
            beside = found[other]
            np.add.at(change, own, np.where(beside, gain, -gain))
            rim += np.bincount(own[beside] % count, lengths[beside], count)
            faced += np.bincount(own[beside] % count, (lengths * (closed > 0))[beside], count)
        between = hidden & (faced > settings.between_share * rim) & (2 * areas <= settings.thickest_m * faced)
        change[~found | ~between] = np.inf
        best = int(np.argmin(change))
        if change[best] > -LEAST:
            break
        found[best] = False
    return found | _are_scraps(is_room & ~found, areas, sides, lengths * (closed > 0), settings)


def _are_scraps(
    filled: np.ndarray, areas: np.ndarray, sides: np.ndarray, faces: np.ndarray, settings: CutSettings
) -> np.ndarray:
    """Return the filled cells that together are shorter or thinner than partitions."""
    count = len(filled)
    first, second = sides[filled[sides].all(axis=1)].T
    part = label_linked(first, second, count)
    rim = filled[sides].sum(axis=1) == 1
    owner = part[np.where(filled[sides[rim, 0]], sides[rim, 0], sides[rim, 1])]
    faced = np.bincount(owner, faces[rim], count)
    area = np.bincount(part, np.where(filled, areas, 0), count)
    scrap = (faced < 2 * settings.partition_m) | (2 * area < settings.thinnest_m * faced)
    return filled & scrap[part]
