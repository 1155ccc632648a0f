"""The angle between neighbouring points of a scan."""

import numpy as np
from scipy.spatial import cKDTree

from .settings import RangeImageSettings


def angular_step(azimuth: np.ndarray, elevation: np.ndarray, settings: RangeImageSettings) -> float:
    """Return the angular step of a scan: the median distance of neighbours in azimuth and elevation.

    Panoramic scanners have the same steps of both angles everywhere, so the angles are taken as plane
    coordinates. Where the two steps differ, the result lies between them.

    Parameters
    ----------
    azimuth, elevation : ndarray, shape (n,)
        Radians; azimuths count from the end of the scan, so that they do not jump within it.
    settings : RangeImageSettings

    Returns
    -------
    float
        Radians; 0 if there are too few points to say.
    """
    if len(azimuth) <= settings.neighbours:
        return 0.0
    area = _covered_area(azimuth, elevation)
    reach = settings.window_steps * np.sqrt(area / len(azimuth))
    # Equal spacing in the order of the points does not depend on a random seed.
    seeds = np.linspace(0, len(azimuth) - 1, settings.step_windows).astype(np.int64)
    steps = [_local_step(azimuth, elevation, seed, reach, settings.neighbours) for seed in seeds]
    known = [step for step in steps if step > 0]
    return float(np.median(known)) if known else 0.0


def _covered_area(azimuth: np.ndarray, elevation: np.ndarray) -> float:
    """Return the solid angle that the points cover, in square radians of azimuth and elevation."""
    cells, *edges = np.histogram2d(azimuth, elevation, bins=(72, 36))
    sides = [edge[1] - edge[0] for edge in edges]
    return float(np.count_nonzero(cells) * sides[0] * sides[1])


def _local_step(azimuth: np.ndarray, elevation: np.ndarray, seed: int, reach: float, count: int) -> float:
    for _ in range(4):
        near = np.abs(azimuth - azimuth[seed]) < reach
        near &= np.abs(elevation - elevation[seed]) < reach
        places = np.column_stack([azimuth[near], elevation[near]]).astype(np.float64)
        if len(places) > 4 * count:
            break
        reach *= 2.0
    else:
        return 0.0
    tree = cKDTree(places)
    middle = tree.query([[azimuth[seed], elevation[seed]]], min(len(places), 4 * count))[1][0]
    farthest = tree.query(places[middle], count + 1)[0][:, -1]
    return float(np.median(farthest) / np.sqrt(2.0))
