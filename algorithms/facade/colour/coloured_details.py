"""Details of one plane that only their colour tells from the wall."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy.spatial import cKDTree

from ...geometry.triangulation import Mesh
from ..settings import Settings
from .appearance import SURE, Appearance
from .intensity_fusion import components, fuse_by_intensity, fuse_by_soft_borders, largest_first
from .region_growing import absorb, grow_regions
from .seeds import find_seeds

SMALLEST_REGION = 0.25
"""Of the smallest detail: regions below are specks."""

BAND, CORE = 3.0, 10.0
"""Points nearer to a border than this many spacings may be mixed; those up to there tell its two colours."""

BEAM = 0.01
"""A band is at least as wide as this: laser beams are rarely wider (m)."""

DIVISIONS = 5
"""Times that a border is divided, at most."""

COMPARED = 24
"""Points on either side that a point at a border is compared with."""


@dataclass(frozen=True)
class Coloured:
    """The regions of one plane.

    Attributes
    ----------
    labels : ndarray of int32, shape (n,)
        0 for the wall, details from 1.
    looks : Appearance or None
        Of the points; None if they have no colour.
    regions, surfaces : int
        Regions of one colour, and surfaces after their fusion.
    variance : float
        Vr that was used.
    """

    labels: np.ndarray
    looks: Optional[Appearance]
    regions: int
    surfaces: int
    variance: float


def find_coloured(
    mesh: Mesh,
    linked: np.ndarray,
    sizes: np.ndarray,
    looks: Appearance,
    settings: Settings,
) -> Coloured:
    """Grow regions of one colour, fuse them, and return the pieces that are no wall.

    Parameters
    ----------
    mesh : Mesh
        Of the n points of the plane.
    linked : ndarray of bool, shape (k,)
        Its edges between neighbours.
    sizes : ndarray of float64, shape (n,)
        The area that each point stands for (m2).
    looks : Appearance
        Of the n points.
    settings : Settings
    """
    rgb = looks.rgb
    seeds = find_seeds(mesh.points, rgb, settings.seed_radius)
    variance = seeds.automatic_variance() if settings.seed_variance is None else settings.seed_variance
    accepted = seeds.accepted(settings.seed_colour, variance)
    grown = grow_regions(mesh, linked, looks, accepted, variance, settings.grow_colour)
    smallest = settings.smallest_area
    regions = absorb(mesh, linked, rgb, grown, np.bincount(grown, sizes) >= SMALLEST_REGION * smallest)
    if looks.relative is None:
        surfaces = fuse_by_soft_borders(mesh, linked, regions, rgb, settings.seed_colour)
    else:
        surfaces = fuse_by_intensity(regions, looks.relative, looks.threshold)
    surfaces = largest_first(surfaces, sizes)
    pieces = components(mesh, linked, surfaces)
    details = (np.bincount(pieces, sizes) >= smallest) & (surfaces[_any_of(pieces)] > 1)
    labels = np.where(details, np.cumsum(details), 0).astype(np.int32)[pieces]
    return Coloured(labels, looks, int(regions.max(initial=0)), int(surfaces.max(initial=0)), variance)


def _any_of(pieces: np.ndarray) -> np.ndarray:
    """Return one point of each piece."""
    return np.unique(pieces, return_index=True)[1]


def divide_at_half(
    mesh: Mesh, linked: np.ndarray, looks: Appearance, inside: np.ndarray, spacing: float, colour: float
) -> np.ndarray:
    """Return which points are of a detail, with those at its border given to the side that they resemble.

    The laser spot is mixed of both sides there, and the region that grew first took all of them. Divided
    where either side has half of the spot, neither gains. Repeated, it does not matter where the region
    ended. Intensity divides where the sides differ in it,
    for shadows do not matter to it; colour elsewhere.

    Parameters
    ----------
    mesh, linked, looks
        As in `find_coloured`.
    inside : ndarray of bool, shape (n,)
    spacing : float
        Of the points (m).
    colour : float
        Two sides that differ by less are left as they are.
    """
    for _ in range(DIVISIONS):
        divided = _divide_once(mesh, linked, looks, inside, spacing, colour)
        if np.array_equal(divided, inside):
            break
        inside = divided
    return inside


def _divide_once(
    mesh: Mesh, linked: np.ndarray, looks: Appearance, inside: np.ndarray, spacing: float, colour: float
) -> np.ndarray:
    first, second = mesh.edges[linked].T
    mixed = inside[first] != inside[second]
    contacts = mesh.points[np.unique(np.concatenate([first[mixed], second[mixed]]))]
    if not len(contacts):
        return inside
    band = max(BAND * spacing, BEAM)
    reach = band + (CORE - BAND) * spacing
    low, high = contacts.min(axis=0) - reach, contacts.max(axis=0) + reach
    around = np.flatnonzero(((mesh.points > low) & (mesh.points < high)).all(axis=1))
    distances, _ = cKDTree(contacts).query(mesh.points[around], distance_upper_bound=reach)
    near, core = around[distances <= band], around[(distances > band) & np.isfinite(distances)]
    own, other = core[inside[core]], core[~inside[core]]
    if min(len(own), len(other)) < COMPARED:
        return inside
    sides = _nearest(mesh, own, near), _nearest(mesh, other, near)
    divided = inside.copy()
    divided[near] = _share(looks.rgb, near, *sides, colour, inside[near])
    if looks.relative is not None:
        divided[near] = _share(looks.relative[:, None], near, *sides, SURE * looks.threshold, divided[near])
    return _joined(mesh, linked, divided, inside)


def _nearest(mesh: Mesh, known: np.ndarray, asked: np.ndarray) -> np.ndarray:
    """Return the known points nearest to those asked for, shape (asked, COMPARED)."""
    return known[cKDTree(mesh.points[known]).query(mesh.points[asked], k=COMPARED)[1]]


def _share(
    values: np.ndarray,
    near: np.ndarray,
    own: np.ndarray,
    other: np.ndarray,
    least: float,
    otherwise: np.ndarray,
) -> np.ndarray:
    """Tell which points have more of their own side's values; where the sides are too alike, `otherwise`."""
    own, other = values[own].mean(axis=1), values[other].mean(axis=1)
    contrast = own - other
    squared = np.sum(contrast**2, axis=1)
    shares = np.sum((values[near] - other) * contrast, axis=1) / np.maximum(squared, 1e-9)
    return np.where(squared > least**2, shares > 0.5, otherwise)


def _joined(mesh: Mesh, linked: np.ndarray, divided: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """Return the largest piece of what was divided off; specks beyond the border are of no detail."""
    pieces = components(mesh, linked, divided)
    counts = np.bincount(pieces[divided & inside], minlength=pieces.max() + 1)
    return divided & (pieces == np.argmax(counts))
