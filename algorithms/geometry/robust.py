"""Robust statistics: estimates that a few gross errors do not move."""

from typing import Optional

import numpy as np

MAD_TO_SIGMA = 1.4826
"""A normal deviate's standard deviation in units of its median absolute deviation."""


def sigma_about_median(values: np.ndarray, axis: Optional[int] = None) -> np.ndarray:
    """Return the standard deviation of values about their median, by the median absolute deviation."""
    middle = np.median(values, axis=axis, keepdims=True)
    return MAD_TO_SIGMA * np.median(np.abs(values - middle), axis=axis)


def sigma_of_residuals(residuals: np.ndarray) -> float:
    """Return the standard deviation of residuals, whose expectation is 0, by their median magnitude."""
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
