"""Voxels on the faces of a wall, and the ring of its outline as pixels would give it."""

import numpy as np
from ichnograph.algorithms.site_plan.faces.face_points import FacePoints, face_points
from ichnograph.tests.algorithms.site_plan.masonry import faces_of, scattered
from shapely.geometry import Polygon, box
from shapely.geometry.polygon import orient

PIXEL = 0.1

WALL = box(2.0, 2.0, 7.0, 2.3)


def voxels_of(*polygons: Polygon, noise: float = 0.002) -> FacePoints:
    """Return voxels on all faces of polygons, whose coordinates are positive."""
    points = np.concatenate([scattered(faces_of(polygon), noise) for polygon in polygons])
    level = (points[:, 2] / 0.05).astype(np.int64)
    return face_points(points[:, :2], level, np.ones(len(points), np.int64))


def pixel_ring(polygon: Polygon) -> np.ndarray:
    """Return the outer ring of an outline of pixels, half a pixel outside the faces."""
    return np.asarray(orient(polygon.buffer(PIXEL / 2, join_style=2)).exterior.coords)
