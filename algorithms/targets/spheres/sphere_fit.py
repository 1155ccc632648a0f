"""A sphere fitted along the rays of the scanner."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.robust import sigma_of_residuals, tukey_weights
from ...geometry.weighted_fit import weighted_fit
from .settings import FitSettings


@dataclass(frozen=True)
class SphereFit:
    """A sphere.

    Attributes
    ----------
    centre : ndarray, shape (3,)
        Relative to the scanner, metres.
    radius : float
        Metres.
    covariance : ndarray, shape (4, 4)
        Of centre and radius; that of a given radius is 0.
    sigma : float
        Standard deviation of a range, metres.
    used : ndarray of bool, shape (n,)
        The points that have weight.
    """

    centre: np.ndarray
    radius: float
    covariance: np.ndarray
    sigma: float
    used: np.ndarray

    @property
    def radius_std(self) -> float:
        """Standard deviation of the radius, metres."""
        return float(np.sqrt(self.covariance[3, 3]))


def fit_sphere(
    rays: np.ndarray,
    ranges: np.ndarray,
    centre: np.ndarray,
    radius: float,
    settings: FitSettings,
    free: bool = True,
) -> Optional[SphereFit]:
    """Fit a sphere to ranges by robust least squares.

    What is minimised is the residual along the ray, where the scanner errs. The far rim is left out: it has
    mixed pixels, and small errors of direction are large ones of range.

    Parameters
    ----------
    rays : ndarray, shape (n, 3)
        Directions, of length 1.
    ranges : ndarray, shape (n,)
        Metres.
    centre : ndarray, shape (3,)
        Near the solution.
    radius : float
        Metres.
    settings : FitSettings
    free : bool
        Whether the radius is estimated.

    Returns
    -------
    SphereFit or None
        None if fewer than eight points remain, or if the fit leaves its neighbourhood.
    """
    unknowns = 4 if free else 3
    start = centre
    sigma = 0.02 * radius + settings.least_sigma_m
    first = radius
    for number in range(settings.rounds):
        residuals, cosine, normals = _residuals(rays, ranges, centre, radius)
        seen = cosine > np.cos(np.radians(settings.most_incidence_deg))
        # Wide at first, so that a start beside the sphere finds all of it.
        near = seen & (np.abs(residuals) < (radius if number < 3 else settings.outlier * sigma))
        if np.count_nonzero(near) < 8:
            return None
        sigma = max(sigma_of_residuals(residuals[near]), settings.least_sigma_m)
        weights = np.where(seen, tukey_weights(residuals, sigma, settings.outlier), 0.0)
        design = np.column_stack([normals, np.ones(len(rays))])[:, :unknowns] / -cosine[:, None]
        change, inverse = weighted_fit(design, residuals, weights)
        change *= min(1.0, 0.5 * radius / max(float(np.linalg.norm(change)), 1e-12))
        centre = centre + change[:3]
        radius += float(change[3]) if free else 0.0
        if not 0.5 * first < radius < 2.0 * first or np.linalg.norm(centre - start) > 2.0 * first:
            return None
        if np.linalg.norm(change[:3]) < settings.settled_m and number > 3:
            break
    used = weights > 0
    freedom = max(np.count_nonzero(used) - unknowns, 3)
    # The weights shorten the residuals of normal noise by little, which the median does not.
    variance = sigma**2 * freedom / (freedom - 2)
    covariance = np.zeros((4, 4))
    covariance[:unknowns, :unknowns] = inverse * variance
    return SphereFit(centre, radius, covariance, sigma, used)


def _residuals(
    rays: np.ndarray, ranges: np.ndarray, centre: np.ndarray, radius: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return what ranges differ from a sphere, the cosines of incidence, and the outward normals.

    For rays that miss the sphere the cosine is tiny.
    """
    along = rays @ centre
    inside = along**2 - centre @ centre + radius**2
    half = np.sqrt(np.maximum(inside, 1e-12))
    met = along - half
    normals = (rays * met[:, None] - centre) / radius
    return ranges - met, half / radius, normals
