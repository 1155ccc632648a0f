"""Doors, passages and windows of buildings: gaps in walls, and what fills them. Lengths in metres."""

from dataclasses import dataclass, field

import numpy as np
from shapely.geometry import LineString, Polygon, box
from shapely.ops import unary_union

from ..shapes import DOOR_HEAD, polygons
from ..things import Prism
from .furniture import Room, curtain, door_leaf

WINDOW_HEAD = 2.25


@dataclass
class Openings:
    """What interrupts the walls: voids with their lower and upper edge, what fills them, neutral lines."""

    voids: list[tuple[Polygon, float, float]] = field(default_factory=list)
    fillings: list[Prism] = field(default_factory=list)
    lines: list[LineString] = field(default_factory=list)


def walls_with(solid: Polygon, voids: list[tuple[Polygon, float, float]], top: float) -> list[Prism]:
    """Return walls with openings, lintels above them and parapets below them."""
    open_area = unary_union([footprint for footprint, _, _ in voids])
    prisms = [Prism(part, top) for part in polygons(solid.difference(open_area))]
    for footprint, sill, head in voids:
        for gap in polygons(solid.intersection(footprint)):
            prisms.append(Prism(gap, top, head, "lintel"))
            if sill > 0:
                prisms.append(Prism(gap, sill))
    return prisms


def add_door(random: np.random.Generator, openings: Openings, one: Room, other: Room, wall: Polygon) -> None:
    """Put a door with an open leaf, or a wide passage, into a partition."""
    west, south, east, north = wall.bounds
    upright = north - south > east - west
    span = max(north - south, east - west)
    passage = span > 2.6 and random.random() < 0.25
    width = random.uniform(1.5, min(2.2, span - 0.4)) if passage else random.uniform(0.75, 0.95)
    start = random.uniform(0.12, span - width - 0.12)
    if upright:
        void = box(west - 0.01, south + start, east + 0.01, south + start + width)
        lines = [LineString([(x, south + start), (x, south + start + width)]) for x in (west, east)]
    else:
        void = box(west + start, south - 0.01, west + start + width, north + 0.01)
        lines = [LineString([(west + start, y), (west + start + width, y)]) for y in (south, north)]
    openings.voids.append((void, 0.0, DOOR_HEAD))
    openings.lines += lines
    for room in (one, other):
        room.doorways.append(void.buffer(0.85))
    if not passage:
        openings.fillings.append(_leaf(random, void, upright, width, one))


def _leaf(random: np.random.Generator, void: Polygon, upright: bool, width: float, room: Room) -> Prism:
    """Return the leaf of a door, which opens into a room."""
    west, south, east, north = void.bounds
    middle = room.inside.centroid
    opened = random.uniform(60, 110)
    low_end = random.random() < 0.5
    if upright:
        outward = 1 if middle.x > east else -1
        hinge = (east if outward > 0 else west, south if low_end else north)
        closed, turn = (90.0, -outward) if low_end else (-90.0, outward)
    else:
        outward = 1 if middle.y > north else -1
        hinge = (west if low_end else east, north if outward > 0 else south)
        closed, turn = (0.0, outward) if low_end else (180.0, -outward)
    return door_leaf(hinge, width - 0.02, closed + turn * opened, DOOR_HEAD)


def add_window(
    random: np.random.Generator, openings: Openings, room: Room, outline: Polygon, outer: float
) -> None:
    """Put a window, or a glazed front, into the outer wall of a room, if it has one long enough."""
    west, south, east, north = room.inside.bounds
    left, bottom, right, top = outline.bounds
    fronts = [
        ((west, south), (east, south), (0, -1), south == bottom),
        ((west, north), (east, north), (0, 1), north == top),
        ((west, south), (west, north), (-1, 0), west == left),
        ((east, south), (east, north), (1, 0), east == right),
    ]
    fronts = [front for front in fronts if front[3] and np.hypot(*np.subtract(front[1], front[0])) > 2.2]
    if not fronts:
        return
    start, end, outward, _ = fronts[random.integers(len(fronts))]
    face = LineString([start, end])
    glazed = face.length > 3.2 and random.random() < 0.3
    width = face.length - 0.6 if glazed else random.uniform(0.9, min(2.0, face.length - 0.8))
    first = random.uniform(0.25, face.length - width - 0.25) if not glazed else 0.3
    opening = LineString([face.interpolate(first), face.interpolate(first + width)])
    sill = 0.0 if glazed else random.choice([0.45, 0.9, 0.9])
    head = room.ceiling - 0.15 if glazed else WINDOW_HEAD
    void = _shifted(opening, outward, outer / 2).buffer(outer / 2 + 0.01, cap_style=2)
    openings.voids.append((void, sill, head))
    openings.lines += [opening, _shifted(opening, outward, outer)]
    pane = _shifted(opening, outward, 0.12).buffer(0.01, cap_style=2)
    openings.fillings.append(Prism(pane, head, sill, "glass", passing=0.85))
    room.windows.append(opening.buffer(0.7, cap_style=2))
    inner = _shifted(opening, outward, -0.12)
    if random.random() < 0.5:
        openings.fillings.append(curtain(random, inner, head + 0.15))
        room.taken.append(inner.buffer(0.1))
    elif not glazed:
        radiator = _shifted(opening, outward, -0.09).buffer(0.05, cap_style=2)
        openings.fillings.append(Prism(radiator, min(sill - 0.05, 0.7), 0.1, "furniture"))
        room.taken.append(radiator)


def _shifted(line: LineString, direction: tuple[int, int], distance: float) -> LineString:
    return LineString(np.asarray(line.coords) + distance * np.array(direction))
