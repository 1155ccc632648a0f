"""Points on the faces of walls whose outlines are known, and the plan that they give."""

from typing import Optional

import numpy as np
from affine import Affine
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.faces.face_points import face_points
from ichnograph.algorithms.site_plan.faces.refinement import refine_walls
from ichnograph.algorithms.site_plan.site_plan import extract_walls
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.polygon import orient

PIXEL = 0.1
SPACING = 0.03
MARGIN = 1.0


def masonry(axis, thickness: float) -> Polygon:
    """Return a wall along an axis, cut square at its ends."""
    return LineString(axis).buffer(thickness / 2, cap_style=2, join_style=2)


def faces_of(polygon: Polygon, height: float = 2.0) -> np.ndarray:
    """Return points about `SPACING` apart on all faces: x, y, z, and the normal's x, y; shape (n, 5)."""
    polygon = orient(polygon)
    return np.concatenate([_face(ring, height) for ring in (polygon.exterior, *polygon.interiors)])


def _face(ring, height: float) -> np.ndarray:
    corners = np.asarray(ring.coords)
    sides = np.diff(corners, axis=0)
    lengths = np.hypot(*sides.T)
    way = np.r_[0.0, np.cumsum(lengths)]
    along, up = np.meshgrid(np.arange(SPACING / 2, way[-1], SPACING), np.arange(SPACING / 2, height, SPACING))
    along, up = along.ravel(), up.ravel()
    # Scan lines do not stand above each other.
    along = (along + up * 0.37) % way[-1]
    side = np.searchsorted(way, along, "right") - 1
    unit = sides[side] / lengths[side, None]
    xy = corners[side] + (along - way[side])[:, None] * unit
    return np.column_stack([xy, up, unit[:, 1], -unit[:, 0]])


def scattered(faces: np.ndarray, noise: float = 0.003, seed: int = 0) -> np.ndarray:
    """Return the points moved along their normals by a normal deviate, shape (n, 3)."""
    points = faces[:, :3].copy()
    points[:, :2] += np.random.default_rng(seed).normal(0, noise, (len(faces), 1)) * faces[:, 3:]
    return points


def refined(
    points: np.ndarray, unseen: Optional[Polygon] = None, faces: Optional[np.ndarray] = None
) -> tuple:
    """Return the walls of a plan of points, shape (n, 3), outlined by pixels, and outlined by faces.

    The ground was seen everywhere but in `unseen`; the faces are looked for in `faces` if they are given.
    """
    low = np.floor(points[:, :2].min(axis=0) - MARGIN)
    columns, rows = np.ceil((points[:, :2].max(axis=0) + MARGIN - low) / PIXEL).astype(int)
    density = np.full((rows, columns), 2.0)
    if unseen is not None:
        for row, column in np.ndindex(rows, columns):
            if unseen.contains(Point(*(low + PIXEL * np.array([column + 0.5, row + 0.5])))):
                density[row, column] = np.nan
    column, row = np.floor((points[:, :2] - low) / PIXEL).astype(int).T
    density[row, column] = 50.0
    density = density[::-1]
    transform = Affine(PIXEL, 0, low[0], 0, -PIXEL, low[1] + rows * PIXEL)
    walls = extract_walls(DensityRaster(density, None, transform, None), WallParameters()).walls
    given = points if faces is None else faces
    level = (given[:, 2] / 0.05).astype(np.int64)
    near = face_points(given[:, :2] - low, level, np.ones(len(given), np.int64))
    return walls, refine_walls(walls, near, density, transform)[0]


def offset(outline: Polygon, truth: Polygon) -> float:
    """Return the largest distance (m) of two boundaries from each other."""
    return max(_farthest(outline.boundary, truth.boundary), _farthest(truth.boundary, outline.boundary))


def _farthest(asked, given) -> float:
    return max(
        given.distance(part.interpolate(place))
        for part in getattr(asked, "geoms", [asked])
        for place in np.arange(0, part.length, 0.01)
    )
