"""Covariances of points from the standard deviations and correlations of their coordinates in a list."""

import numpy as np

from .settings import ListSettings

STDS = ("sx", "sy", "sz")
"""Standard deviations along x, y and z."""

CORRELATIONS = ("rxy", "rxz", "ryz")
"""Correlations between x and y, x and z, y and z."""


def covariances_of(stds: np.ndarray, correlations: np.ndarray) -> np.ndarray:
    """Return the covariance of each point, nan where a standard deviation is not positive or unknown.

    Parameters
    ----------
    stds : ndarray, shape (n, 3)
        Metres.
    correlations : ndarray, shape (n, 3)
        In the order of `CORRELATIONS`; nan counts as 0.

    Returns
    -------
    ndarray, shape (n, 3, 3)
        Square metres; also nan where the correlations contradict each other.
    """
    matrix = np.tile(np.eye(3), (len(stds), 1, 1))
    for number, (row, column) in enumerate(((0, 1), (0, 2), (1, 2))):
        matrix[:, row, column] = matrix[:, column, row] = np.nan_to_num(correlations[:, number])
    known = np.isfinite(stds).all(axis=1) & (np.nan_to_num(stds) > 0).all(axis=1)
    known[known] = np.linalg.eigvalsh(matrix[known])[:, 0] > 0
    return np.where(known[:, None, None], matrix * stds[:, :, None] * stds[:, None, :], np.nan)


def warnings_on(
    source: str,
    stds: np.ndarray,
    covariances: np.ndarray,
    settings: ListSettings = ListSettings(),
) -> tuple[str, ...]:
    """Return what the user should know about the standard deviations of a list, in sentences.

    Parameters
    ----------
    source : str
        What messages call the list.
    stds : ndarray, shape (n, 3)
        Metres.
    covariances : ndarray, shape (n, 3, 3)
        Of `covariances_of`.
    settings : ListSettings
    """
    warnings = []
    lacking = int(np.isnan(covariances[:, 0, 0]).sum())
    if lacking:
        warnings.append(
            f"{lacking} of the {len(stds)} points in {source} count like points without standard deviations, "
            "because one of these is missing or not positive, or the correlations contradict each other."
        )
    known = stds[np.isfinite(stds)]
    median = float(np.median(known)) if len(known) else 0.0
    if median > settings.largest_median_std_m:
        warnings.append(
            f"The standard deviations in {source} are {median:.3g} m in the median; check their unit."
        )
    return tuple(warnings)
