"""A furnished flat: rooms of all sizes, doors with open leaves, windows with curtains, an unscanned core."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np
from shapely.geometry import LineString, Polygon, box
from shapely.ops import unary_union

from ..scene import Scene
from ..shapes import scanner_height
from ..things import Mirror, Prism
from .furniture import (
    Room,
    bed,
    bookcase,
    clutter,
    dining_table,
    furnish,
    kitchen,
    sofa,
    wardrobe,
)
from .openings import Openings, add_door, add_window, walls_with

CEILING = 2.7
OUTER = 0.35
LARGEST = 18.0
NARROWEST = 1.7
SETS = (
    (kitchen, dining_table),
    (bed, wardrobe, bookcase),
    (sofa, bookcase, dining_table),
    (wardrobe, clutter),
    (bookcase, bookcase, clutter),
)


def flat(seed: int = 0) -> Scene:
    """Build a flat of four to nine rooms, turned by some degrees."""
    random = np.random.default_rng(seed)
    outline = box(0, 0, random.uniform(9, 13), random.uniform(7, 10))
    spaces = list(_split(random, outline))
    core = _core(random, spaces)
    rooms = [Room(space, CEILING) for number, space in enumerate(spaces) if number != core]
    openings = Openings()
    for one, other, wall in _doors(random, rooms):
        add_door(random, openings, one, other, wall)
    for room in rooms:
        add_window(random, openings, room, outline, OUTER)
    furniture = [prism for room in rooms for prism in _furniture(random, room)]
    mirrors = _mirrors(random, rooms)
    solid = outline.buffer(OUTER, join_style=2).difference(unary_union(spaces))
    prisms = (*walls_with(solid, openings.voids, CEILING), *openings.fillings, *furniture)
    slab = Prism(outline.buffer(OUTER, join_style=2), CEILING + 0.25, CEILING, "slab")
    glasses = [_mirror_body(mirror) for mirror in mirrors]
    return Scene(
        "flat",
        (*prisms, *glasses, slab),
        _stations(random, rooms),
        mirrors=tuple(mirrors),
        local_rooms=tuple(room.inside for room in rooms),
        local_openings=tuple(openings.lines),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))


def _split(random: np.random.Generator, space: Polygon) -> Iterator[Polygon]:
    """Yield the rooms of a space, parted by partitions until they are small enough."""
    west, south, east, north = space.bounds
    wide = east - west >= north - south
    longer = max(east - west, north - south)
    if space.area < random.uniform(0.5, 1.0) * LARGEST or longer < 2 * NARROWEST + 0.2:
        yield space
        return
    thickness = random.choice([0.1, 0.12, 0.15, 0.24])
    low, high = (NARROWEST, longer - NARROWEST - thickness)
    cut = np.clip(longer * random.uniform(0.3, 0.7), low, high)
    if wide:
        halves = box(west, south, west + cut, north), box(west + cut + thickness, south, east, north)
    else:
        halves = box(west, south, east, south + cut), box(west, south + cut + thickness, east, north)
    for half in halves:
        yield from _split(random, half)


def _core(random: np.random.Generator, spaces: list[Polygon]) -> int:
    """Return the room that was never entered: the smallest, where the others stay connected."""
    if len(spaces) < 5:
        return -1
    for number in sorted(range(len(spaces)), key=lambda number: spaces[number].area):
        others = [space for other, space in enumerate(spaces) if other != number]
        if len(_tree(random, others)) == len(others) - 1:
            return number
    return -1


def _shared(one: Polygon, other: Polygon) -> Polygon:
    """Return the piece of partition between two rooms; empty if they have none in common."""
    (a, b, c, d), (e, f, g, h) = one.bounds, other.bounds
    for low, high, start, stop, upright in (
        (c, e, max(b, f), min(d, h), True),
        (g, a, max(b, f), min(d, h), True),
        (d, f, max(a, e), min(c, g), False),
        (h, b, max(a, e), min(c, g), False),
    ):
        if 0 < high - low < 0.3 and stop - start > 1.5:
            return box(low, start, high, stop) if upright else box(start, low, stop, high)
    return Polygon()


def _tree(random: np.random.Generator, spaces: list[Polygon]) -> list[tuple[int, int]]:
    """Return pairs of rooms that doors connect, as few as needed."""
    pairs = [
        pair for pair in combinations(range(len(spaces)), 2) if _shared(*(spaces[i] for i in pair)).area > 0
    ]
    group = list(range(len(spaces)))
    chosen = []
    for one, other in random.permutation(np.array(pairs).reshape(-1, 2)).tolist():
        if group[one] != group[other]:
            group = [group[one] if item == group[other] else item for item in group]
            chosen.append((one, other))
    return chosen


def _doors(random: np.random.Generator, rooms: list[Room]) -> Iterator[tuple[Room, Room, Polygon]]:
    for one, other in _tree(random, [room.inside for room in rooms]):
        yield rooms[one], rooms[other], _shared(rooms[one].inside, rooms[other].inside)


def _furniture(random: np.random.Generator, room: Room) -> list[Prism]:
    return furnish(random, room, SETS[random.integers(len(SETS))])


def _mirrors(random: np.random.Generator, rooms: list[Room]) -> list[Mirror]:
    """Return a mirror on a wall of one room."""
    room = rooms[random.integers(len(rooms))]
    mirrors = []
    for footprint in room.along_wall(random, random.uniform(0.5, 1.1), 0.02, 0.0, high=True):
        corners = list(footprint.exterior.coords)
        sides = [pair for pair in zip(corners, corners[1:]) if LineString(pair).length > 0.1]
        start, end = max(sides, key=lambda pair: room.inside.exterior.distance(LineString(pair).centroid))
        # The room is on the left of the front.
        middle, along = room.inside.centroid, np.subtract(end, start)
        on_left = along[0] * (middle.y - start[1]) - along[1] * (middle.x - start[0]) > 0
        mirrors.append(Mirror(*((start, end) if on_left else (end, start)), 0.5, 1.9))
    return mirrors


def _mirror_body(mirror: Mirror) -> Prism:
    footprint = LineString([mirror.start, mirror.end]).buffer(0.02, cap_style=2, single_sided=False)
    behind = LineString([mirror.start, mirror.end]).parallel_offset(0.01, "right")
    return Prism(
        behind.buffer(0.01, cap_style=2).intersection(footprint), mirror.top, mirror.bottom, "mirror"
    )


def _stations(random: np.random.Generator, rooms: list[Room]) -> np.ndarray:
    """Return a station in every room, two in large ones."""
    stations = [
        (*room.station(random), scanner_height(random))
        for room in rooms
        for _ in range(2 if room.inside.area > 12 else 1)
    ]
    return np.array(stations)
