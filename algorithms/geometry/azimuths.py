"""Azimuths: directions in degrees clockwise from grid north."""

from collections.abc import Sequence

import numpy as np


def line_azimuth(direction: np.ndarray) -> float:
    """Return the azimuth of a line along a direction (east, north), 0..180, as a line runs both ways."""
    east, north = direction
    return float(np.degrees(np.arctan2(east, north)) % 180.0)


def mean_line_azimuth(directions: Sequence[np.ndarray], weights: Sequence[float]) -> float:
    """Return the weighted mean azimuth of lines along unit vectors (east, north), 0..180."""
    # The angle is doubled because a line runs both ways.
    double = sum(weight * complex(*direction) ** 2 for direction, weight in zip(directions, weights))
    return float((90.0 - np.degrees(np.angle(double)) / 2) % 180.0)
