"""Regions of one colour, grown from seeds over neighbouring points."""

import numpy as np

from ...geometry.triangulation import Mesh
from ...kernels import kernel
from .appearance import Appearance
from .seeds import Lattice, Seeds, distance_in_colour, gather, mean_and_variance, sort_into_cells
from .settings import ColourSettings

NONE = 0
"""The label of points outside all regions."""


def grow_regions(
    mesh: Mesh,
    linked: np.ndarray,
    looks: Appearance,
    seeds: Seeds,
    variance: float,
    colour: float,
    settings: ColourSettings = ColourSettings(),
) -> np.ndarray:
    """Return regions of similar colour, grown from the seeds over neighbouring points.

    A point is compared with the mean colour of the whole region, which is updated as the region grows.
    It is not compared with its neighbours, so a region cannot creep along a gradient. Where there is
    intensity, it must agree too: this separates dark plaster in the sun from light wood in the shade.

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
    settings : ColourSettings

    Returns
    -------
    ndarray of int32, shape (n,)
        Numbers of the regions from 1; `NONE` where no region grew.
    """
    labels = np.zeros(len(looks.rgb), np.int32)
    if not len(seeds.rows):
        return labels
    lattice = sort_into_cells(mesh.points, seeds.radii.max() / settings.seeds.cells_across)
    _grow_all(
        mesh.points, looks.rgb, *looks.gated(settings.intensity.gate), *mesh.neighbours(linked),
        seeds.rows, seeds.radii, variance, colour, settings.seeds.fewest_points, settings.seeds.free_share,
        lattice, labels,
    )  # fmt: skip
    return labels


def absorb(
    mesh: Mesh, linked: np.ndarray, rgb: np.ndarray, labels: np.ndarray, kept: np.ndarray
) -> np.ndarray:
    """Add the points of small regions, and those outside all regions, to the regions beside them.

    A point with several neighbouring regions joins the one with the nearest mean colour. Points that no
    region can reach remain `NONE`.

    Parameters
    ----------
    mesh, linked
        As in `grow_regions`.
    rgb : ndarray of float32, shape (n, 3)
    labels : ndarray of int32, shape (n,)
    kept : ndarray of bool, shape (regions + 1,)
        Which regions are kept.
    """
    kept = kept.copy()
    kept[NONE] = False
    renamed = np.where(kept, np.cumsum(kept), NONE).astype(np.int32)[labels]
    counts = np.bincount(renamed)
    means = np.stack([np.bincount(renamed, rgb[:, channel]) for channel in range(3)], axis=1)
    means /= np.maximum(counts, 1)[:, None]
    _spread(*mesh.neighbours(linked), rgb, means, renamed)
    return renamed


@kernel
def _grow_all(
    points: np.ndarray,
    rgb: np.ndarray,
    relative: np.ndarray,
    reach: float,
    first: np.ndarray,
    neighbours: np.ndarray,
    seeds: np.ndarray,
    radii: np.ndarray,
    variance: float,
    colour: float,
    fewest: int,
    free_share: float,
    lattice: Lattice,
    labels: np.ndarray,
) -> None:
    """Label the regions of all seeds; a seed that is in a region already is skipped."""
    members, mean = np.empty(len(points), np.int64), np.empty(3)
    region = 0
    for index in range(len(seeds)):
        seed = seeds[index]
        if labels[seed] != NONE:
            continue
        count, every = gather(points, seed, radii[index], lattice, labels, members)
        if count < max(fewest, free_share * every):
            continue
        if mean_and_variance(rgb, members, count, mean) >= variance:
            continue
        region += 1
        for member in members[:count]:
            if distance_in_colour(rgb, member, mean) < colour:
                labels[member] = region
        _grow(rgb, relative, reach, first, neighbours, colour, region, members, count, mean, labels)


@kernel
def _grow(
    rgb: np.ndarray,
    relative: np.ndarray,
    reach: float,
    first: np.ndarray,
    neighbours: np.ndarray,
    colour: float,
    region: int,
    members: np.ndarray,
    count: int,
    mean: np.ndarray,
    labels: np.ndarray,
) -> None:
    """Grow one region wave by wave; the order of the points does not affect the result of a wave."""
    start, total = 0, 0
    sums, intensities = np.zeros(3), 0.0
    for index in range(count):
        if labels[members[index]] == region:
            members[total] = members[index]
            total += 1
    while start < total:
        stop = total
        for index in range(start, stop):
            for channel in range(3):
                sums[channel] += rgb[members[index], channel]
            intensities += relative[members[index]]
        for channel in range(3):
            mean[channel] = sums[channel] / stop
        level = intensities / stop
        for index in range(start, stop):
            point = members[index]
            for link in range(first[point], first[point + 1]):
                other = neighbours[link]
                if labels[other] != NONE or abs(relative[other] - level) > reach:
                    continue
                if distance_in_colour(rgb, other, mean) < colour:
                    labels[other] = region
                    members[total] = other
                    total += 1
        start = stop


@kernel
def _spread(
    first: np.ndarray, neighbours: np.ndarray, rgb: np.ndarray, means: np.ndarray, labels: np.ndarray
) -> None:
    """Label points without a label from their neighbours, wave by wave."""
    waiting = np.flatnonzero(labels == NONE)
    while len(waiting):
        found = np.zeros(len(waiting), np.int32)
        for index in range(len(waiting)):
            point = waiting[index]
            least = np.inf
            for link in range(first[point], first[point + 1]):
                label = labels[neighbours[link]]
                if label == NONE:
                    continue
                distance = distance_in_colour(rgb, point, means[label])
                if distance < least or (distance == least and label < found[index]):
                    least = distance
                    found[index] = label
        labels[waiting] = found
        if not found.any():
            break
        waiting = waiting[found == NONE]
