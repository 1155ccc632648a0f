"""The division of a storey into rooms and solid."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from shapely.geometry.base import BaseGeometry

from ....geometry.linked_parts import label_linked
from ..evidence.footprint import Footprint
from ..evidence.sheets import Sheet
from ..evidence.uprights_along import UprightsAlong
from ..settings import CutSettings, LevelSettings
from .arrangement import (
    Arrangement,
    Tracks,
    arrange,
    find_tracks,
    footprint_lines,
    seen_and_unseen,
    sheet_lines,
)
from .explaining import fill_between, give_back
from .minimum_cut import minimum_cut
from .outlines import united


@dataclass(frozen=True)
class Division:
    """Cells that are room or solid.

    Attributes
    ----------
    arrangement : Arrangement
    tracks : Tracks
    is_room : ndarray of bool, shape (cells + 1,)
        The last is what lies outside the frame.
    seen : ndarray of float, shape (cells,)
        How much of a cell was seen as room, m2.
    levels : ndarray of float, shape (borders,)
        Mean number of levels of upright surface along a border.
    above, tall : ndarray of float, shape (borders,)
        The same above the cut, and above the heads of people and furniture.
    bodies : ndarray of float, shape (sheets,)
        Mean number of levels of each sheet below that.
    """

    arrangement: Arrangement
    tracks: Tracks
    is_room: np.ndarray
    seen: np.ndarray
    levels: np.ndarray
    above: np.ndarray
    tall: np.ndarray
    bodies: np.ndarray

    def area(self, cells: np.ndarray) -> BaseGeometry:
        """Return the area of cells, given as numbers."""
        return united([self.arrangement.cells[cell] for cell in cells])

    @cached_property
    def rooms(self) -> BaseGeometry:
        """All rooms together."""
        return self.area(np.flatnonzero(self.is_room[:-1]))

    @cached_property
    def solid(self) -> BaseGeometry:
        """All that is not room."""
        return self.area(np.flatnonzero(~self.is_room[:-1]))

    def are_borders(self) -> np.ndarray:
        """Return which borders lie between room and solid."""
        left, right = self.is_room[self.arrangement.sides].T
        return left != right

    def faces(self, settings: CutSettings) -> tuple[np.ndarray, np.ndarray]:
        """Return the borders that are faces of walls, the solid to the left, and their numbers."""
        chosen = np.flatnonzero(self.are_borders() & self.has_face(settings))
        ends = self.arrangement.ends[chosen]
        room_left = self.is_room[self.arrangement.sides[chosen, 0]]
        return np.where(room_left[:, None], ends[:, [2, 3, 0, 1]], ends), chosen

    def has_face(self, settings: CutSettings) -> np.ndarray:
        """Return which borders have upright surface along them that rises above the cut."""
        on_sheet = self.tracks.sheet >= 0
        fewest = np.where(on_sheet, settings.fewest_levels, settings.off_sheet_levels)
        stands = (self.tracks.within | (self.levels >= fewest)) & (self.above >= settings.cut_levels)
        body = np.where(on_sheet, np.append(self.bodies, 0)[self.tracks.sheet], self.levels - self.tall)
        return stands & (body >= settings.body_levels)


def divide(
    sheets: Sequence[Sheet],
    footprint: Footprint,
    uprights: UprightsAlong,
    settings: CutSettings = CutSettings(),
    levels: LevelSettings = LevelSettings(),
) -> Division:
    """Divide a storey into rooms and solid by the cheapest cut."""
    lines = sheet_lines(sheets, settings) + footprint_lines(footprint, settings)
    arrangement = arrange(lines, footprint.frame)
    seen, unseen = seen_and_unseen(arrangement, footprint, settings)
    tracks = find_tracks(arrangement.ends, sheets, settings.beside_outline_m)
    head, cut = (round(height / levels.level_m) for height in (settings.tall_m, settings.section_m))
    masks = (-1, -1 << cut, -1 << head)
    every, above, tall = (uprights.mean_levels(arrangement.ends, mask) for mask in masks)
    ends = np.array([[*sheet.start, *sheet.stop] for sheet in sheets]).reshape(-1, 4)
    bodies, heads = (uprights.mean_levels(ends, mask) for mask in ((1 << head) - 1, -1 << head))
    nowhere = np.zeros(len(seen) + 1, bool)
    division = Division(arrangement, tracks, nowhere, seen, every, above, tall, bodies)
    cost = _costs(division, _usual_levels(sheets), settings)
    inner = (arrangement.sides >= 0).all(axis=1)
    is_room = minimum_cut(unseen, seen, arrangement.sides[inner], cost[inner])
    division = _filled(replace(division, is_room=np.r_[is_room, False]), settings)
    fullness = np.where(tracks.within, np.minimum(tall / _usual_heads(heads, settings), 1), 0)
    low, high = (round(height / levels.level_m) for height in levels.eye_m)
    eye = uprights.mean_levels(arrangement.ends, (1 << high) - (1 << low)) / (high - low)
    return _explained(division, unseen - seen, cost, fullness, np.minimum(fullness, eye), settings)


def _explained(
    division: Division,
    unseen: np.ndarray,
    cost: np.ndarray,
    tall: np.ndarray,
    closed: np.ndarray,
    settings: CutSettings,
) -> Division:
    """Return a division whose tall faces have room on one side and solid on the other, where it can be."""
    borders = division.arrangement.sides, division.arrangement.lengths, cost
    areas = np.array([cell.area for cell in division.arrangement.cells])
    is_room = give_back(division.is_room, unseen, *borders, tall, settings)
    closed = np.where(closed < settings.closed_share, 0, closed)
    return replace(division, is_room=fill_between(is_room, unseen, areas, *borders, closed, settings))


def _costs(division: Division, usual: float, settings: CutSettings) -> np.ndarray:
    """Return what each border between room and solid costs, m2; least on full faces."""
    full = min(settings.full_levels, settings.full_share * usual)
    fullness = np.minimum(division.levels / full, 1)
    cost = settings.border_m * division.arrangement.lengths * (1 - (1 - settings.seen_border) * fullness)
    return np.where(division.tracks.beside, settings.beside_border * cost, cost)


def _usual_heads(heads: np.ndarray, settings: CutSettings) -> float:
    """Return the number of levels above furniture with which a face is full, from that of each sheet."""
    heads = heads[heads >= settings.tall_levels]
    return max(settings.full_share * float(np.median(heads)), settings.tall_levels) if len(heads) else np.inf


def _usual_levels(sheets: Sequence[Sheet]) -> float:
    """Return the number of levels that half of the sheets, by area, fill at least."""
    levels = np.array([sheet.levels for sheet in sheets])
    area = np.array([sheet.levels * sheet.length for sheet in sheets])
    order = np.argsort(levels)
    if not len(order):
        return 1.0
    return float(levels[order][np.searchsorted(np.cumsum(area[order]), area.sum() / 2)])


def _filled(division: Division, settings: CutSettings) -> Division:
    """Make room of enclosed solids that few tall faces surround."""
    sides, count = division.arrangement.sides, len(division.is_room)
    solid = ~division.is_room
    linked = solid[sides].all(axis=1)
    first, second = sides[linked].T % count
    part = label_linked(first, second, count)
    rim = division.are_borders()
    owner = part[np.where(solid[sides[rim, 0]], sides[rim, 0], sides[rim, 1])]
    length = division.arrangement.lengths[rim]
    tall = (division.tall[rim] >= settings.tall_levels) & division.has_face(settings)[rim]
    share = np.bincount(owner, length * tall, count) / np.maximum(np.bincount(owner, length, count), 1e-9)
    shadow = share < settings.shadow_share
    shadow[part[-1]] = False
    return replace(division, is_room=division.is_room | (solid & shadow[part]))
