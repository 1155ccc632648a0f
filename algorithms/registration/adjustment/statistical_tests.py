"""The tests of an adjustment: global test, Baarda's w, Pope's tau and minimal detectable biases."""

from typing import Optional

import numpy as np
from scipy import stats

from ..results import GlobalTest
from .settings import OutlierTestSettings


def global_test(
    sum_of_squares: float, redundancy: float, settings: OutlierTestSettings = OutlierTestSettings()
) -> GlobalTest:
    """Return the chi-square test of v'Pv against the a priori standard deviations."""
    if redundancy < settings.least_redundancy:
        return GlobalTest(sum_of_squares, redundancy, float("nan"), float("nan"))
    return GlobalTest(
        sum_of_squares=sum_of_squares,
        redundancy=redundancy,
        sigma0=float(np.sqrt(sum_of_squares / redundancy)),
        probability=float(stats.chi2.sf(sum_of_squares, redundancy)),
    )


def critical_tau(redundancy: float, settings: OutlierTestSettings = OutlierTestSettings()) -> float:
    """Return the |tau| beyond which an observation is suspected; infinite without redundancy.

    Pope (1976): tau follows from Student's t with n - u - 1 degrees of freedom.
    """
    if redundancy <= 1:
        return float("inf")
    t = stats.t.isf(settings.significance / 2, redundancy - 1)
    return float(t * np.sqrt(redundancy / (redundancy - 1 + t**2)))


def normalized_residuals(
    residuals: np.ndarray,
    cofactors: np.ndarray,
    weights: np.ndarray,
    settings: OutlierTestSettings = OutlierTestSettings(),
) -> np.ndarray:
    """Return Baarda's w, nan where nothing checks an observation.

    Parameters
    ----------
    residuals : ndarray
        P v; of unrelated observations, v / sigma.
    cofactors : ndarray
        The diagonal of P Qvv P; of unrelated observations, the redundancy numbers.
    weights : ndarray
        The diagonal of P; of unrelated observations, 1.
    settings : OutlierTestSettings
    """
    return divided(residuals, _roots(cofactors, weights, settings))


def detectable_biases(
    cofactors: np.ndarray, weights: np.ndarray, settings: OutlierTestSettings = OutlierTestSettings()
) -> np.ndarray:
    """Return the minimal detectable biases, nan where nothing checks an observation.

    They are delta0 over the roots of the diagonal of P Qvv P; of unrelated observations,
    sigma delta0 / sqrt(r).

    Parameters
    ----------
    cofactors, weights : ndarray
        As of `normalized_residuals`.
    settings : OutlierTestSettings
    """
    roots = _roots(cofactors, weights, settings)
    return divided(np.full(roots.shape, settings.noncentrality), roots)


def _roots(cofactors: np.ndarray, weights: np.ndarray, settings: OutlierTestSettings) -> np.ndarray:
    """Return the roots of the cofactors, 0 where they are only rounding error."""
    controlled = cofactors > settings.least_redundancy * weights
    return np.where(controlled, np.sqrt(np.abs(cofactors)), 0.0)


def worst_target(
    normalized: np.ndarray,
    sigma0: float,
    redundancy: float,
    settings: OutlierTestSettings = OutlierTestSettings(),
) -> Optional[int]:
    """Return the row with the largest |w| if both tests suspect it, else None.

    The tests are Baarda's, by the a priori standard deviations, and Pope's, by the a posteriori one, so that
    an underestimated standard deviation causes no rejections.

    Parameters
    ----------
    normalized : ndarray, shape (k, 3)
        Baarda's w.
    sigma0, redundancy : float
        Of the scan.
    settings : OutlierTestSettings
    """
    if redundancy <= 1:
        return None
    largest = np.nan_to_num(np.abs(normalized)).max(axis=1)
    worst = int(largest.argmax())
    limit = max(settings.critical_w, critical_tau(redundancy, settings) * sigma0)
    return worst if largest[worst] > limit else None


def spread_factor(test: GlobalTest, settings: OutlierTestSettings = OutlierTestSettings()) -> float:
    """Return the sigma0 of the paper's eq. 5; 1 without redundancy."""
    return test.sigma0 if test.redundancy >= settings.least_redundancy else 1.0


def divided(values: np.ndarray, by: np.ndarray) -> np.ndarray:
    """Return `values / by`, nan where `by` is not positive."""
    positive = by > 0
    return np.where(positive, values / np.where(positive, by, 1.0), np.nan)
