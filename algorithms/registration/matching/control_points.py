"""The control points as matching needs them: distances, and how far they may differ."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from ..adjustment.control_network import ControlNetwork
from ..settings import Settings


@dataclass(frozen=True)
class ControlPoints:
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
    position_factor : float
        How much wider the limit of a position is than that of a distance.
    scale_error : float
        Relative scale error that is allowed for.
    """

    points: np.ndarray
    variances: np.ndarray
    sigma: float
    factor: float
    position_factor: float
    scale_error: float = 0.0

    @classmethod
    def of_network(
        cls, network: ControlNetwork, settings: Settings, scale_error: float = 0.0
    ) -> "ControlPoints":
        """Return the points of a network, with the limits that the settings ask for."""
        return cls(
            network.points,
            network.distance_variances(),
            settings.sigma,
            settings.distance_factor,
            settings.matches.tolerances.position_factor,
            scale_error,
        )

    @cached_property
    def tree(self) -> cKDTree:
        """The points, for queries of the nearest."""
        return cKDTree(self.points)

    @cached_property
    def distances(self) -> np.ndarray:
        """Between all points, shape (N, N)."""
        return cdist(self.points, self.points)

    @cached_property
    def limits(self) -> np.ndarray:
        """Largest differences of distances that match, eps_t of the paper; shape (N, N)."""
        return self.factor * np.sqrt(2 * self.sigma**2 + self.variances)

    def reach(self, leverage: np.ndarray, partners: np.ndarray) -> np.ndarray:
        """Return the largest distance between a control point and its transformed target.

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
        # The pose absorbs the error that points appended from one scan share; only their relative
        # uncertainty counts.
        spread = self.variances[partners].max(axis=(-2, -1)) if self.variances.any() else 0.0
        variance = self.sigma**2 + np.asarray(spread) / 2
        return self.position_factor * self.factor * np.sqrt(variance[..., None] * (1.0 + leverage))
