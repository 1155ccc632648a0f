"""A workshop: a high hall with machines, a boat, shelves and steel columns."""

import numpy as np
from shapely.geometry import LineString, box

from ..scene import Scene
from ..shapes import block, scanner_height
from ..things import Prism
from .furniture import Room, boat, clutter, furnish, machine, wardrobe
from .openings import walls_with

CEILING = 4.8
OUTER = 0.3
GATE = 3.0


def workshop(seed: int = 0) -> Scene:
    """Build a hall with two rows of machines."""
    random = np.random.default_rng(seed)
    length, depth = random.uniform(16, 22), random.uniform(10, 13)
    inside = box(0, 0, length, depth)
    room = Room(inside, CEILING)
    gate = box(-OUTER - 0.01, depth / 2 - GATE / 2, 0.01, depth / 2 + GATE / 2)
    lines = [LineString([(x, depth / 2 - GATE / 2), (x, depth / 2 + GATE / 2)]) for x in (0.0, -OUTER)]
    voids = [(gate, 0.0, 3.2)]
    room.doorways.append(gate.buffer(1.5))
    for x in np.arange(2.5, length - 2.0, 4.0):
        window = box(x - 0.9, depth - 0.01, x + 0.9, depth + OUTER + 0.01)
        voids.append((window, 1.4, 3.2))
        lines += [LineString([(x - 0.9, y), (x + 0.9, y)]) for y in (depth, depth + OUTER)]
    columns = [Prism(block(x, depth / 2, 0.2, 0.2), CEILING) for x in np.arange(4.0, length - 2.0, 5.0)]
    room.taken += [column.footprint.buffer(0.3) for column in columns]
    things = (boat, machine, machine, machine, machine, wardrobe, wardrobe, wardrobe, clutter, clutter)
    furniture = furnish(random, room, things)
    solid = inside.buffer(OUTER, join_style=2).difference(inside)
    beams = [
        Prism(block(x, depth / 2, 0.25, depth), CEILING, CEILING - 0.5, "slab")
        for x in np.arange(2.0, length, 4.0)
    ]
    ceiling = Prism(inside.buffer(OUTER, join_style=2), CEILING + 0.25, CEILING, "slab")
    stations = np.array([(*room.station(random), scanner_height(random)) for _ in range(6)])
    return Scene(
        "workshop",
        (*walls_with(solid, voids, CEILING), *columns, *furniture, *beams, ceiling),
        stations,
        local_rooms=(inside,),
        local_openings=tuple(lines),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))
