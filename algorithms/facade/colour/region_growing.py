"""Regions of one colour, grown from seeds over neighbouring points."""

import numpy as np
from numba import njit

from ...geometry.triangulation import Mesh
from .appearance import Appearance
from .seeds import FEWEST, Seeds, distance_in_colour, gather, mean_and_variance, sort_into_cells

NONE = 0
"""The label of points in no region."""

FREE_SHARE = 0.5
"""Of the points around a seed that must be in no region yet."""


def grow_regions(
    mesh: Mesh, linked: np.ndarray, looks: Appearance, seeds: Seeds, variance: float, colour: float
) -> np.ndarray:
    """Grow a region from every seed that is left, over neighbours of a colour like its own.

    The points at the border of a region are compared with the mean of the whole region, which is
    renewed as it grows, never with their neighbours: colour cannot chain through a gradient. Where there
    is intensity, it must be like that of the region too: dark plaster in the sun is not light wood in the
    shade.

    Parameters
    ----------
    mesh : Mesh
        Of n points.
    linked : ndarray of bool, shape (k,)
        The edges of the mesh that join neighbours.
    looks : Appearance
        Of the n points.
    seeds : Seeds
        In the order in which they are tried.
    variance : float
        Vr, of the seed surface.
    colour : float
        tr2, the largest distance to the mean of the region (Simco2).

    Returns
    -------
    ndarray of int32, shape (n,)
        Numbers of the regions from 1; `NONE` where no region grew.
    """
    labels = np.zeros(len(looks.rgb), np.int32)
    if not len(seeds.rows):
        return labels
    lattice = sort_into_cells(mesh.points, seeds.radii.max() / 4)
    _grow_all(
        mesh.points, looks.rgb, *looks.gated, *mesh.neighbours(linked),
        seeds.rows, seeds.radii, variance, colour,
        lattice.corner, lattice.size, *lattice.shape, lattice.starts, lattice.order, labels,
    )  # fmt: skip
    return labels


def absorb(
    mesh: Mesh, linked: np.ndarray, rgb: np.ndarray, labels: np.ndarray, kept: np.ndarray
) -> np.ndarray:
    """Give the points of small regions, and those of none, to the region beside them.

    Of several, to the one whose mean colour is nearest. What no region can reach stays `NONE`.

    Parameters
    ----------
    mesh, linked
        As in `grow_regions`.
    rgb : ndarray of float32, shape (n, 3)
    labels : ndarray of int32, shape (n,)
    kept : ndarray of bool, shape (regions + 1,)
        Which regions stay.
    """
    kept = kept.copy()
    kept[NONE] = False
    renamed = np.where(kept, np.cumsum(kept), NONE).astype(np.int32)[labels]
    counts = np.bincount(renamed)
    means = np.stack([np.bincount(renamed, rgb[:, channel]) for channel in range(3)], axis=1)
    means /= np.maximum(counts, 1)[:, None]
    _spread(*mesh.neighbours(linked), rgb, means, renamed)
    return renamed


@njit(cache=True, nogil=True)
def _grow_all(
    points, rgb, relative, reach, first, neighbours, seeds, radii, variance, colour,
    corner, size, columns, rows, starts, order, labels,
):  # fmt: skip
    members, mean = np.empty(len(points), np.int64), np.empty(3)
    region = 0
    for place in range(len(seeds)):
        seed = seeds[place]
        if labels[seed] != NONE:
            continue
        count, every = gather(
            points, seed, radii[place], corner, size, columns, rows, starts, order, labels, members
        )
        if count < max(FEWEST, FREE_SHARE * every):
            continue
        if mean_and_variance(rgb, members, count, mean) >= variance:
            continue
        region += 1
        for member in members[:count]:
            if distance_in_colour(rgb, member, mean) < colour:
                labels[member] = region
        _grow(rgb, relative, reach, first, neighbours, colour, region, members, count, mean, labels)


@njit(cache=True, nogil=True)
def _grow(rgb, relative, reach, first, neighbours, colour, region, members, count, mean, labels):
    """Grow one region wave by wave; the result of a wave does not depend on the order of the points."""
    start, total = 0, 0
    sums, intensities = np.zeros(3), 0.0
    for place in range(count):
        if labels[members[place]] == region:
            members[total] = members[place]
            total += 1
    while start < total:
        stop = total
        for place in range(start, stop):
            for channel in range(3):
                sums[channel] += rgb[members[place], channel]
            intensities += relative[members[place]]
        for channel in range(3):
            mean[channel] = sums[channel] / stop
        level = intensities / stop
        for place in range(start, stop):
            point = members[place]
            for link in range(first[point], first[point + 1]):
                other = neighbours[link]
                if labels[other] != NONE or abs(relative[other] - level) > reach:
                    continue
                if distance_in_colour(rgb, other, mean) < colour:
                    labels[other] = region
                    members[total] = other
                    total += 1
        start = stop


@njit(cache=True, nogil=True)
def _spread(first, neighbours, rgb, means, labels):
    """Label what has no label from its neighbours, wave by wave."""
    waiting = np.flatnonzero(labels == NONE)
    while len(waiting):
        found = np.zeros(len(waiting), np.int32)
        for place in range(len(waiting)):
            point = waiting[place]
            least = np.inf
            for link in range(first[point], first[point + 1]):
                label = labels[neighbours[link]]
                if label == NONE:
                    continue
                distance = distance_in_colour(rgb, point, means[label])
                if distance < least or (distance == least and label < found[place]):
                    least = distance
                    found[place] = label
        labels[waiting] = found
        if not found.any():
            break
        waiting = waiting[found == NONE]
