"""Robust statistics: estimates that a few gross errors do not move."""

from typing import Optional

import numpy as np
from scipy.stats import median_abs_deviation, norm

MAD_TO_SIGMA = float(1 / norm.ppf(0.75))
"""A normal deviate's standard deviation in units of its median absolute deviation, as in scipy."""

EFFICIENT_CUT = 4.685
"""The cut of Tukey's biweight that is 95 % efficient for normal residuals, in standard deviations."""


def sigma_about_median(values: np.ndarray, axis: Optional[int] = None) -> np.ndarray:
    """Return the standard deviation of values about their median, by the median absolute deviation."""
    return median_abs_deviation(values, axis=axis, scale="normal")


def sigma_of_residuals(residuals: np.ndarray) -> float:
    """Return the standard deviation of residuals, whose expectation is 0, by their median magnitude."""
    # scipy's function, which takes a centre too, spends most of its time on checks of small arrays.
    return MAD_TO_SIGMA * float(np.median(np.abs(residuals)))


def weighted_sigma_of_residuals(residuals: np.ndarray, weights: np.ndarray) -> float:
    """Return the standard deviation of weighted residuals, whose expectation is 0."""
    return MAD_TO_SIGMA * weighted_median(np.abs(residuals), weights)


def weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    """Return the smallest of the values up to which half of the weight lies."""
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(total, total[-1] / 2)])


def tukey_weights(residuals: np.ndarray, sigma: float, cut: float) -> np.ndarray:
    """Return the weights of Tukey's biweight, 0 beyond `cut` standard deviations (Beaton and Tukey 1974)."""
    return np.maximum(1 - (residuals / (cut * sigma)) ** 2, 0.0) ** 2
