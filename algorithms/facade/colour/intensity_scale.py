"""Intensities that are comparable over a wall and between scans."""

from dataclasses import dataclass

import numpy as np

from ...geometry.robust import EFFICIENT_CUT, sigma_of_residuals, tukey_weights
from .settings import IntensitySettings

IQR_TO_SIGMA = 1.349
"""Interquartile range of a normal deviate, in standard deviations."""


@dataclass(frozen=True)
class Relative:
    """Intensities relative to the most frequent surface of a plane.

    Attributes
    ----------
    values : ndarray of float32, shape (n,)
        1 on the most frequent surface, for every scan, distance and angle of incidence.
    threshold : float
        f, derived: what scatters by less is one surface.
    levels : ndarray of float64, shape (scans,)
        Median intensity of each scan, as the scanner has it.
    """

    values: np.ndarray
    threshold: float
    levels: np.ndarray


def make_relative(
    points: np.ndarray,
    intensity: np.ndarray,
    scan: np.ndarray,
    settings: IntensitySettings = IntensitySettings(),
) -> Relative:
    """Return the intensities of each scan divided by their smooth trend over the plane.

    Intensity falls with the distance and with the angle of incidence, and scanners differ. Each of these
    is a smooth factor over a plane. A robust fit of degree 2 follows the surface that covers most of it.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
    intensity : ndarray of float32, shape (n,)
    scan : ndarray of int32, shape (n,)
        Numbers from 0.
    settings : IntensitySettings
    """
    values = np.ones(len(points), np.float32)
    noises, levels = [], []
    for number in np.unique(scan):
        chosen = np.flatnonzero(scan == number)
        own = intensity[chosen].astype(np.float64)
        middles, medians, scatter = _cells(points[chosen], own, settings)
        level = float(np.median(own))
        levels.append(level)
        if len(medians) < settings.fewest_cells:
            trend = np.full(len(chosen), level)
        else:
            trend = _terms(points[chosen]) @ _robust_fit(_terms(middles), medians, settings.rounds)
            noises.append(float(np.median(scatter)) / level if level > 0 else np.nan)
        values[chosen] = own / np.maximum(trend, settings.least_trend * level if level > 0 else 1.0)
    noise = float(np.nanmedian(noises)) if noises else float(np.std(values))
    return Relative(values, settings.noise_factor * noise, np.array(levels))


def _cells(
    points: np.ndarray, values: np.ndarray, settings: IntensitySettings
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the middles of the cells, and the median and the scatter of the values in each."""
    cells = ((points - points.min(axis=0)) // settings.cell_m).astype(np.int64)
    keys = cells[:, 1] * (cells[:, 0].max() + 1) + cells[:, 0]
    order = np.lexsort((values, keys))
    _, starts, counts = np.unique(keys[order], return_index=True, return_counts=True)
    enough = counts >= settings.fewest_points
    starts, counts = starts[enough], counts[enough]
    ordered = values[order]
    low, middle, high = (ordered[starts + (share * (counts - 1)).astype(int)] for share in (0.25, 0.5, 0.75))
    middles = (cells[order][starts] + 0.5) * settings.cell_m + points.min(axis=0)
    return middles, middle, (high - low) / IQR_TO_SIGMA


def _terms(points: np.ndarray) -> np.ndarray:
    u, v = points.T
    return np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], axis=1)


def _robust_fit(terms: np.ndarray, values: np.ndarray, rounds: int) -> np.ndarray:
    """Return the coefficients of an iteratively reweighted fit with Tukey's biweight."""
    weights = np.abs(values - np.median(values)) <= 2 * np.median(np.abs(values - np.median(values)))
    weights = weights.astype(np.float64)
    for _ in range(rounds):
        root = np.sqrt(weights)
        coefficients = np.linalg.lstsq(terms * root[:, None], values * root, rcond=None)[0]
        residuals = np.abs(values - terms @ coefficients)
        scale = max(sigma_of_residuals(residuals), 1e-9)
        weights = tukey_weights(residuals, scale, EFFICIENT_CUT)
    return coefficients
