"""The plane on which most points lie: RANSAC, and its refit by total least squares."""

from typing import Optional

import numpy as np
from numba import njit

from ...geometry.robust import sigma_of_residuals

ITERATIONS = 400
"""Samples of three points; a third of them on one plane finds it in all but one of 10 000 runs."""

TRIES = 30
"""Points that are tried before a sample is given up."""

SHARP = 0.4
"""Part of ds within which points speak for a plane; so two planes a little more than ds apart stay two."""

NORMAL = 0.85
"""Least cosine between the normal of a plane and those of its points."""

ROUNDS = 30
STILL = 1e-7
"""A refit ends when the normal changes by less: 10 micrometres on a wall of 100 m."""

SIGMAS, LEAST_SIGMA = 3.0, 1e-4


def best_plane(
    points: np.ndarray, normals: np.ndarray, distance: float, seed: int
) -> Optional[tuple[np.ndarray, np.ndarray]]:
    """Return the normal and a point of the plane that most of the points lie on; None if there is none.

    It goes through three of the points, and is to be refitted.

    Parameters
    ----------
    points, normals : ndarray of float64, shape (n, 3)
    distance : float
        ds, the distance within which a point may be of the plane (m).
    seed : int
        Of the random samples.
    """
    if len(points) < 3:
        return None
    normal, place = np.zeros(3), np.zeros(3)
    if _search(points, normals, SHARP * distance, ITERATIONS, seed, normal, place) <= 0:
        return None
    return normal, place


def refit(
    points: np.ndarray,
    normal: np.ndarray,
    place: np.ndarray,
    reach: float,
    normals: Optional[np.ndarray] = None,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the plane of total least squares of the points near a plane, until it stays.

    Only points within three standard deviations count, at most within `reach` (m), and if their normals are
    known, only those that face as the plane does.
    """
    for _ in range(ROUNDS):
        distances = (points - place) @ normal
        near = np.abs(distances) <= reach
        if normals is not None:
            near &= np.abs(normals @ normal) >= NORMAL
        if near.sum() < 3:
            return normal, place
        sigma = max(sigma_of_residuals(distances[near]), LEAST_SIGMA)
        near &= np.abs(distances) <= SIGMAS * sigma
        place = points[near].mean(axis=0)
        turned = np.linalg.eigh(np.cov((points[near] - place).T))[1][:, 0]
        turned *= np.sign(turned @ normal) or 1.0
        change = float(np.abs(turned - normal).max())
        normal = turned
        if change < STILL:
            break
    return normal, place


@njit(cache=True, nogil=True)
def _search(points, normals, reach, iterations, seed, best_normal, best_place):
    """Write the best plane and return its score: each point counts the more the nearer it is."""
    np.random.seed(seed)
    best = 0.0
    normal, sample = np.empty(3), np.empty(3, np.int64)
    for _ in range(iterations):
        sample[0] = np.random.randint(len(points))
        if not _complete(points, normals, reach, sample):
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
        score = _score(points, normals, reach, normal, a)
        if score > best:
            best = score
            best_normal[:] = normal
            best_place[:] = a
    return best


@njit(cache=True, nogil=True)
def _complete(points, normals, reach, sample):
    """Find two more points that may lie on one plane with the first; tell whether there are."""
    first = sample[0]
    found = 1
    for _ in range(TRIES):
        other = np.random.randint(len(points))
        height, cosine, squared = 0.0, 0.0, 0.0
        for axis in range(3):
            offset = points[other, axis] - points[first, axis]
            height += offset * normals[first, axis]
            cosine += normals[other, axis] * normals[first, axis]
            squared += offset * offset
        # The normal of a single voxel is not sharp, and less so further away.
        if abs(cosine) < NORMAL or abs(height) > reach + 0.1 * np.sqrt(squared):
            continue
        sample[found] = other
        found += 1
        if found == 3:
            return True
    return False


@njit(cache=True, nogil=True)
def _score(points, normals, reach, normal, place):
    score = 0.0
    for point in range(len(points)):
        height, cosine = 0.0, 0.0
        for axis in range(3):
            height += (points[point, axis] - place[axis]) * normal[axis]
            cosine += normals[point, axis] * normal[axis]
        share = height / reach
        if abs(share) < 1 and abs(cosine) >= NORMAL:
            score += 1 - share * share
    return score
