"""The surface of a wall: a plane with lean and bulge, fitted to equal areas."""

from dataclasses import dataclass

import numpy as np

from ...geometry.robust import EFFICIENT_CUT, sigma_about_median, sigma_of_residuals, tukey_weights
from .settings import SurfaceSettings


@dataclass(frozen=True)
class WallSurface:
    """A quadratic surface w(u, v).

    Attributes
    ----------
    coefficients : ndarray of float64, shape (6,)
        Of 1, u, v, u u, u v, v v, from the middle.
    middle : ndarray of float64, shape (2,)
    bounds : ndarray of float64, shape (2, 2)
        Least and largest u and v; beyond them the surface is that of its border.
    tolerance : float
        Points within this distance of the surface are on it (m).
    roughness : float
        Most points of the wall are within this distance of it (m).
    """

    coefficients: np.ndarray
    middle: np.ndarray
    bounds: np.ndarray
    tolerance: float
    roughness: float

    def above(self, uvw: np.ndarray) -> np.ndarray:
        """Return how far points, shape (n, 3), are in front of the surface (m)."""
        return uvw[:, 2] - self.at(uvw[:, :2])

    def at(self, uv: np.ndarray) -> np.ndarray:
        """Return w of the surface at points, shape (n, 2)."""
        return _terms(np.clip(uv, *self.bounds) - self.middle) @ self.coefficients


def fit_surface(uvw: np.ndarray, most: float, settings: SurfaceSettings = SurfaceSettings()) -> WallSurface:
    """Return the surface of the points of a wall.

    Parameters
    ----------
    uvw : ndarray of float64, shape (n, 3)
    most : float
        Largest tolerance (m): ds of the paper.
    settings : SurfaceSettings
    """
    cells = np.floor(uvw[:, :2] / settings.cell_m).astype(np.int64)
    cells -= cells.min(axis=0)
    keys = cells[:, 0] * (cells[:, 1].max() + 1) + cells[:, 1]
    order = np.lexsort((uvw[:, 2], keys))
    starts = np.flatnonzero(np.diff(keys[order], prepend=-1))
    counts = np.diff(np.append(starts, len(order)))
    full = counts >= settings.fewest_points
    starts, counts = (starts[full], counts[full]) if full.any() else (starts, counts)
    middles = uvw[order[starts + counts // 2]]
    centre, bounds = (
        middles[:, :2].mean(axis=0),
        np.stack([middles[:, :2].min(axis=0), middles[:, :2].max(axis=0)]),
    )
    terms = _terms(middles[:, :2] - centre)
    used = 6 if len(middles) >= settings.fewest_cells else 3 if len(middles) >= 3 else 1
    coefficients = np.zeros(6)
    weights = np.ones(len(middles))
    for _ in range(settings.rounds):
        root = np.sqrt(weights)
        coefficients[:used] = np.linalg.lstsq(
            terms[:, :used] * root[:, None], middles[:, 2] * root, rcond=None
        )[0]
        residuals = middles[:, 2] - terms @ coefficients
        sigma = max(sigma_of_residuals(residuals), 1e-4)
        weights = np.maximum(tukey_weights(residuals, sigma, EFFICIENT_CUT), 1e-6)
    surface = WallSurface(coefficients, centre, bounds, most, most)
    scatter = float(sigma_about_median(surface.above(uvw)))
    tolerance = float(np.clip(settings.sigmas * scatter, min(settings.least_m, most), most))
    return WallSurface(coefficients, centre, bounds, tolerance, min(settings.sigmas * scatter, tolerance))


def _terms(uv: np.ndarray) -> np.ndarray:
    u, v = uv.T
    return np.stack([np.ones(len(uv)), u, v, u * u, u * v, v * v], axis=1)
