"""The plane on which most points lie: found by RANSAC, fitted by total least squares."""

from typing import Optional

import numpy as np

from ...geometry.robust import sigma_of_residuals
from ...kernels import kernel
from .settings import FitSettings


def best_plane(
    points: np.ndarray,
    normals: np.ndarray,
    distance: float,
    seed: int,
    settings: FitSettings = FitSettings(),
) -> Optional[tuple[np.ndarray, np.ndarray]]:
    """Return the normal and a point of the plane with most points; None if no sample makes a plane.

    The plane passes through three of the points. It is a first approximation for `refit`.

    Parameters
    ----------
    points, normals : ndarray of float64, shape (n, 3)
    distance : float
        ds, the largest distance of a point from its plane (m).
    seed : int
        Of the random samples.
    settings : FitSettings
    """
    if len(points) < 3:
        return None
    normal, anchor = np.zeros(3), np.zeros(3)
    limits = settings.vote * distance, settings.least_cosine, settings.slope
    if _search(points, normals, limits, settings.samples, settings.tries, seed, normal, anchor) <= 0:
        return None
    return normal, anchor


def refit(
    points: np.ndarray,
    normal: np.ndarray,
    anchor: np.ndarray,
    reach: float,
    normals: Optional[np.ndarray] = None,
    settings: FitSettings = FitSettings(),
) -> tuple[np.ndarray, np.ndarray]:
    """Return the normal and a point of the plane of total least squares near an approximate plane.

    Each round fits the points within three standard deviations of the plane before, until the normal no
    longer changes.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 3)
    normal, anchor : ndarray of float64, shape (3,)
        Of the approximate plane.
    reach : float
        Points further from the plane never count (m).
    normals : ndarray of float64, shape (n, 3), optional
        Of the points; points that face another way never count.
    settings : FitSettings
    """
    for _ in range(settings.rounds):
        distances = (points - anchor) @ normal
        near = np.abs(distances) <= reach
        if normals is not None:
            near &= np.abs(normals @ normal) >= settings.least_cosine
        if near.sum() < 3:
            return normal, anchor
        sigma = max(sigma_of_residuals(distances[near]), settings.least_sigma_m)
        near &= np.abs(distances) <= settings.sigmas * sigma
        anchor = points[near].mean(axis=0)
        refined = np.linalg.eigh(np.cov((points[near] - anchor).T))[1][:, 0]
        refined *= np.sign(refined @ normal) or 1.0
        change = float(np.abs(refined - normal).max())
        normal = refined
        if change < settings.settled:
            break
    return normal, anchor


@kernel
def _search(
    points: np.ndarray,
    normals: np.ndarray,
    limits: tuple[float, float, float],
    samples: int,
    tries: int,
    seed: int,
    best_normal: np.ndarray,
    best_anchor: np.ndarray,
) -> float:
    """Write the best plane and return its score: the nearer a point is to the plane, the more it counts."""
    reach, least_cosine, _ = limits
    np.random.seed(seed)
    best = 0.0
    normal, sample = np.empty(3), np.empty(3, np.int64)
    for _ in range(samples):
        sample[0] = np.random.randint(len(points))
        if not _complete(points, normals, limits, tries, sample):
            continue
        a, b, c = points[sample[0]], points[sample[1]], points[sample[2]]
        normal[0] = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
        normal[1] = (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2])
        normal[2] = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        length = np.sqrt(normal[0] ** 2 + normal[1] ** 2 + normal[2] ** 2)
        if length < reach * reach:
            continue
        for axis in range(3):
            normal[axis] /= length
        score = _score(points, normals, reach, least_cosine, normal, a, best)
        if score > best:
            best = score
            best_normal[:] = normal
            best_anchor[:] = a
    return best


@kernel
def _complete(
    points: np.ndarray,
    normals: np.ndarray,
    limits: tuple[float, float, float],
    tries: int,
    sample: np.ndarray,
) -> bool:
    """Add two more points that may lie on one plane with the first; return whether they were found."""
    reach, least_cosine, slope = limits
    first = sample[0]
    found = 1
    for _ in range(tries):
        other = np.random.randint(len(points))
        height, cosine, squared = 0.0, 0.0, 0.0
        for axis in range(3):
            offset = points[other, axis] - points[first, axis]
            height += offset * normals[first, axis]
            cosine += normals[other, axis] * normals[first, axis]
            squared += offset * offset
        # The normal of a single voxel is not sharp, which matters more further away.
        if abs(cosine) < least_cosine or abs(height) > reach + slope * np.sqrt(squared):
            continue
        sample[found] = other
        found += 1
        if found == 3:
            return True
    return False


@kernel
def _score(
    points: np.ndarray,
    normals: np.ndarray,
    reach: float,
    least_cosine: float,
    normal: np.ndarray,
    anchor: np.ndarray,
    best: float,
) -> float:
    """Return the sum of the weights of the points within reach of a plane; less if not above `best`."""
    score, size = 0.0, len(points)
    for point in range(size):
        # Each point adds at most 1; another 1 is more than rounding adds.
        if score + (size - point) + 1 < best:
            break
        height, cosine = 0.0, 0.0
        for axis in range(3):
            height += (points[point, axis] - anchor[axis]) * normal[axis]
        share = height / reach
        if abs(share) >= 1:
            continue
        for axis in range(3):
            cosine += normals[point, axis] * normal[axis]
        if abs(cosine) >= least_cosine:
            score += 1 - share * share
    return score
