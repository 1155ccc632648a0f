"""A hall with free columns, corner walls and an oblique wall."""

import numpy as np
from shapely.geometry import box

from .scene import Scene
from .shapes import block, disc, masonry, pierced, scanner_height, shell
from .things import Prism

CEILING = 4.0
OUTER = 0.4
WIDTH, DEPTH = 20.0, 14.0


def columns(seed: int = 0) -> Scene:
    """Build a hall of 20 x 14 m with twelve square and round columns."""
    random = np.random.default_rng(seed)
    outline = box(0, 0, WIDTH, DEPTH)
    walls = [shell(outline, OUTER)]
    for x, y, east, north in ((3, 2, 1, 1), (17, 12, -1, -1)):
        leg = random.uniform(1.2, 2.0, 2)
        axis = [(x + east * leg[0], y), (x, y), (x, y + north * leg[1])]
        walls.append(masonry(axis, random.uniform(0.2, 0.3)))
    walls.append(masonry([(0, 9 + random.uniform(-0.5, 0.5)), (5.2, DEPTH)], 0.25))
    doors = [block(WIDTH * random.uniform(0.4, 0.6), 0, 1.5, 1.0)]
    windows = [block(WIDTH, DEPTH * share, 1.0, 1.5) for share in (0.3, 0.6)]
    free = []
    for number, (x, y) in enumerate((x, y) for x in (6, 9, 12, 15) for y in (3.5, 7.0, 10.5)):
        east, north = random.uniform(-0.15, 0.15, 2)
        size = random.uniform(0.4, 0.6)
        angle = random.choice([0.0, 0.0, 20.0])
        square = block(x + east, y + north, size, size, angle)
        free.append(disc(x + east, y + north, size / 2, 48) if number % 4 == 1 else square)
    stations = [(4, 5), (7.5, 9), (10.5, 5), (13.5, 9), (16.5, 5), (1.2, 12.5)]
    jitter = random.uniform(-0.3, 0.3, (len(stations), 2))
    scanners = [(*place, scanner_height(random)) for place in stations + jitter]
    ceiling = Prism(outline.buffer(OUTER / 2, join_style=2), CEILING + 0.3, CEILING, "slab")
    prisms = pierced(walls, doors, windows, CEILING)
    prisms += [Prism(footprint, CEILING) for footprint in free]
    return Scene("columns", (*prisms, ceiling), np.array(scanners))
