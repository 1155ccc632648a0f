"""The points of one plane as a surface: which are neighbours, which are noise, and how far it reaches."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import MultiPolygon

from ...geometry.triangulation import Mesh, triangulate
from ..settings import Settings
from .alpha_shape import alpha_of, outline_of
from .denoising import remove_noise


@dataclass(frozen=True)
class Surface:
    """A surface.

    Attributes
    ----------
    rows : ndarray of int64, shape (n,)
        Of its points among all points, in an order that only their places determine.
    mesh : Mesh
        In u, v.
    linked : ndarray of bool, shape (k,)
        The edges of the mesh that join neighbours, not the sides of a hole.
    sizes : ndarray of float64, shape (n,)
        The area that each point stands for (m2); 0 for noise.
    outline : MultiPolygon
        The alpha shape of the points that are no noise.
    alpha : float
        That was used; the median where it follows the density (m).
    """

    rows: np.ndarray
    mesh: Mesh
    linked: np.ndarray
    sizes: np.ndarray
    outline: MultiPolygon
    alpha: float

    @property
    def area_of_point(self) -> float:
        """Median area that a point stands for (m2)."""
        return float(np.median(self.sizes[self.sizes > 0]))

    @property
    def spacing(self) -> float:
        """Median distance between neighbouring points (m)."""
        # Points in one place have one among them that has neighbours.
        return float(np.median(self.mesh.spacings[np.isfinite(self.mesh.spacings)]))


def make_surface(uvw: np.ndarray, rows: np.ndarray, settings: Settings) -> Surface:
    """Triangulate points of a plane, and take noise off.

    Parameters
    ----------
    uvw : ndarray of float64, shape (all, 3)
    rows : ndarray of int64, shape (n,)
        Of the points of the plane.
    settings : Settings
        delta, eta, the number of rounds, and alpha.
    """
    rows = rows[np.lexsort(uvw[rows, :2].T)]
    mesh = triangulate(uvw[rows, :2])
    alphas = _alphas(mesh, settings.alpha)
    noise = ~remove_noise(mesh, settings.triangle_factor, settings.triangle_count, settings.noise_iterations)
    kept = (mesh.circumradii <= alphas) & ~noise[mesh.triangles].any(axis=1)
    sizes = np.bincount(mesh.triangles[kept].ravel(), np.repeat(mesh.areas[kept], 3) / 3, len(rows))
    alpha = float(np.median(alphas)) if len(alphas) else 0.0
    return Surface(rows, mesh, mesh.sides_of(kept), sizes, outline_of(mesh, kept), alpha)


def _alphas(mesh: Mesh, alpha: Optional[float]) -> np.ndarray:
    return alpha_of(mesh) if alpha is None else np.full(len(mesh.triangles), alpha)
