"""Bring intensity and colour to 0..65535 from the ranges in which programs write them."""

from pathlib import Path

import numpy as np

from ...errors import InputError

WIDEST = 65535


def intensity_scale(values: np.ndarray, signed: bool = False, relative: bool = False) -> tuple[float, float]:
    """Return the summand, then the factor, that bring intensities like `values` to 0..65535.

    Parameters
    ----------
    values : ndarray, shape (n,)
        A sample; what is not a finite number is ignored.
    signed : bool
        Whether the format has -2048..2047, even if no value is negative, unless all are of 8 bits.
    relative : bool
        Whether the format has intensities relative to the largest one, so that 1 or 255 may be that.
    """
    values = values[np.isfinite(values)]
    if not len(values):
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    whole = not np.any(values % 1)
    if low >= -2048 and high <= 2047 and whole and ((signed and high > 255) or low < 0):
        return 2048.0, WIDEST / 4095
    if low < 0:
        return -low, WIDEST / (high - low) if high > low else 1.0
    if high <= 1 and (relative or not whole):
        return 0.0, float(WIDEST)
    if high <= 255 and relative:
        return 0.0, 257.0
    return 0.0, 1.0 if high <= WIDEST else WIDEST / high


def rgb_factor(colour: np.ndarray) -> float:
    """Return the factor that brings colours like the sample `colour`, shape (n, 3), to 0..65535.

    Colours of 8 bits in a field of 16 are recognised by the brightest of the sample, which must be from
    all over the file.
    """
    brightest = np.max(colour, where=np.isfinite(colour), initial=0.0)
    if brightest <= 1 and np.any(colour % 1 > 0):
        return float(WIDEST)
    return 257.0 if brightest <= 255 else 1.0


def scaled_colour(path: Path, colour: np.ndarray, factor: float) -> np.ndarray:
    """Return colours brought to 0..65535 by the factor of their file.

    Raises
    ------
    InputError
        If a colour contradicts the range that the sample of the file has.
    """
    limit = WIDEST / factor
    if factor > 1 and np.any(colour > limit):
        raise InputError(
            f"{path} has colours above {limit:.0f}, though points from all over the file have none; "
            "export it again with colours of one range, or without colour."
        )
    return to_uint16(colour * factor)


def to_uint16(values: np.ndarray) -> np.ndarray:
    """Return `values` rounded and clipped to 0..65535; what is not a number becomes 0."""
    return np.nan_to_num(np.clip(np.rint(values), 0, WIDEST)).astype(np.uint16)
