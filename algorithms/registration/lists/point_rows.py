"""The rows of a list of points as they are written in a file, before their names are checked."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from rasterio.crs import CRS


@dataclass(frozen=True)
class Rows:
    """Points as they are written.

    Attributes
    ----------
    source : str
        The file or layer, for messages.
    places : tuple of str
        Where each point is written, as 'line 7'.
    names : tuple of str, or None
        None if the file has no names.
    xyz : ndarray of float64, shape (n, 3)
        Metres, finite.
    unit_stated : bool
        Whether the file says in which unit it has them.
    crs : CRS or None
    origins : tuple of str
        The scans that the points come from, if an earlier registration appended them to its control points;
        empty texts for others, and nothing if the file does not say so.
    stds : ndarray of float64, shape (n,), or None
        Standard deviations of a coordinate, metres, if the file has them; nan where unknown.
    covariances : ndarray of float64, shape (n, 3, 3), or None
        Of the coordinates, square metres, if the file has their standard deviations; nan where unknown.
    warnings : tuple of str
    """

    source: str
    places: tuple[str, ...]
    names: Optional[tuple[str, ...]]
    xyz: np.ndarray
    unit_stated: bool = False
    crs: Optional[CRS] = None
    warnings: tuple[str, ...] = ()
    origins: tuple[str, ...] = ()
    stds: Optional[np.ndarray] = None
    covariances: Optional[np.ndarray] = None
