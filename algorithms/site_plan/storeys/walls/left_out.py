"""Upright surfaces in rooms that are not walls, each with the reason."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from ..division.outlines import parts_of
from ..evidence.levels import count_levels
from ..evidence.sheets import Sheet
from ..evidence.uprights_along import UprightsAlong
from ..settings import CutSettings, FreeFaceSettings, LevelSettings
from .free_faces import has_wall_behind

HANGS = "nothing stands at the cut: a beam, a lamp, or what hangs"
LOW = "ends below the heads of people: furniture"
CLOSE = "stands close before a wall: furniture, a curtain or a door leaf"
SPARSE = "fills less than half of the height: a curtain or clutter"
SHORT = "too short for a wall that stands free: a door leaf or furniture"
"""Reasons, at most 80 characters long."""


@dataclass(frozen=True)
class LeftOut:
    """A surface that is not a wall.

    Attributes
    ----------
    line : LineString
        Metres.
    reason : str
    area : float
        How much of it was seen, m2.
    """

    line: LineString
    reason: str
    area: float


def find_left_out(
    sheets: Sequence[Sheet],
    rooms: BaseGeometry,
    walls: Sequence[Polygon],
    faces: np.ndarray,
    uprights: UprightsAlong,
    settings: FreeFaceSettings = FreeFaceSettings(),
    cut: CutSettings = CutSettings(),
    levels: LevelSettings = LevelSettings(),
) -> list[LeftOut]:
    """Return the sheets in rooms that are not walls, with the first reason that holds.

    Parameters
    ----------
    sheets : sequence of Sheet
    rooms : Polygon or MultiPolygon
    walls : sequence of Polygon
        What stands in rooms and is a wall.
    faces : ndarray of float64, shape (n, 4)
        Faces that bound rooms; the solid lies to the left.
    uprights : UprightsAlong
    settings, cut, levels : FreeFaceSettings, CutSettings, LevelSettings
    """
    inside = rooms.buffer(-settings.apart_m)
    standing = [wall for wall in walls if wall.intersects(inside)]
    inside = inside.difference(unary_union(standing).buffer(settings.apart_m)) if standing else inside
    found = []
    for sheet in sheets:
        for part in parts_of(sheet.line.intersection(inside)):
            if part.length >= settings.run_m:
                ends = np.asarray(part.coords)
                bits, _ = uprights.stations(np.r_[ends[0], ends[-1]][None])
                reason = _reason(np.r_[ends[0], ends[-1]], bits, faces, settings, cut, levels)
                area = part.length * levels.level_m * float(count_levels(bits).mean())
                found.append(LeftOut(part, reason, area))
    return found


def _reason(
    line: np.ndarray,
    bits: np.ndarray,
    faces: np.ndarray,
    settings: FreeFaceSettings,
    cut: CutSettings,
    levels: LevelSettings,
) -> str:
    """Return why a line, x and y of both ends, with the levels at its stations, is not a wall."""
    low, high, head, section = (
        round(height / levels.level_m)
        for height in (settings.from_m, settings.to_m, settings.head_m, cut.section_m)
    )
    below, above, wall = (
        count_levels(bits & np.uint64(mask)).mean()
        for mask in ((1 << (section + 1)) - 1, (1 << 64) - (1 << head), (1 << high) - (1 << low))
    )
    if below < settings.head_levels:
        return HANGS
    if above < settings.head_levels:
        return LOW
    if has_wall_behind(line, faces, settings):
        return CLOSE
    return SPARSE if wall < settings.filled * (high - low) else SHORT
