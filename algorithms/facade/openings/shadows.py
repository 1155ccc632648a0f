"""Shadows that things on the ground, such as cars, cast on the foot of a wall beside its doors."""

import numpy as np
from scipy import ndimage

from .settings import RegionSettings
from .states import BEHIND, States


def without_shadows(
    holes: np.ndarray, states: States, wall: np.ndarray, settings: RegionSettings = RegionSettings()
) -> np.ndarray:
    """Return the holes of a wall without the shadows that hang on to them.

    A shadow reaches down to the ground, shows nothing behind the wall, and is lower than the door beside it.

    Parameters
    ----------
    holes, wall : ndarray of bool, shape (rows, columns)
    states : States
    settings : RegionSettings
    """
    kept = holes.copy()
    stands_on_wall = np.logical_or.accumulate(wall, axis=0)
    shown = (states.image == BEHIND) | states.reveals
    labels, _ = ndimage.label(holes)
    for number, box in enumerate(ndimage.find_objects(labels), start=1):
        own = labels[box] == number
        tops = len(own) - own[::-1].argmax(axis=0)
        lowest = own.argmax(axis=0)[None]
        grounded = ~np.take_along_axis(stands_on_wall[box], lowest, axis=0)[0]
        empty = (shown[box] & own).sum(axis=0) <= settings.shown * own.sum(axis=0)
        shadow = grounded & empty & (tops < settings.shadow * len(own))
        kept[box] &= ~(own & shadow)
    return kept
