"""Where rooms run out of a building: through gates, glazed fronts and doors to terraces."""

import numpy as np
from shapely.geometry import Point
from shapely.geometry.base import BaseGeometry
from shapely.prepared import prep

from ..division.division import Division
from ..settings import CutSettings, RoomSettings


def leaves_roof(ends: np.ndarray, roof: BaseGeometry, settings: RoomSettings = RoomSettings()) -> np.ndarray:
    """Return which lines have a roof before them, and none beyond the thickness of a wall.

    Parameters
    ----------
    ends : ndarray of float64, shape (n, 4)
        x, y of both ends.
    roof : Polygon or MultiPolygon
        Where a ceiling was seen.
    settings : RoomSettings
    """
    length = np.hypot(ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1])
    along = (ends[:, 2:] - ends[:, :2]) / np.maximum(length, 1e-9)[:, None]
    left = np.column_stack([-along[:, 1], along[:, 0]])
    middle = (ends[:, :2] + ends[:, 2:]) / 2
    covers = prep(roof)
    covered = {
        distance: np.array([covers.contains(Point(*xy)) for xy in middle + distance * left], bool)
        for side in (1, -1)
        for distance in (side * settings.before_edge_m, side * settings.beyond_edge_m)
    }
    near, far = settings.before_edge_m, settings.beyond_edge_m
    return (covered[near] & ~covered[-far]) | (covered[-near] & ~covered[far])


def are_outdoors(
    division: Division,
    part: np.ndarray,
    chosen: np.ndarray,
    roof: BaseGeometry,
    settings: RoomSettings = RoomSettings(),
    cut: CutSettings = CutSettings(),
) -> np.ndarray:
    """Return which parts of what is room lie outdoors: hardly under a roof, and hardly between walls.

    Parameters
    ----------
    division : Division
    part : ndarray of int, shape (cells + 1,)
        The number of the part that each cell belongs to.
    chosen : ndarray of int
        Numbers of the parts that are asked for.
    roof : Polygon or MultiPolygon
    settings, cut : RoomSettings, CutSettings

    Returns
    -------
    ndarray of bool, shape (chosen,)
    """
    sides, lengths = division.arrangement.sides, division.arrangement.lengths
    rim = division.are_borders()
    owner = part[np.where(division.is_room[sides[:, 0]], sides[:, 0], sides[:, 1])]
    faced = rim & division.has_face(cut)
    around, walled = (np.bincount(owner[mask], lengths[mask], part.max() + 1) for mask in (rim, faced))
    outdoors = walled[chosen] < settings.walled_share * around[chosen]
    for row in np.flatnonzero(outdoors):
        space = division.area(np.flatnonzero((part == chosen[row]) & division.is_room))
        outdoors[row] = space.intersection(roof).area < settings.roofed_share * space.area
    return outdoors
