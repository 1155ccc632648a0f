"""Removal of noise from a region: points among large triangles of its Delaunay triangulation."""

import numpy as np

from ...geometry.triangulation import Mesh, triangulate
from ...progress import Progress


def remove_noise(
    mesh: Mesh, factor: float, count: int, rounds: int, rings: int = 3, progress: Progress = Progress()
) -> np.ndarray:
    """Return which points of a region are kept.

    A point is noise if it belongs to more than `count` (eta) triangles that are larger than `factor` times
    the mean (delta). Each round triangulates the points that remain around those removed before. The
    rounds end when nothing is removed.

    Parameters
    ----------
    mesh : Mesh
        Of the n points of the region.
    factor : float
        delta over the mean area m of the triangles; 3 in the paper.
    count : int
        eta; 5 in the paper.
    rounds : int
        At most; about 10 in the paper.
    rings : int
        Rings of neighbours around removed points that are triangulated again.
    progress : Progress
        Asked before each round whether to go on.

    Returns
    -------
    ndarray of bool, shape (n,)
    """
    points = mesh.points
    kept = np.ones(len(points), bool)
    judged, around = np.arange(len(points)), np.arange(len(points))
    largest = factor * float(mesh.areas.mean()) if len(mesh.triangles) else 0.0
    for _ in range(rounds):
        progress.check()
        large = mesh.triangles[mesh.areas > largest]
        attached = np.bincount(large.ravel(), minlength=len(around)) > count
        removed = np.intersect1d(around[attached], judged, assume_unique=True)
        if not len(removed):
            break
        kept[removed] = False
        near = _rings(mesh, np.isin(around, removed, assume_unique=True), rings)
        left = kept[around]
        judged, around = around[near[0] & left], around[near[1] & left]
        mesh = triangulate(points[around])
    return kept


def _rings(mesh: Mesh, chosen: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return which points are neighbours of the chosen ones, and which are within `count` rings."""
    rings = [chosen]
    for _ in range(count):
        touched = rings[-1][mesh.triangles].any(axis=1)
        wider = rings[-1].copy()
        wider[mesh.triangles[touched].ravel()] = True
        rings.append(wider)
    return rings[1], rings[-1]
