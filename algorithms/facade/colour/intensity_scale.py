"""Make the intensity of scans comparable over a wall."""

from dataclasses import dataclass

import numpy as np

from ...geometry.robust import sigma_of_residuals, tukey_weights

CELL = 0.2
"""Side of the squares whose medians the trend is fitted to (m)."""

FEWEST_POINTS, FEWEST_CELLS = 5, 30
"""In a cell, and in a scan that has a trend of its own; below, a scan has one level."""

ROUNDS = 10
CUT = 4.685
"""Of Tukey's biweight, in standard deviations."""

NOISE_FACTOR = 2.0
"""The automatic threshold f in units of the scatter of the intensity within a cell."""

IQR_TO_SIGMA = 1.349


@dataclass(frozen=True)
class Relative:
    """Intensities relative to the surface that most of a plane consists of.

    Attributes
    ----------
    values : ndarray of float32, shape (n,)
        1 on the most frequent surface, whatever the scan, the distance and the angle.
    noise : float
        Scatter within a square of `CELL`.
    levels : ndarray of float64, shape (scans,)
        Median intensity of each scan, as the scanner has it.
    """

    values: np.ndarray
    noise: float
    levels: np.ndarray

    @property
    def automatic_threshold(self) -> float:
        """f, derived: what scatters by less is one surface."""
        return NOISE_FACTOR * self.noise


def make_relative(points: np.ndarray, intensity: np.ndarray, scan: np.ndarray) -> Relative:
    """Divide intensities by a smooth trend over the plane, each scan by its own.

    Intensity falls with the distance and the angle of incidence, and scanners differ; each is a
    smooth factor over a plane. A robust fit of degree 2 follows the surface that covers most of it.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    intensity : ndarray of float32, shape (n,)
    scan : ndarray of int32, shape (n,)
        Numbers from 0.
    """
    values = np.ones(len(points), np.float32)
    noises, levels = [], []
    for number in np.unique(scan):
        chosen = np.flatnonzero(scan == number)
        own = intensity[chosen].astype(np.float64)
        middles, medians, scatter = _cells(points[chosen], own)
        level = float(np.median(own))
        levels.append(level)
        if len(medians) < FEWEST_CELLS:
            trend = np.full(len(chosen), level)
        else:
            trend = _terms(points[chosen]) @ _robust_fit(_terms(middles), medians)
            noises.append(float(np.median(scatter)) / level if level > 0 else np.nan)
        # A trend that runs away where the plane has no cells must not change sign.
        values[chosen] = own / np.maximum(trend, 0.1 * level if level > 0 else 1.0)
    noise = float(np.nanmedian(noises)) if noises else float(np.std(values))
    return Relative(values, noise, np.array(levels))


def _cells(points: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the middles of the cells, and the median and the scatter of the values in each."""
    places = ((points - points.min(axis=0)) // CELL).astype(np.int64)
    keys = places[:, 1] * (places[:, 0].max() + 1) + places[:, 0]
    order = np.lexsort((values, keys))
    _, starts, counts = np.unique(keys[order], return_index=True, return_counts=True)
    starts, counts = starts[counts >= FEWEST_POINTS], counts[counts >= FEWEST_POINTS]
    ordered = values[order]
    low, middle, high = (ordered[starts + (share * (counts - 1)).astype(int)] for share in (0.25, 0.5, 0.75))
    return (places[order][starts] + 0.5) * CELL + points.min(axis=0), middle, (high - low) / IQR_TO_SIGMA


def _terms(points: np.ndarray) -> np.ndarray:
    u, v = points.T
    return np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], axis=1)


def _robust_fit(terms: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the coefficients of an iteratively reweighted fit with Tukey's biweight."""
    weights = np.abs(values - np.median(values)) <= 2 * np.median(np.abs(values - np.median(values)))
    weights = weights.astype(np.float64)
    for _ in range(ROUNDS):
        root = np.sqrt(weights)
        coefficients = np.linalg.lstsq(terms * root[:, None], values * root, rcond=None)[0]
        residuals = np.abs(values - terms @ coefficients)
        scale = max(sigma_of_residuals(residuals), 1e-9)
        weights = tukey_weights(residuals, scale, CUT)
    return coefficients
