"""Openings: doors, windows and passages, where the line of a wall continues above or below open space.

Screens, thin walls that stand free, part rooms as well.
"""

from dataclasses import dataclass

import numpy as np
from shapely.geometry.base import BaseGeometry

from ....geometry.linked_parts import label_linked
from ..division.arrangement import ON_LINE
from ..division.division import Division
from ..evidence.uprights_along import UprightsAlong
from ..settings import LevelSettings, RoomSettings
from .outdoors import are_outdoors, leaves_roof
from .spaces import is_room


@dataclass(frozen=True)
class Parts:
    """The parts that rooms fall into when they are cut at openings.

    Attributes
    ----------
    outlines : list of Polygon or MultiPolygon
    over_sill : list of bool
        Whether a part is cut off by the face of a parapet.
    """

    outlines: list[BaseGeometry]
    over_sill: list[bool]


@dataclass(frozen=True)
class _Openings:
    """Borders between cells of rooms that lie in openings.

    Attributes
    ----------
    open, over_sill : ndarray of bool, shape (borders,)
        Those in openings, and those of them over a parapet.
    edge : ndarray of bool, shape (borders,)
        Those on lines along which the roof ends.
    shut : list of ndarray of int
        Those of each opening that something fills: a leaf, a curtain, a piece of furniture.
    """

    open: np.ndarray
    over_sill: np.ndarray
    edge: np.ndarray
    shut: list[np.ndarray]


def cut_at_openings(
    division: Division,
    screens: np.ndarray,
    roof: BaseGeometry,
    uprights: UprightsAlong,
    settings: RoomSettings = RoomSettings(),
    levels: LevelSettings = LevelSettings(),
) -> Parts:
    """Cut what is room along screens, and along the lines of sheets at doors, windows and gates.

    Doors and windows lie under a lintel. Wide gates do too, or the roof ends along them.

    Parameters
    ----------
    division : Division
    screens : ndarray of float64, shape (n, 4)
        x, y of both ends of thin walls in rooms.
    roof : Polygon or MultiPolygon
        Where a ceiling was seen.
    uprights : UprightsAlong
    settings, levels : RoomSettings, LevelSettings
    """
    sides, room = division.arrangement.sides, division.is_room
    on_screen = _are_on(division.arrangement.ends, screens, settings.screen_reach_m)
    wall = division.are_borders() | on_screen
    inside = room[sides].all(axis=1) & ~on_screen
    candidate = np.flatnonzero(inside & (division.tracks.sheet >= 0))
    found = _openings(division, candidate, wall, roof, uprights, settings, levels)
    linked = _cut_at_edges(division, inside & ~found.open, found.edge, roof, settings)
    linked = _cut_at_shut_doors(division, linked, found.shut, settings)
    part = _linked(sides[linked], len(room))
    numbers = np.unique(part[room])
    outlines = [division.area(np.flatnonzero((part == number) & room)) for number in numbers]
    return Parts(outlines, np.isin(numbers, part[sides[found.over_sill]]).tolist())


def _are_on(ends: np.ndarray, screens: np.ndarray, reach: float) -> np.ndarray:
    """Return which borders lie on a screen, or within a reach of its ends on its line."""
    on_screen = np.zeros(len(ends), bool)
    for screen in screens:
        length = np.hypot(*(screen[2:] - screen[:2]))
        along, across = _along_and_across(ends.reshape(-1, 2), screen)
        middle = along.reshape(-1, 2).mean(axis=1)
        on_line = (np.abs(across.reshape(-1, 2)) < ON_LINE).all(axis=1)
        on_screen |= on_line & (middle > -reach) & (middle < length + reach)
    return on_screen


