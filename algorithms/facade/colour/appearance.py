"""Colour and intensity of the points of a surface."""

from dataclasses import dataclass
from typing import Optional

import numpy as np


@dataclass(frozen=True)
class Appearance:
    """Colours and intensities.

    Attributes
    ----------
    rgb : ndarray of float32, shape (n, 3)
        0..255.
    relative : ndarray of float32, shape (n,), or None
        Intensities, see `intensity_scale.Relative`; None without intensity.
    threshold : float
        f; regions whose mean intensities differ by less are one surface.
    """

    rgb: np.ndarray
    relative: Optional[np.ndarray] = None
    threshold: float = 0.0

    def gated(self, gate: float) -> tuple[np.ndarray, float]:
        """Return intensities, shape (n,), and `gate` times f; infinity without intensity."""
        if self.relative is None:
            return np.ones(len(self.rgb), np.float32), np.inf
        return self.relative, gate * self.threshold
