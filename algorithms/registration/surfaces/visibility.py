"""Whether a scanner at a position could have seen surfaces."""

import numpy as np

from .settings import StationSettings

RAYS_AT_ONCE = 50
"""Bounds the memory: rays times cells."""


def hidden_share(
    station: np.ndarray,
    centres: np.ndarray,
    normals: np.ndarray,
    edges: np.ndarray,
    settings: StationSettings = StationSettings(),
) -> float:
    """Return the part of plane cells that other ones hide from a position, 0..1.

    Parameters
    ----------
    station : ndarray, shape (3,)
    centres, normals : ndarray, shape (n, 3)
        Of at least one cell; metres, and unit vectors of either sign.
    edges : ndarray, shape (n,)
        Of the cells, metres.
    settings : StationSettings
    """
    places = centres - station
    heights = np.einsum("ij,ij->i", normals, places)
    seen = np.unique(np.linspace(0, len(centres) - 1, settings.rays).round().astype(int))
    hidden = 0
    for start in range(0, len(seen), RAYS_AT_ONCE):
        rows = seen[start : start + RAYS_AT_ONCE]
        rays = places[rows]
        slopes = rays @ normals.T
        # Where a ray meets the plane of each cell, as a part of its length; never if they are parallel.
        parts = np.divide(heights, slopes, out=np.full(slopes.shape, np.inf), where=slopes != 0)
        # Cells of the same surface, whose planes nearly agree, do not hide each other.
        room = settings.clearance * (edges[rows, None] + edges)
        before = (parts > 0) & ((1 - parts) * np.linalg.norm(rays, axis=1)[:, None] > room)
        ray, cell = np.nonzero(before)
        off = parts[ray, cell][:, None] * rays[ray] - places[cell]
        hits = np.einsum("ij,ij->i", off, off) < (edges[cell] / 2) ** 2
        hidden += len(np.unique(ray[hits]))
    return hidden / len(seen)
