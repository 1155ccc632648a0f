"""The circle of a round tower in plan."""

from typing import Optional

import numpy as np

from ...geometry.curves import Arc
from ...geometry.robust import EFFICIENT_CUT, sigma_of_residuals, tukey_weights
from ..planes.voxels import make_voxels
from .curves import Circle
from .settings import CircleSettings


def find_circle(xyz: np.ndarray, settings: CircleSettings = CircleSettings()) -> Optional[Circle]:
    """Return the circle on which most of the upright surfaces lie; None if there is none.

    The normals of a round wall meet in its axis: every upright cube votes for the centres that a circle of
    each radius would have. The best circle is fitted to the cubes near it.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
    settings : CircleSettings
    """
    voxels = make_voxels(xyz, settings.cube_m)
    steep = np.abs(voxels.normals[:, 2]) < settings.steep
    middles, normals = voxels.centres[steep, :2], voxels.normals[steep, :2]
    if len(middles) < 1 / settings.share:
        return None
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    centre, radius = _voted(middles, normals, settings)
    arc = Arc(centre, radius, 1, 0.0)
    for _ in range(settings.rounds):
        near = arc.distances(middles) <= settings.reach_m
        if np.count_nonzero(near) < 3:
            return None
        away = arc.offset(middles[near])
        sigma = max(sigma_of_residuals(away), settings.least_sigma_m)
        arc = arc.fitted(middles[near], tukey_weights(away, sigma, EFFICIENT_CUT))
    centre, radius = arc.centre, float(arc.radius)
    rays = middles - centre
    radial = np.abs(np.sum(rays * normals, axis=1)) > settings.radial * np.linalg.norm(rays, axis=1)
    on = (np.abs(np.linalg.norm(rays, axis=1) - radius) <= settings.on_m) & radial
    if on.mean() < settings.share or not settings.least_radius_m < radius < settings.largest_radius_m:
        return None
    seen, middle = _seen(rays[on], settings.bin_deg)
    return Circle(centre, radius, middle) if seen >= settings.least_deg else None


def _voted(middles: np.ndarray, normals: np.ndarray, settings: CircleSettings) -> tuple[np.ndarray, float]:
    """Return the centre and the radius that most cubes vote for."""
    step, best = settings.step_m, (-1, np.zeros(2), 0.0)
    low = middles.min(axis=0) - 2 * settings.largest_radius_m
    for radius in np.arange(settings.least_radius_m, settings.largest_radius_m, step):
        centres = np.concatenate([middles + radius * normals, middles - radius * normals])
        # Normals of single cubes are not sharp: the axis is hit the less well, the farther it is.
        cell = max(step, settings.coarse * radius)
        cells = np.floor((centres - low) / cell).astype(np.int64)
        keys, counts = np.unique(cells[:, 0] * 1_000_000 + cells[:, 1], return_counts=True)
        most = int(np.argmax(counts))
        if counts[most] > best[0]:
            place = np.array([keys[most] // 1_000_000, keys[most] % 1_000_000])
            best = int(counts[most]), low + (place + 0.5) * cell, float(radius)
    return best[1], best[2]


def _seen(rays: np.ndarray, size: float) -> tuple[float, float]:
    """Return how much of a circle is seen, and the azimuth of the middle of that part (degrees)."""
    count = round(360 / size)
    azimuths = np.degrees(np.arctan2(rays[:, 0], rays[:, 1])) % 360
    bins = np.unique(np.floor(azimuths / size).astype(np.int64) % count)
    gaps = np.diff(np.append(bins, bins[0] + count))
    widest = int(np.argmax(gaps))
    start, stop = bins[(widest + 1) % len(bins)], bins[widest]
    middle = start + 0.5 * ((stop - start) % count) + 0.5
    return float(len(bins) * size), float(middle * size % 360)
