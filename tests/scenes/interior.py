"""A clean interior: rooms on both sides of a corridor, also scanned from outside."""

import numpy as np
from shapely.geometry import Polygon, box

from .scene import Scene
from .shapes import block, masonry, pierced, scanner_height, shell
from .things import Prism

CEILING = 2.8
OUTER = 0.35


def _dividers(random: np.random.Generator, length: float, rooms: int) -> np.ndarray:
    """Return the limits of the rooms of a row."""
    even = np.linspace(0, length, rooms + 1)
    even[1:-1] += random.uniform(-0.5, 0.5, rooms - 1)
    return even


def interior(seed: int = 0) -> Scene:
    """Build five to seven rooms and a corridor under one ceiling."""
    random = np.random.default_rng(seed)
    length = random.uniform(14, 17)
    south = random.uniform(4, 5)
    north = south + random.uniform(1.8, 2.2)
    depth = north + random.uniform(4, 5)
    outline = box(0, 0, length, depth)
    walls = [shell(outline, OUTER)]
    doors = [block(0, (south + north) / 2, 0.8, 1.2)]
    windows = []
    stations = [(length / 2, (south + north) / 2)]
    for rooms, inner, outer in ((random.integers(2, 5), south, 0.0), (3, north, depth)):
        walls.append(masonry([(0, inner), (length, inner)], random.uniform(0.18, 0.25)))
        cuts = _dividers(random, length, rooms)
        walls += [masonry([(cut, inner), (cut, outer)], random.uniform(0.12, 0.16)) for cut in cuts[1:-1]]
        for left, right in zip(cuts[:-1], cuts[1:]):
            middle = (left + right) / 2
            door = random.uniform(left + 0.9, right - 0.9)
            doors.append(block(door, inner, random.uniform(0.85, 1.0), 0.8))
            windows.append(block(middle, outer, random.uniform(1.2, 1.8), 0.8))
            east, north = random.uniform(-0.3, 0.3, 2)
            stations.append((middle + east, (inner + outer) / 2 + north))
    stations += [
        (-7.0, depth / 2 + 1),
        (length + 7.0, depth / 2 - 1),
        (length / 2, -8.0),
        (length / 2, depth + 8.0),
    ]
    ceiling = Prism(_outer_edge(outline), CEILING + 0.25, CEILING, "slab")
    scanners = np.array([(x, y, scanner_height(random)) for x, y in stations])
    prisms = (*pierced(walls, doors, windows, CEILING), ceiling)
    return Scene("interior", prisms, scanners)


def _outer_edge(outline: Polygon) -> Polygon:
    return outline.buffer(OUTER / 2, join_style=2)
