"""What the points of a surface look like: to the camera, and to the laser."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

GATE = 2.5
"""A point whose intensity is off the mean of a region by more than this many times f is not of it."""

SURE = 3.0
"""Two sides are divided by their intensities if these differ by more than this many times f."""


@dataclass(frozen=True)
class Appearance:
    """Colours and intensities.

    Attributes
    ----------
    rgb : ndarray of float32, shape (n, 3)
        0..255.
    relative : ndarray of float32, shape (n,), or None
        Intensities, see `intensity.Relative`; None if there are none.
    threshold : float
        f; regions whose mean intensities differ by less are one surface.
    """

    rgb: np.ndarray
    relative: Optional[np.ndarray] = None
    threshold: float = 0.0

    @property
    def gated(self) -> tuple[np.ndarray, float]:
        """Intensities, shape (n,), and the largest difference of a point to its region; inf without any."""
        if self.relative is None:
            return np.ones(len(self.rgb), np.float32), np.inf
        return self.relative, GATE * self.threshold
