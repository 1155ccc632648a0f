"""An office floor: thin partitions along a corridor, ceilings of several heights, desks with screens."""

import numpy as np
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from ..scene import Scene
from ..shapes import block, scanner_height
from ..things import Prism
from .furniture import Room, bookcase, clutter, dining_table, furnish, wardrobe, workstation
from .openings import Openings, add_door, add_window, walls_with

SLAB = 3.0
"""Walls reach the slab, ceilings hang below it, metres."""

CEILINGS = (2.3, 2.3, 2.35, 2.5, 2.7)
OUTER = 0.3
THINNED = 0.07
SETS = (
    (workstation, workstation, wardrobe, clutter),
    (workstation, workstation, workstation, bookcase),
    (dining_table, wardrobe, bookcase),
    (workstation, bookcase, bookcase),
)


def office(seed: int = 0) -> Scene:
    """Build a floor of six to eight rooms and a corridor; its cloud is thinned."""
    random = np.random.default_rng(seed)
    partition = random.choice([0.08, 0.1, 0.12])
    length, corridor = random.uniform(12.0, 17.0), random.uniform(1.6, 2.1)
    south, north = random.uniform(3.6, 5.0, 2)
    first, second = south + partition, south + partition + corridor
    outline = box(0, 0, length, second + partition + north)
    hall = box(0, first, length, second)
    rows = [
        _row(random, length, partition, 0, south),
        _row(random, length, partition, second + partition, outline.bounds[3]),
    ]
    spaces = [hall, *rows[0], *rows[1]]
    piers = [pier for row, y in zip(rows, (0, outline.bounds[3])) for pier in _piers(row, y, partition)]
    rooms = [Room(space, random.choice(CEILINGS)) for space in spaces]
    for room in rooms:
        room.taken += [pier.buffer(0.02) for pier in piers if pier.intersects(room.inside)]
    columns = [column for room in rooms[1:] for column in _column(random, room)]
    openings = Openings()
    for room in rooms[1:]:
        below = room.inside.bounds[1] < first
        west, low, east, high = room.inside.bounds
        wall = box(west, high, east, first) if below else box(west, second, east, low)
        add_door(random, openings, room, rooms[0], wall)
        add_window(random, openings, room, outline, OUTER)
    furniture = [
        prism for room in rooms[1:] for prism in furnish(random, room, SETS[random.integers(len(SETS))])
    ]
    solid = unary_union(
        [outline.buffer(OUTER, join_style=2).difference(unary_union(spaces)), *piers, *columns]
    )
    ceilings = [Prism(room.inside.difference(solid), SLAB, room.ceiling, "slab") for room in rooms]
    stations = [
        (*room.station(random), scanner_height(random))
        for room in rooms
        for _ in range(2 if room.inside.area > 12 else 1)
    ]
    return Scene(
        "office",
        (*walls_with(solid, openings.voids, SLAB), *openings.fillings, *furniture, *ceilings),
        np.array(stations),
        thinned=THINNED,
        local_rooms=tuple(room.inside.difference(unary_union(piers)) for room in rooms),
        local_openings=tuple(openings.lines),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))


def _row(
    random: np.random.Generator, length: float, partition: float, south: float, north: float
) -> list[Polygon]:
    """Return the rooms of a row, from west to east."""
    count = int(random.integers(3, 5)) if length > 13.5 else 3
    shares = random.uniform(0.7, 1.3, count)
    widths = (length - (count - 1) * partition) * shares / shares.sum()
    starts = np.concatenate([[0.0], np.cumsum(widths + partition)[:-1]])
    return [box(start, south, start + width, north) for start, width in zip(starts, widths)]


def _piers(row: list[Polygon], y: float, partition: float) -> list[Polygon]:
    """Return piers of the outer wall where partitions meet it."""
    return [block(room.bounds[2] + partition / 2, y, 0.4, 0.3) for room in row[:-1]]


def _column(random: np.random.Generator, room: Room) -> list[Polygon]:
    """Return a column in a large room."""
    west, south, east, north = room.inside.bounds
    if east - west < 4.5 or north - south < 4.0:
        return []
    column = block((west + east) / 2, (south + north) / 2, 0.25, random.uniform(0.25, 0.45))
    room.taken.append(column.buffer(0.15))
    return [column]