def _along_and_across(xy: np.ndarray, line: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return how far positions lie along and across a line from its start, metres."""
    away, direction = xy - line[:2], (line[2:] - line[:2]) / np.hypot(*(line[2:] - line[:2]))
    return away @ direction, away @ np.array([-direction[1], direction[0]])


def _linked(sides: np.ndarray, count: int) -> np.ndarray:
    first, second = sides.T
    return label_linked(first, second, count)


def _openings(
    division: Division,
    candidate: np.ndarray,
    wall: np.ndarray,
    roof: BaseGeometry,
    uprights: UprightsAlong,
    settings: RoomSettings,
    levels: LevelSettings,
) -> _Openings:
    """Find the openings among borders, given by number, on lines of sheets from wall to wall."""
    borders = division.arrangement.ends
    open_, over_sill, edge = np.zeros((3, len(borders)), bool)
    found = _Openings(open_, over_sill, edge, [])
    ends, length = borders[candidate], division.arrangement.lengths[candidate]
    head, low, high = (round(z / levels.level_m) for z in (settings.head_m, *levels.eye_m))
    masks = (-1 << head, (1 << high) - (1 << low), (1 << low) - 2)
    surface = np.array([uprights.mean_levels(ends, mask) for mask in masks])
    leaves = leaves_roof(ends, roof, settings)
    rim = _nodes(borders[wall])
    for run in _runs(ends, rim):
        if not all(tip in rim for tip in _tips(ends[run])):
            continue
        width = length[run].sum()
        above, eye, below = surface[:, run] @ length[run] / width
        has_lintel = above >= settings.lintel_levels
        is_edge = leaves[run] @ length[run] >= settings.edge_share * width
        found.edge[candidate[run]] = is_edge
        if eye > settings.open_share * (high - low):
            if has_lintel and width <= settings.widest_leaf_m:
                found.shut.append(candidate[run])
            continue
        is_window = has_lintel and below >= settings.parapet_levels and width <= settings.widest_window_m
        is_end = is_edge or width <= settings.widest_opening_m
        found.open[candidate[run]] = is_window or (has_lintel and is_end)
        found.over_sill[candidate[run]] = is_window
    return found


def _cut_at_edges(
    division: Division, linked: np.ndarray, edge: np.ndarray, roof: BaseGeometry, settings: RoomSettings
) -> np.ndarray:
    """Return which borders link cells, less those on edges of the roof that part a room from the outdoors."""
    sides, edge = division.arrangement.sides, edge & linked
    part = _linked(sides[linked & ~edge], len(division.is_room))
    outdoors = np.zeros(len(part), bool)
    beside = np.unique(part[sides[edge]])
    outdoors[beside] = are_outdoors(division, part, beside, roof, settings)
    first, second = outdoors[part[sides]].T
    return linked & ~(edge & (first != second))


def _cut_at_shut_doors(
    division: Division, linked: np.ndarray, shut: list[np.ndarray], settings: RoomSettings
) -> np.ndarray:
    """Return which borders link cells, less the shut openings between two rooms: the others are furniture."""
    sides, room = division.arrangement.sides, division.is_room
    areas = np.array([*(cell.area for cell in division.arrangement.cells), 0.0])
    linked = linked.copy()
    for own in sorted(shut, key=len):
        own = own[linked[own]]
        if not len(own):
            continue
        linked[own] = False
        part = _linked(sides[linked], len(room))
        beside = {part[side] for side in sides[own[0]]}
        cells = [np.flatnonzero((part == number) & room) for number in beside]
        if len(cells) < 2 or not all(_are_room(division, own, areas, settings) for own in cells):
            linked[own] = True
    return linked


def _are_room(division: Division, cells: np.ndarray, areas: np.ndarray, settings: RoomSettings) -> bool:
    """Return whether cells together are a room; large ones are."""
    total = areas[cells].sum()
    if total < settings.smallest_m2:
        return False
    return total > settings.surely_wide * settings.smallest_m2 or is_room(division.area(cells), settings)


def _nodes(ends: np.ndarray) -> set[tuple[float, float]]:
    return {(x, y) for x, y in ends.reshape(-1, 2).tolist()}


def _runs(ends: np.ndarray, rim: set[tuple[float, float]]) -> list[np.ndarray]:
    """Return the numbers of the borders that are connected on one line between nodes on the rim."""
    at_node: dict[tuple[float, float], list[int]] = {}
    first, second = [], []
    for number, (x0, y0, x1, y1) in enumerate(ends.tolist()):
        for node in ((x0, y0), (x1, y1)):
            if node in rim:
                continue
            for other in at_node.setdefault(node, []):
                if _are_in_line(ends[number], ends[other]):
                    first.append(number)
                    second.append(other)
            at_node[node].append(number)
    label = label_linked(np.array(first, int), np.array(second, int), len(ends))
    return [np.flatnonzero(label == number) for number in np.unique(label)]


def _are_in_line(one: np.ndarray, other: np.ndarray) -> bool:
    a, b = one[2:] - one[:2], other[2:] - other[:2]
    return abs(a[0] * b[1] - a[1] * b[0]) <= 0.01 * np.hypot(*a) * np.hypot(*b)


def _tips(ends: np.ndarray) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the two ends of borders in one line."""
    nodes = ends.reshape(-1, 2)
    along = nodes @ (ends[0, 2:] - ends[0, :2])
    return tuple(nodes[np.argmin(along)].tolist()), tuple(nodes[np.argmax(along)].tolist())
