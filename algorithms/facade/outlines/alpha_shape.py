"""The outline of points: the alpha shape of Edelsbrunner and Muecke."""

from typing import Optional

import numpy as np
from shapely.geometry import MultiPolygon, Point

from ...geometry.polygons import faces_of
from ...geometry.triangulation import Mesh
from .settings import OutlineSettings


def alpha_of(mesh: Mesh, settings: OutlineSettings = OutlineSettings()) -> np.ndarray:
    """Return an alpha for every triangle, shape (m,) (m).

    Alpha follows the density of the points: thinly scanned parts have no false holes, and densely scanned
    parts keep fine ones.
    """
    return settings.alpha_spacings * np.max(mesh.spacings[mesh.triangles], axis=1, initial=0.0)


def alpha_shape(mesh: Mesh, alpha: Optional[float] = None) -> MultiPolygon:
    """Return the outline of the points of a mesh, with its outer and inner rings.

    Parameters
    ----------
    mesh : Mesh
    alpha : float, optional
        Largest radius of the circle around a triangle that is kept (m); `alpha_of` if not given.
    """
    kept = mesh.circumradii <= (alpha_of(mesh) if alpha is None else alpha)
    return outline_of(mesh, kept)


def outline_of(mesh: Mesh, kept: np.ndarray) -> MultiPolygon:
    """Return the union of the `kept` triangles, shape (m,) of bool."""
    triangles = mesh.triangles[kept]
    if not len(triangles):
        return MultiPolygon()
    sides = mesh.sides[kept].ravel()
    owners = np.empty(len(mesh.edges), np.int64)
    owners[sides] = np.repeat(np.arange(len(triangles)), 3)
    single = np.flatnonzero(np.bincount(sides, minlength=len(mesh.edges)) == 1)
    boundary = mesh.points[mesh.edges[single]]
    middles = mesh.points[triangles[owners[single]]].mean(axis=1)
    # A face is filled by triangles entirely or not at all, so one beside its ring decides.
    beside = dict(zip(map(tuple, boundary.sum(axis=1).tolist()), middles))
    return MultiPolygon([
        face
        for face in faces_of(boundary)
        if face.contains(Point(beside[tuple(np.sum(face.exterior.coords[:2], axis=0))]))
    ])  # fmt: skip
