"""What an adjustment says about itself: tests, and the limits of what they can see."""

import numpy as np
from scipy import stats

from ..results import GlobalTest

ALPHA = 0.001
"""Significance level of the tests for outliers (Baarda's data snooping)."""

POWER = 0.80
"""With which a bias of the minimal detectable size is found."""

CRITICAL_W = float(stats.norm.isf(ALPHA / 2))
"""Beyond this |w| an observation is suspected."""

NONCENTRALITY = CRITICAL_W + float(stats.norm.ppf(POWER))
"""Baarda's delta0."""

UNCONTROLLED = 1e-9
"""Below this redundancy number nothing controls an observation."""


def global_test(sum_of_squares: float, redundancy: float) -> GlobalTest:
    """Return the chi-square test of v'Pv against the a priori standard deviations."""
    if redundancy < UNCONTROLLED:
        return GlobalTest(sum_of_squares, redundancy, float("nan"), float("nan"))
    return GlobalTest(
        sum_of_squares=sum_of_squares,
        redundancy=redundancy,
        sigma0=float(np.sqrt(sum_of_squares / redundancy)),
        probability=float(stats.chi2.sf(sum_of_squares, redundancy)),
    )


def critical_tau(redundancy: float) -> float:
    """Return beyond which Pope's |tau| an observation is suspected; infinite without redundancy.

    Pope (1976): tau follows from Student's t with n - u - 1 degrees of freedom.
    """
    if redundancy <= 1:
        return float("inf")
    t = stats.t.isf(ALPHA / 2, redundancy - 1)
    return float(t * np.sqrt(redundancy / (redundancy - 1 + t**2)))


def spread_factor(test: GlobalTest) -> float:
    """Return the sigma0 of the paper's eq. 5; 1 where nothing is redundant."""
    return test.sigma0 if test.redundancy >= UNCONTROLLED else 1.0


def divided(values: np.ndarray, by: np.ndarray) -> np.ndarray:
    """Return `values / by`, nan where `by` is not positive."""
    positive = by > 0
    return np.where(positive, values / np.where(positive, by, 1.0), np.nan)
