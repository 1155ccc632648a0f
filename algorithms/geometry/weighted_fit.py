"""Weighted linear least squares, with the inverse of the normal matrix."""

import numpy as np


def weighted_fit(
    design: np.ndarray, observed: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the solution x of least v'Pv, v = A x - l, and the inverse of A'PA.

    The inverse is the covariance of x where the weights are inverse variances. Of unknowns that the
    observations do not determine, the smallest are returned.

    Parameters
    ----------
    design : ndarray, shape (n, u)
        A.
    observed : ndarray, shape (n,)
        l.
    weights : ndarray, shape (n,)
        The diagonal of P; 0 leaves an observation out.
    """
    weighted = design * weights[:, None]
    inverse = np.linalg.pinv(weighted.T @ design)
    return inverse @ (weighted.T @ observed), inverse
