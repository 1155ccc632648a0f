"""The plane of a target, fitted along the rays of the scanner."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.robust import MAD_TO_SIGMA, sigma_of_residuals
from ...geometry.weighted_fit import weighted_fit
from .settings import PlaneSettings


@dataclass(frozen=True)
class RayPlane:
    """A plane that rays from the scanner meet.

    Attributes
    ----------
    inverse : ndarray, shape (3,)
        The normal over the distance from the scanner: a ray d meets the plane at the range 1 / (inverse d).
    covariance : ndarray, shape (3, 3)
        Of `inverse`.
    step : float
        How much farther than white the scanner measures black, metres.
    sigmas : tuple of 2 float
        Standard deviations of the ranges of black and of white, metres.
    kept : ndarray of bool, shape (n,)
        The points that lie on it.
    """

    inverse: np.ndarray
    covariance: np.ndarray
    step: float
    sigmas: tuple[float, float]
    kept: np.ndarray

    @property
    def normal(self) -> np.ndarray:
        """Unit vector, away from the scanner."""
        return self.inverse / np.linalg.norm(self.inverse)

    def meets(self, rays: np.ndarray) -> np.ndarray:
        """Return where rays of length 1, shape (..., 3), meet the plane."""
        return rays / (rays @ self.inverse)[..., None]

    def incidence_deg(self, ray: np.ndarray) -> float:
        """Return the angle between a ray of any length and the normal."""
        return float(np.degrees(np.arccos(min(self.normal @ ray / np.linalg.norm(ray), 1.0))))

    def holds(self, rays: np.ndarray, ranges: np.ndarray, sigmas: float) -> np.ndarray:
        """Return whether points lie on the plane, as far as ranges on black and white scatter."""
        away = ranges - 1.0 / np.maximum(rays @ self.inverse, 1e-9)
        limit = sigmas * max(self.sigmas)
        return np.asarray((away > min(self.step, 0.0) - limit) & (away < max(self.step, 0.0) + limit))

    def range_std(self, ray: np.ndarray) -> float:
        """Return the standard deviation of the range at which a ray meets the plane, metres."""
        distance = 1.0 / float(ray @ self.inverse)
        return float(distance**2 * np.sqrt(ray @ self.covariance @ ray))


def fit_plane(
    rays: np.ndarray, ranges: np.ndarray, dark: np.ndarray, settings: PlaneSettings
) -> Optional[RayPlane]:
    """Fit a plane to ranges that depend on the colour.

    Along a ray d the inverse range is q d, linear in the plane q. Black returns little light: its
    ranges scatter more, and may be off by a constant, which is estimated. White says where the plane is.

    Parameters
    ----------
    rays : ndarray, shape (n, 3)
        Directions, of length 1.
    ranges : ndarray, shape (n,)
        Metres.
    dark : ndarray of bool, shape (n,)
        Whether a point is on black.
    settings : PlaneSettings

    Returns
    -------
    RayPlane or None
        None if fewer than six points or no white ones lie on a plane.
    """
    if np.count_nonzero(~dark) < 4:
        return None
    kept = _consensus(rays, ranges, ~dark, settings)
    if kept is None:
        return None
    design = np.column_stack([rays, np.where(dark, -1.0, 0.0) / ranges**2])
    unknowns, weights = 3, (kept & ~dark) * ranges**4
    for _ in range(settings.rounds):
        solution, inverse = weighted_fit(design[:, :unknowns], 1.0 / ranges, weights)
        residuals = ranges - 1.0 / (rays @ solution[:3])
        step = float(np.median(residuals[dark])) if np.any(dark) else 0.0
        residuals[dark] -= step
        sigmas = [_scatter(residuals[colour], settings.least_sigma_m) for colour in (dark, ~dark)]
        each = np.where(dark, *sigmas)
        kept = np.abs(residuals) < settings.sigmas * each
        unknowns = 4 if np.count_nonzero(kept & dark) >= 2 else 3
        weights = kept * ranges**4 / each**2
    if np.count_nonzero(kept & ~dark) < 4 or sigmas[1] > settings.most_sigma_m:
        return None
    solution, inverse = weighted_fit(design[:, :unknowns], 1.0 / ranges, weights)
    return RayPlane(solution[:3], inverse[:3, :3], step, (sigmas[0], sigmas[1]), kept)


def _scatter(residuals: np.ndarray, least: float) -> float:
    """Return the robust standard deviation of residuals."""
    return max(sigma_of_residuals(residuals), least) if len(residuals) else least


def _consensus(
    rays: np.ndarray, ranges: np.ndarray, usable: np.ndarray, settings: PlaneSettings
) -> Optional[np.ndarray]:
    """Return the points near the plane through three of the usable ones that leaves the least median."""
    rows = np.flatnonzero(usable)
    # The same triples for the same points: results do not depend on chance.
    triples = rows[np.random.default_rng(len(rows)).integers(0, len(rows), (settings.trials, 3))]
    apart = np.abs(np.linalg.det(rays[triples])) > 0
    if not np.any(apart):
        return None
    planes = np.linalg.solve(rays[triples[apart]], 1.0 / ranges[triples[apart]][..., None])[..., 0]
    sample = rows[:: max(1, len(rows) // settings.sample)]
    away = np.abs(ranges[sample] - 1.0 / np.maximum(planes @ rays[sample].T, 1e-9))
    medians = np.median(away, axis=1)
    best, median = planes[np.argmin(medians)], float(medians.min())
    limit = settings.sigmas * max(MAD_TO_SIGMA * median, settings.least_sigma_m)
    return np.asarray(np.abs(ranges - 1.0 / np.maximum(rays @ best, 1e-9)) < limit)
