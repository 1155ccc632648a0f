"""Fusion of regions of one intensity: a shadow changes the colour of a surface, but not its intensity."""

from typing import Optional

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ...geometry.triangulation import Mesh
from .region_growing import NONE


def fuse_by_intensity(labels: np.ndarray, relative: np.ndarray, threshold: float) -> np.ndarray:
    """Fuse regions whose mean intensities differ by less than f, wherever they lie.

    From the largest to the smallest, each region joins the surface that is nearest in intensity. A surface
    therefore cannot grow step by step into a different intensity.

    Parameters
    ----------
    labels : ndarray of int32, shape (n,)
        Regions from 1; `NONE` is left as it is.
    relative : ndarray of float32, shape (n,)
        See `intensity_scale.Relative`.
    threshold : float
        f, in the same unit.

    Returns
    -------
    ndarray of int32, shape (n,)
        Surfaces from 1.
    """
    counts = np.bincount(labels)
    means = np.bincount(labels, relative) / np.maximum(counts, 1)
    regions = np.flatnonzero(counts)
    regions = regions[regions != NONE]
    surfaces = np.zeros(len(counts), np.int32)
    sizes: list[int] = []
    levels: list[float] = []
    for region in regions[np.lexsort((regions, -counts[regions]))]:
        differences = np.abs(np.array(levels) - means[region])
        if len(levels) and differences.min() < threshold:
            own = int(np.argmin(differences))
            share = counts[region] / (sizes[own] + counts[region])
            levels[own] += share * (means[region] - levels[own])
            sizes[own] += counts[region]
        else:
            own = len(levels)
            levels.append(means[region])
            sizes.append(counts[region])
        surfaces[region] = own + 1
    return surfaces[labels]


def fuse_by_soft_borders(
    mesh: Mesh, linked: np.ndarray, labels: np.ndarray, rgb: np.ndarray, colour: float
) -> np.ndarray:
    """Fuse neighbouring regions whose colours hardly differ at their common border.

    Without intensity this removes gradients of brightness only. The sharp edge of a shadow remains a
    border.

    Parameters
    ----------
    mesh, linked
        As in `region_growing.grow_regions`.
    labels : ndarray of int32, shape (n,)
        Regions from 1; `NONE` is left as it is.
    rgb : ndarray of float32, shape (n, 3)
    colour : float
        tr, the largest difference across a border.
    """
    first, second = mesh.edges[linked].T
    across = (labels[first] != labels[second]) & (labels[first] != NONE) & (labels[second] != NONE)
    first, second = first[across], second[across]
    swapped = labels[first] > labels[second]
    first, second = np.where(swapped, second, first), np.where(swapped, first, second)
    size = int(labels.max(initial=0)) + 1
    pairs, numbers = np.unique(labels[first].astype(np.int64) * size + labels[second], return_inverse=True)
    steps = rgb[second] - rgb[first]
    counts = np.maximum(np.bincount(numbers, minlength=len(pairs)), 1)
    means = [np.bincount(numbers, steps[:, channel], len(pairs)) / counts for channel in range(3)]
    soft = pairs[np.linalg.norm(means, axis=0) < colour]
    links = coo_matrix((np.ones(len(soft)), (soft // size, soft % size)), shape=(size, size))
    _, groups = connected_components(links, directed=False)
    # Groups are numbered by their first region; NONE is a group of its own.
    return groups[labels].astype(np.int32)


def components(mesh: Mesh, linked: np.ndarray, labels: np.ndarray) -> np.ndarray:
    """Return the number, from 0, of the connected piece with one label that contains each point."""
    first, second = mesh.edges.T
    return mesh.pieces(linked & (labels[first] == labels[second]))


def largest_first(labels: np.ndarray, weights: Optional[np.ndarray] = None) -> np.ndarray:
    """Return regions renumbered by falling size, from 1; `NONE` is left as it is."""
    counts = np.bincount(labels, weights).astype(float)
    counts[NONE] = np.inf
    order = np.argsort(-counts, kind="stable")
    ranks = np.empty(len(counts), np.int32)
    ranks[order] = np.arange(len(counts))
    return ranks[labels]
