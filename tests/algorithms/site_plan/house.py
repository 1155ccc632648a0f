"""A house of two rooms whose walls are known, as points and as a plan."""

from dataclasses import replace
from functools import lru_cache

import numpy as np
from ichnograph.algorithms.site_plan.results import SitePlan
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.algorithms.site_plan.surfaces import ORIGIN, SHIFT, cloud_of, level, upright
from rasterio.crs import CRS
from shapely.affinity import translate
from shapely.geometry import MultiPolygon, Polygon, box
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

THICKNESS = 0.3
ROOMS = (box(0, 0, 4, 4), box(4.3, 0, 7.3, 4))
DOOR = box(4.0, 1.5, 4.3, 2.4)
SHELL = box(-THICKNESS, -THICKNESS, 7.3 + THICKNESS, 4 + THICKNESS)
UTM = CRS.from_epsg(25833)


def walls_of_house(*gaps: Polygon) -> BaseGeometry:
    """Return the walls less the door and more gaps, in the coordinates of the cloud."""
    walls = SHELL.difference(unary_union([*ROOMS, DOOR, *gaps]))
    return translate(walls, *(ORIGIN + SHIFT)[:2])


def points_of_house(*gaps: Polygon) -> np.ndarray:
    """Return points on both faces of the walls, 2.4 m high, and on the ground where it can be seen."""
    walls = SHELL.difference(unary_union([*ROOMS, DOOR, *gaps]))
    parts = walls.geoms if isinstance(walls, MultiPolygon) else [walls]
    rings = [np.asarray(ring.coords) for part in parts for ring in (part.exterior, *part.interiors)]
    faces = [upright(a, b, 0.0, 2.4) for ring in rings for a, b in zip(ring, ring[1:])]
    ground = level((-2, 10), (-2, 6), 0.0)
    seen = ~_within(ground, SHELL)
    for space in (*ROOMS, DOOR, *gaps):
        seen |= _within(ground, space)
    return np.concatenate([ground[seen], *faces])


def _within(points: np.ndarray, area: Polygon) -> np.ndarray:
    west, south, east, north = area.bounds
    x, y, _ = points.T
    return (x > west) & (x < east) & (y > south) & (y < north)


@lru_cache(maxsize=1)
def plan_of_house() -> SitePlan:
    """Return the plan with axes and rooms; made once."""
    settings = SitePlanSettings(with_axes=True, with_rooms=True)
    return replace(make_site_plan(cloud_of(points_of_house()), settings), crs=UTM)


def points_under_ceiling(*furniture: np.ndarray) -> np.ndarray:
    """Return points inside a room of 4 by 3 m that has a ceiling, as a scanner in it would leave them."""
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
    faces = [upright(a, b, 0.0, 2.6) for a, b in zip(corners, corners[1:] + corners[:1])]
    return np.concatenate([*(level((0, 4), (0, 3), z) for z in (0.0, 2.6)), *faces, *furniture])
