"""A loft: one large room under an open roof, with a glazed front, columns, desks and shelves."""

import numpy as np
from shapely.geometry import LineString, box

from ..scene import Scene
from ..shapes import DOOR_HEAD, block, disc, scanner_height
from ..things import Prism
from .furniture import Room, bookcase, clutter, curtain, dining_table, furnish, wardrobe
from .openings import walls_with

TOP = 3.6
OUTER = 0.4


def loft(seed: int = 0) -> Scene:
    """Build a loft whose ceiling no scan shows."""
    random = np.random.default_rng(seed)
    length, depth = random.uniform(11, 15), random.uniform(7, 9)
    inside = box(0, 0, length, depth)
    room = Room(inside, TOP)
    solid = inside.buffer(OUTER, join_style=2).difference(inside)
    front = LineString([(1.0, 0.0), (length - 1.0, 0.0)])
    glazing = box(1.0, -OUTER - 0.01, length - 1.0, 0.01)
    door = box(length - 0.01, 2.0, length + OUTER + 0.01, 3.0)
    voids = [(glazing, 0.0, 2.9), (door, 0.0, DOOR_HEAD)]
    room.doorways.append(door.buffer(0.8))
    room.windows.append(front.buffer(0.7))
    columns = [
        Prism(footprint, TOP)
        for x in np.arange(3.0, length - 1.5, 3.5)
        for footprint in (
            [disc(x, depth / 2, 0.15)] if random.random() < 0.5 else [block(x, depth / 2, 0.3, 0.3)]
        )
    ]
    room.taken += [column.footprint.buffer(0.2) for column in columns]
    pane = Prism(box(1.0, -0.22, length - 1.0, -0.2), 2.9, 0.0, "glass", passing=0.85)
    cloth = curtain(random, LineString([(1.0, 0.12), (3.5, 0.12)]), 3.0)
    things = (bookcase, bookcase, wardrobe, dining_table, dining_table, clutter)
    furniture = furnish(random, room, things)
    stations = np.array([(*room.station(random), scanner_height(random)) for _ in range(4)])
    return Scene(
        "loft",
        (*walls_with(solid, voids, TOP), *columns, pane, cloth, *furniture),
        stations,
        local_rooms=(inside,),
        local_openings=(
            front,
            LineString([(1.0, -OUTER), (length - 1.0, -OUTER)]),
            LineString([(length, 2.0), (length, 3.0)]),
            LineString([(length + OUTER, 2.0), (length + OUTER, 3.0)]),
        ),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))
