"""Labels of points on a map, as many as there is room for."""

from collections.abc import Sequence
from typing import Optional

import numpy as np

from .figures import LETTER, LINE

DOT = 3.0
"""Half of the square around a point that no label may hide, pixels."""


def place_labels(
    places: np.ndarray, texts: Sequence[str], size: tuple[float, float], leading: int = 0
) -> list[Optional[np.ndarray]]:
    """Return where the labels of points are written, the first ones first.

    Parameters
    ----------
    places : ndarray, shape (n, 2)
        Points, in pixels from the upper left corner of the map.
    texts : sequence of str, length n
    size : (float, float)
        Width and height of the map, pixels.
    leading : int
        So many of the first labels may hide points.

    Returns
    -------
    list of ndarray or None, length n
        Left, top, right and bottom; None where there is no room.
    """
    taken = np.column_stack([places - DOT, places + DOT])
    hidden = np.s_[leading : len(places)]
    boxes: list[Optional[np.ndarray]] = []
    for number, (place, text) in enumerate(zip(places, texts)):
        in_the_way = np.delete(taken, hidden, axis=0) if number < leading else taken
        box = _free_box(place, LETTER * len(text), in_the_way, size)
        if box is not None:
            taken = np.vstack([taken, box])
        boxes.append(box)
    return boxes


def _free_box(
    place: np.ndarray, width: float, taken: np.ndarray, size: tuple[float, float]
) -> Optional[np.ndarray]:
    """Return a box beside a point that is on the map and free, or None if there is none."""
    x, y = place
    starts = ((x + 6, y + 4), (x - 6 - width, y + 4), (x - width / 2, y - 7), (x - width / 2, y + 16))
    for left, base in starts:
        box = np.array([left, base - LINE + 3, left + width, base + 2])
        inside = box[0] >= 0 and box[1] >= 0 and box[2] <= size[0] and box[3] <= size[1]
        if inside and not np.any(np.all((taken[:, :2] < box[2:]) & (taken[:, 2:] > box[:2]), axis=1)):
            return box
    return None
