"""Walls: what stands behind the faces that bound the rooms."""

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.ops import linemerge, unary_union

from .settings import WallSettings

MITRE = 2
"""Join style of buffers that keep corners."""

SQUARE = 2
"""Cap style of buffers that end square at their line's end."""


def wall_bodies(faces: np.ndarray, solid, settings: WallSettings = WallSettings()) -> list:
    """Return the walls behind faces, not cut into pieces.

    Parameters
    ----------
    faces : ndarray of float64, shape (n, 4)
        x, y of both ends; the solid lies to the left.
    solid : Polygon or MultiPolygon
        All that is not room.
    settings : WallSettings

    Returns
    -------
    list of Polygon
    """
    strips = behind(faces, settings.strip_m, solid)
    half = settings.thickest_m / 2
    deep = solid.buffer(-half, join_style=MITRE).buffer(half + 1e-3, join_style=MITRE)
    thin = solid.difference(deep)
    backed = behind(faces, settings.thickest_m, thin)
    body = unary_union([strips, backed]).buffer(0.002, join_style=MITRE).buffer(-0.002, join_style=MITRE)
    parts = getattr(body, "geoms", [body])
    return [part for part in parts if part.geom_type == "Polygon" and part.area >= settings.smallest_m2]


def behind(faces: np.ndarray, depth: float, within):
    """Return what lies within a depth behind faces."""
    runs = linemerge([LineString(face.reshape(2, 2)) for face in faces])
    runs = getattr(runs, "geoms", [runs])
    strips = [run.buffer(depth, single_sided=True, join_style=MITRE, mitre_limit=3.0) for run in runs]
    strips = [strip.buffer(0) for strip in strips]
    return unary_union(strips).intersection(within)
