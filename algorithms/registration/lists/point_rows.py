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
    crs : CRS or None
    warnings : tuple of str
    """

    source: str
    places: tuple[str, ...]
    names: Optional[tuple[str, ...]]
    xyz: np.ndarray
    crs: Optional[CRS] = None
    warnings: tuple[str, ...] = ()
