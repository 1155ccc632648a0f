"""The points of one plane as a surface: their neighbours, their noise and their outline."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from shapely.geometry import MultiPolygon, Polygon
from skimage.measure import points_in_poly

from ...geometry.triangulation import Links, Mesh, triangulate
from ...progress import Progress
from ..settings import FacadeSettings
from .alpha_shape import alpha_of, outline_of
from .denoising import remove_noise


@dataclass(frozen=True)
class Surface:
    """A surface.

    Attributes
    ----------
    rows : ndarray of int64, shape (n,)
        Of its points among all points, ordered by position.
    mesh : Mesh
        In u, v.
    linked : ndarray of bool, shape (k,)
        The edges of the mesh that join neighbours; those across holes do not.
    sizes : ndarray of float64, shape (n,)
        The area that each point represents (m2); 0 for noise.
    outline : MultiPolygon
        The alpha shape of the points without noise.
    alpha : float
        As used; the median where it follows the density (m).
    """

    rows: np.ndarray
    mesh: Mesh
    linked: np.ndarray
    sizes: np.ndarray
    outline: MultiPolygon
    alpha: float

    @cached_property
    def links(self) -> Links:
        """The neighbours of its points along the edges that join neighbours."""
        return self.mesh.neighbours(self.linked)

    @property
    def area_of_point(self) -> float:
        """Median area that a point represents (m2)."""
        return float(np.median(self.sizes[self.sizes > 0]))

    @property
    def spacing(self) -> float:
        """Median distance between neighbouring points (m)."""
        # Of points with the same position, only one has neighbours.
        return float(np.median(self.mesh.spacings[np.isfinite(self.mesh.spacings)]))


def make_surface(
    uvw: np.ndarray,
    rows: np.ndarray,
    settings: FacadeSettings = FacadeSettings(),
    progress: Progress = Progress(),
) -> Surface:
    """Return the surface of the points of a plane, without noise.

    Parameters
    ----------
    uvw : ndarray of float64, shape (all, 3)
    rows : ndarray of int64, shape (n,)
        Of the points of the plane.
    settings : FacadeSettings
        delta, eta, the number of rounds, and alpha.
    progress : Progress
        Asked between the steps whether to go on, because a thread cannot be interrupted.
    """
    rows = rows[np.lexsort(uvw[rows, :2].T)]
    mesh = triangulate(uvw[rows, :2], progress)
    if settings.alpha_m is None:
        alphas = alpha_of(mesh, settings.outlines)
    else:
        alphas = np.full(len(mesh.triangles), settings.alpha_m)
    progress.check()
    clean = remove_noise(
        mesh,
        settings.triangle_factor,
        settings.triangle_count,
        settings.noise_iterations,
        settings.outlines.noise_rings,
        progress,
    )
    kept = (mesh.circumradii <= alphas) & clean[mesh.triangles].all(axis=1)
    sizes = np.bincount(mesh.triangles[kept].ravel(), np.repeat(mesh.areas[kept], 3) / 3, len(rows))
    alpha = float(np.median(alphas)) if len(alphas) else 0.0
    return Surface(rows, mesh, mesh.sides_of(kept), sizes, outline_of(mesh, kept), alpha)


def within(polygon: Polygon, points: np.ndarray) -> np.ndarray:
    """Return which points, shape (n, 2), lie in a polygon."""
    if polygon.is_empty:
        return np.zeros(len(points), bool)
    left, bottom, right, top = polygon.bounds
    inside = ((points >= (left, bottom)) & (points <= (right, top))).all(axis=1)
    near = points[inside]
    held = np.zeros(len(near), bool)
    for part in getattr(polygon, "geoms", [polygon]):
        # A ring inverts the points within it: those in a hole are inverted twice.
        for ring in (part.exterior, *part.interiors):
            held ^= points_in_poly(near, np.array(ring.coords)[:, :2])
    inside[inside] = held
    return inside
