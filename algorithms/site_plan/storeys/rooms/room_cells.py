"""Rooms: what is seen as room, cut at doors, windows and passages."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from affine import Affine
from rasterio.features import rasterize
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from ....geometry.polygons import polygons_of
from ..division.division import Division
from ..division.outlines import tidy
from ..evidence.footprint import Footprint
from ..evidence.levels import Storey
from ..evidence.uprights_along import UprightsAlong
from ..settings import LevelSettings, RoomSettings
from .necks import cut_at_necks
from .openings import cut_at_openings
from .spaces import is_room


@dataclass(frozen=True)
class Room:
    """A room.

    Attributes
    ----------
    outline : Polygon
        Metres; along the faces of the walls and straight across openings. Free columns are holes.
    z_floor, z_ceiling : float or None
        Usual heights, metres; None where not seen.
    seen : float
        Share of the area over which floor or ceiling was seen.
    """

    outline: Polygon
    z_floor: Optional[float]
    z_ceiling: Optional[float]
    seen: float


def find_rooms(
    division: Division,
    screens: np.ndarray,
    roof: BaseGeometry,
    footprint: Footprint,
    storey: Storey,
    uprights: UprightsAlong,
    settings: RoomSettings = RoomSettings(),
    levels: LevelSettings = LevelSettings(),
) -> tuple[list[Room], list[Polygon]]:
    """Find the rooms, and the parapets in the niches of windows.

    Parameters
    ----------
    division : Division
    screens : ndarray of float64, shape (n, 4)
        x, y of both ends of thin walls that stand free in rooms.
    roof : Polygon or MultiPolygon
        Where a ceiling was seen.
    footprint : Footprint
    storey : Storey
    uprights : UprightsAlong
    settings, levels : RoomSettings, LevelSettings

    Returns
    -------
    rooms : list of Room
        The largest first.
    parapets : list of Polygon
    """
    parts = cut_at_openings(division, screens, roof, uprights, settings, levels)
    rooms: list[Polygon] = []
    parapets: list[Polygon] = []
    for part, over_sill in zip(parts.outlines, parts.over_sill):
        for outline in polygons_of(part):
            if is_room(outline, settings):
                rooms += [piece for piece in cut_at_necks(outline, settings) if is_room(piece, settings)]
            elif over_sill and _is_parapet(outline, footprint, storey, settings):
                parapets.append(outline)
    rooms.sort(key=lambda room: -room.area)
    return [_described(room, footprint) for room in rooms], parapets


def _pixels(outline: Polygon, footprint: Footprint) -> tuple[np.ndarray, np.ndarray]:
    """Return the numbers of the pixels inside an outline."""
    frame = footprint.frame
    low, high = np.reshape(outline.bounds, (2, 2))
    (row0, row1), (column0, column1) = frame.places(np.array([low, high]))
    grid = Affine(
        frame.pixel_m,
        0,
        frame.left + column0 * frame.pixel_m,
        0,
        frame.pixel_m,
        frame.bottom + row0 * frame.pixel_m,
    )
    shape = (row1 - row0 + 1, column1 - column0 + 1)
    inside = rasterize([outline], shape, transform=grid, dtype="uint8")
    row, column = np.nonzero(inside)
    return row + row0, column + column0


def _described(outline: Polygon, footprint: Footprint) -> Room:
    pixels = _pixels(outline, footprint)
    weight = footprint.weight[pixels]
    known = weight[np.isfinite(weight)]
    seen = float((known > 0).mean()) if len(known) else 0.0
    return Room(tidy(outline), _median(footprint.floor[pixels]), _median(footprint.ceiling[pixels]), seen)


def _median(values: np.ndarray) -> Optional[float]:
    values = values[np.isfinite(values)]
    return float(np.median(values)) if len(values) else None


def _is_parapet(niche: Polygon, footprint: Footprint, storey: Storey, settings: RoomSettings) -> bool:
    """Return whether the floor of a niche is a sill."""
    if niche.area < 0.01 or not niche.buffer(-settings.deepest_parapet_m / 2).is_empty:
        return False
    floor = footprint.floor[_pixels(niche, footprint)]
    floor = floor[np.isfinite(floor)]
    if not len(floor) or np.median(floor) < storey.floor + settings.sill_m:
        return False
    return bool((np.abs(floor - np.median(floor)) < settings.sill_off_m).mean() >= settings.sill_share)
