"""Bring intensity and colour to 0..65535 from the ranges in which programs write them."""

import numpy as np


def intensity_scale(values: np.ndarray, signed: bool = False) -> tuple[float, float]:
    """Return the summand, then the factor, that bring intensities like `values` to 0..65535.

    Parameters
    ----------
    values : ndarray, shape (n,)
        A sample; what is not a number is ignored.
    signed : bool
        Whether the format has -2048..2047, even if no value is negative.
    """
    low, high = np.nanmin(values), np.nanmax(values)
    if low >= 0 and high <= 1 and np.any(values % 1 > 0):
        return 0.0, 65535.0
    if low >= -2048 and high <= 2047 and (signed or low < 0):
        return 2048.0, 65535 / 4095
    return 0.0, 1.0


def rgb_factor(colour: np.ndarray) -> float:
    """Return the factor that brings colours like the sample `colour`, shape (n, 3), to 0..65535."""
    brightest = np.nanmax(colour)
    if brightest <= 1 and np.any(colour % 1 > 0):
        return 65535.0
    return 257.0 if brightest <= 255 else 1.0


def to_uint16(values: np.ndarray) -> np.ndarray:
    """Return `values` rounded and clipped to 0..65535; what is not a number becomes 0."""
    return np.nan_to_num(np.clip(np.rint(values), 0, 65535)).astype(np.uint16)
