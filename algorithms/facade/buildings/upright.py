"""The points of a cloud that can lie on walls."""

import numpy as np
import pandas as pd

from .settings import UprightSettings


def upright_rows(xyz: np.ndarray, settings: UprightSettings = UprightSettings()) -> np.ndarray:
    """Return the points in columns with points on many levels, as walls have and the ground has not.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
    settings : UprightSettings
    """
    if not len(xyz):
        return np.empty(0, np.int64)
    sides = (settings.column_m, settings.column_m, settings.level_m)
    x, y, z = (
        np.floor((xyz[:, axis] - xyz[:, axis].min()) / side).astype(np.int64)
        for axis, side in enumerate(sides)
    )
    column, columns = pd.factorize(x * (y.max() + 1) + y)
    occupied = pd.unique(column * (z.max() + 1) + z)
    levels = np.bincount(occupied // (z.max() + 1), minlength=len(columns))
    return np.flatnonzero((levels * settings.level_m >= settings.least_m)[column])
