"""Details in the plane of the wall that differ from it by their colour only."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.triangulation import Mesh
from ..settings import FacadeSettings
from .appearance import Appearance
from .intensity_fusion import components, fuse_by_intensity, fuse_by_soft_borders, largest_first
from .region_growing import absorb, grow_regions
from .seeds import find_seeds


@dataclass(frozen=True)
class Coloured:
    """The regions of one plane.

    Attributes
    ----------
    labels : ndarray of int32, shape (n,)
        0 for the wall, details from 1.
    looks : Appearance or None
        Of the points; None without colour.
    regions, surfaces : int
        Regions of one colour, and surfaces after their fusion.
    variance : float
        Vr, as used.
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
    settings: FacadeSettings = FacadeSettings(),
) -> Coloured:
    """Grow regions of one colour, fuse them, and return those that differ from the wall.

    Parameters
    ----------
    mesh : Mesh
        Of the n points of the plane.
    linked : ndarray of bool, shape (k,)
        Its edges between neighbours.
    sizes : ndarray of float64, shape (n,)
        The area that each point represents (m2).
    looks : Appearance
        Of the n points.
    settings : FacadeSettings
    """
    rgb = looks.rgb
    own = settings.colour
    seeds = find_seeds(mesh.points, rgb, settings.seed_radius_m, own.seeds)
    variance = settings.seed_variance
    if variance is None:
        variance = seeds.automatic_variance(own.seeds)
    accepted = seeds.accepted(settings.seed_colour, variance)
    grown = grow_regions(mesh, linked, looks, accepted, variance, settings.grow_colour, own)
    smallest = settings.smallest_m2
    large = np.bincount(grown, sizes) >= own.smallest_region * smallest
    regions = absorb(mesh, linked, rgb, grown, large)
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
