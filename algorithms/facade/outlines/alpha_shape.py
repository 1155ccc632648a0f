"""The outline of points: the alpha shape of Edelsbrunner and Muecke."""

from typing import Optional

import numpy as np
from shapely.geometry import MultiLineString, MultiPolygon, Point, Polygon
from shapely.ops import polygonize
from shapely.prepared import prep

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
    counts = np.bincount(mesh.sides[kept].ravel(), minlength=len(mesh.edges))
    boundary = mesh.points[mesh.edges[counts == 1]]
    faces = list(polygonize(MultiLineString(list(boundary))))
    middles = mesh.points[triangles].mean(axis=1)
    return MultiPolygon([face for face in faces if _holds_any(face, middles)])


def _holds_any(face: Polygon, middles: np.ndarray) -> bool:
    """Whether a face contains a triangle; a face is filled by triangles entirely or not at all."""
    left, bottom, right, top = face.bounds
    inside = (middles > (left, bottom)).all(axis=1) & (middles < (right, top)).all(axis=1)
    holds = prep(face).contains
    return any(holds(Point(*middle)) for middle in middles[inside])
