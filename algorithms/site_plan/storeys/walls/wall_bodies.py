"""Walls: what stands behind the faces that bound the rooms."""

import numpy as np
from shapely.geometry import MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from ....geometry.polygons import polygons_of
from ..division.outlines import tidy, united
from ..settings import WallSettings

MITRE = 2
"""Join style of buffers that keep corners."""

SECTORS = 8
"""Directions of faces are sorted into so many."""

SHARP = -0.5
"""Cosine of the turn beyond which the corner of a strip is cut off."""


SEAM_M2 = 0.002
"""Closing cracks moves the edges of holes by so much area."""


def wall_bodies(
    faces: np.ndarray, solid: BaseGeometry, settings: WallSettings = WallSettings()
) -> list[Polygon]:
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
    half, crack = settings.thickest_m / 2, settings.crack_m
    deep = solid.buffer(-half, join_style=MITRE).buffer(half + crack, join_style=MITRE)
    strips = behind(faces, settings.strip_m).intersection(solid)
    backed = between(faces, settings.thickest_m).intersection(solid.difference(deep))
    body = united([strips, backed]).buffer(crack, join_style=MITRE).buffer(-crack, join_style=MITRE)
    large = [part for part in polygons_of(body) if part.area >= settings.smallest_m2]
    return [tidy(_filled(part, solid, half), settings) for part in large]


def _filled(body: Polygon, solid: BaseGeometry, half: float) -> Polygon:
    """Return a body without the holes that are solid and no wider than a wall: there walls cross."""
    holes = [Polygon(ring) for ring in body.interiors]
    kept = [
        np.asarray(hole.exterior.coords)
        for hole in holes
        if not hole.buffer(-half).is_empty or hole.difference(solid).area > SEAM_M2
    ]
    return Polygon(np.asarray(body.exterior.coords), kept)


def between(faces: np.ndarray, thickest: float) -> BaseGeometry:
    """Return what lies behind two faces that turn their solid sides to each other."""
    along = faces[:, 2:] - faces[:, :2]
    sector = (np.arctan2(along[:, 1], along[:, 0]) // (2 * np.pi / SECTORS)).astype(int) % SECTORS
    # The other face ends where a third wall meets this one, but continues behind it.
    way = thickest * along / np.hypot(*along.T)[:, None]
    longer = faces + np.hstack([-way, way])
    parts = []
    for number in np.unique(sector):
        apart = (sector - number - SECTORS // 2) % SECTORS
        opposite = (apart <= 1) | (apart == SECTORS - 1)
        if opposite.any():
            own = behind(faces[sector == number], thickest)
            parts.append(own.intersection(behind(longer[opposite], thickest)))
    return united(parts)


def behind(faces: np.ndarray, depth: float) -> BaseGeometry:
    """Return what lies within a depth behind faces, with corners where one face continues in another."""
    along = faces[:, 2:] - faces[:, :2]
    normal = np.column_stack([-along[:, 1], along[:, 0]]) / np.hypot(*along.T)[:, None]
    starts, ends = faces[:, :2], faces[:, 2:]
    parts = [
        Polygon([start, end, end + depth * across, start + depth * across])
        for start, end, across in zip(starts, ends, normal)
    ]
    begins: dict[tuple[float, ...], list[int]] = {}
    for number, start in enumerate(map(tuple, starts.tolist())):
        begins.setdefault(start, []).append(number)
    for one, end in enumerate(map(tuple, ends.tolist())):
        for other in begins.get(end, ()):
            turns_away = along[one, 0] * along[other, 1] - along[one, 1] * along[other, 0] < 0
            parts += [_corner(np.array(end), normal[one], normal[other], depth)] if turns_away else []
    return united([part for part in parts if part.is_valid and part.area > 0])


def _corner(end: np.ndarray, one: np.ndarray, other: np.ndarray, depth: float) -> BaseGeometry:
    """Return the corner between the strips behind two faces."""
    tip = (one + other) / max(1 + one @ other, 0.1) if one @ other > SHARP else (one + other) / 2
    return MultiPoint([end, end + depth * one, end + depth * tip, end + depth * other]).convex_hull
