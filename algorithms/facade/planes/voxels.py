"""Points thinned to an even grid, so that a plane counts by its area and not by its number of points."""

from dataclasses import dataclass

import numpy as np
import pandas as pd
from scipy.spatial import cKDTree

from .settings import VoxelSettings


@dataclass(frozen=True)
class Voxels:
    """Cubes that hold points.

    Attributes
    ----------
    size : float
        Side of a cube (m).
    centres : ndarray of float64, shape (k, 3)
        Means of their points, relative to the origin of the points.
    normals : ndarray of float64, shape (k, 3)
        Of length 1, of either sign.
    of_point : ndarray of int64, shape (n,)
        The cube of each point.
    """

    size: float
    centres: np.ndarray
    normals: np.ndarray
    of_point: np.ndarray


def make_voxels(xyz: np.ndarray, size: float, settings: VoxelSettings = VoxelSettings()) -> Voxels:
    """Return the cubes of points.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
    size : float
        Least side of a cube (m).
    settings : VoxelSettings
    """
    corner = xyz.min(axis=0)
    while True:
        x, y, z = (((xyz[:, axis] - corner[axis]) / size).astype(np.int64) for axis in range(3))
        codes, keys = pd.factorize((x * (y.max() + 1) + y) * (z.max() + 1) + z)
        if len(keys) <= settings.most_cubes:
            break
        # The cubes lie on surfaces.
        size *= 1.1 * np.sqrt(len(keys) / settings.most_cubes)
    # Numbered by position, so that the order of the points does not matter.
    of_point = np.argsort(np.argsort(keys))[codes]
    counts = np.bincount(of_point)
    sums = [np.bincount(of_point, xyz[:, axis]) for axis in range(3)]
    centres = np.stack(sums, axis=1) / counts[:, None]
    return Voxels(float(size), centres, _normals(centres, settings.neighbours), of_point)


def _normals(centres: np.ndarray, neighbours: int) -> np.ndarray:
    _, near = cKDTree(centres).query(centres, k=min(neighbours, len(centres)), workers=-1)
    around = centres[near.reshape(len(centres), -1)]
    around = around - around.mean(axis=1, keepdims=True)
    moments = np.einsum("nki,nkj->nij", around, around)
    return np.linalg.eigh(moments)[1][:, :, 0]


def square_means(points: np.ndarray, size: float) -> np.ndarray:
    """Return the means of the points, shape (n, 2), in each square of `size` (m)."""
    cells = np.floor(points / size).astype(np.int64)
    cells -= cells.min(axis=0)
    _, of_point, counts = np.unique(
        cells[:, 0] * (cells[:, 1].max() + 1) + cells[:, 1], return_inverse=True, return_counts=True
    )
    sums = [np.bincount(of_point.reshape(-1), points[:, axis]) for axis in range(2)]
    return np.stack(sums, axis=1) / counts[:, None]
