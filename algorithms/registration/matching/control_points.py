"""The control points as the search for matches knows them."""

from dataclasses import dataclass
from functools import cached_property
from typing import Optional

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

FACTOR = 3.5
"""Distances match if they differ by less than this many standard deviations of their difference.

The paper takes 2 standard deviations of a coordinate, which is 1.4 of a difference: it would lose one true
pair in six."""

GATE = 1.45
"""How much wider the limit of a place, with its three coordinates, is than that of a distance.

So far beyond 3.5 standard deviations lies one true target in 100 000 (chi-square, 3 degrees of freedom)."""

DRIFT = 600e-6
"""Largest scale error, for models that have a scale near 1: more than the usual projections have."""


@dataclass(frozen=True)
class Site:
    """Control points that a scan is matched with.

    Attributes
    ----------
    points : ndarray, shape (N, 3)
        Near the origin.
    variances : ndarray, shape (N, N)
        Of the distances between them, square metres; zero between points that are held fixed.
    sigma : float
        Standard deviation of a target's coordinate, metres.
    factor : float
        Distances match within this many standard deviations.
    drift : float
        Relative scale error that is allowed for.
    """

    points: np.ndarray
    variances: np.ndarray
    sigma: float
    factor: float
    drift: float = 0.0

    @cached_property
    def tree(self) -> cKDTree:
        """The points, to be asked for the nearest."""
        return cKDTree(self.points)

    @cached_property
    def distances(self) -> np.ndarray:
        """Between all points, shape (N, N)."""
        return cdist(self.points, self.points)

    @cached_property
    def limits(self) -> np.ndarray:
        """How far distances of targets may differ from those of points, eps_t of the paper; shape (N, N)."""
        return self.factor * np.sqrt(2 * self.sigma**2 + self.variances)

    def reach(self, leverage: np.ndarray, partners: np.ndarray) -> np.ndarray:
        """Return how far from a control point its target may come to lie.

        Parameters
        ----------
        leverage : ndarray, shape (..., n)
            Variance of a transformed target over that of a coordinate.
        partners : ndarray of int, shape (..., s)
            The points that the pose was found from.

        Returns
        -------
        ndarray, shape (..., n)
        """
        # Points appended from one scan share its error, which the pose takes up: what counts is how
        # uncertain they are to each other.
        spread = self.variances[partners].max(axis=(-2, -1)) if self.variances.any() else 0.0
        variance = self.sigma**2 + np.asarray(spread) / 2
        return GATE * self.factor * np.sqrt(variance[..., None] * (1.0 + leverage))


def factor_of(tolerance: Optional[float], sigma: float, control_sigma: float) -> float:
    """Return how many standard deviations of a difference of distances the tolerance is."""
    if tolerance is None:
        return FACTOR
    return tolerance / float(np.sqrt(2 * sigma**2 + 2 * control_sigma**2))
