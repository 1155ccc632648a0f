"""Circles through points."""

from typing import Optional

import numpy as np
from scipy.optimize import least_squares

from .curves import Arc


def arc_through(xy: np.ndarray) -> Optional[Arc]:
    """Return the arc through a row of points, shape (n, 2), in their order (Kasa 1976); None on a line."""
    middle = xy.mean(axis=0)
    local = xy - middle
    design = np.column_stack([2 * local, np.ones(len(xy))])
    (x, y, square), _, rank, _ = np.linalg.lstsq(design, (local**2).sum(axis=1), rcond=1e-9)
    if rank < 3:
        return None
    centre = np.array([x, y])
    steps = np.diff(local - centre, axis=0)
    rays = (local[:-1] + local[1:]) / 2 - centre
    sense = 1 if (rays[:, 0] * steps[:, 1] - rays[:, 1] * steps[:, 0]).sum() > 0 else -1
    # Counted from the middle of the row, so that a row of less than a full circle does not pass the cut.
    halfway = local[len(local) // 2] - centre
    radius = float(np.sqrt(square + centre @ centre))
    return Arc(middle + centre, radius, sense, float(np.arctan2(halfway[1], halfway[0])))


def fit_circle_on_axis(
    points: np.ndarray, axis: float, start: np.ndarray, sigma: float
) -> tuple[float, float]:
    """Return the second coordinate of the centre, and the radius, of a circle whose centre lies on an axis.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    axis : float
        First coordinate of the centre.
    start : ndarray, shape (2,)
        First guess of both unknowns.
    sigma : float
        Points farther than this from the circle weigh less (soft L1 loss).
    """

    def residuals(circle: np.ndarray) -> np.ndarray:
        return np.hypot(points[:, 0] - axis, points[:, 1] - circle[0]) - circle[1]

    centre, radius = least_squares(residuals, start, loss="soft_l1", f_scale=sigma).x
    return float(centre), float(radius)
