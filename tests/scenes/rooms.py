"""Furnished rooms under beams, rotated against the axes, with far reflections."""

import numpy as np
from shapely.geometry import box

from .scene import Scene
from .shapes import block, masonry, pierced, scanner_height, shell, table
from .things import Prism

CEILING = 3.0
OUTER = 0.3
GHOSTS = 1e-4


def _furniture(random: np.random.Generator, room) -> list[Prism]:
    """Return a table, cupboards in the outer corners and a shelf on the inner wall.

    `room` is left, right, inner and outer: the axes of the walls around it.
    """
    left, right, inner, outer = room
    out = np.sign(outer - inner)
    prisms = table((left + right) / 2, (inner + outer) / 2, random.uniform(1.4, 1.8), 0.8)
    for x in (left + 0.5, right - 0.5):
        depth, width = random.uniform(0.4, 0.6), random.uniform(0.9, 1.3)
        gap = random.uniform(0.0, 0.03)
        y = outer - out * (OUTER / 2 + gap + width / 2)
        footprint = block(x, y, depth, width)
        prisms.append(Prism(footprint, random.uniform(1.7, 2.1), material="furniture"))
    shelf = block((left + right) / 2 + 0.4, inner + out * 0.27, random.uniform(1.2, 1.8), 0.35)
    prisms.append(Prism(shelf, random.uniform(2.0, 2.3), material="furniture"))
    return prisms


def _floor_grid(left: float, right: float, south: float, north: float) -> list[Prism]:
    """Return the stringers of an unfinished raised floor."""
    across = [masonry([(x, south), (x, north)], 0.03) for x in np.arange(left, right, 0.6)]
    along = [masonry([(left, y), (right, y)], 0.03) for y in np.arange(south, north, 0.6)]
    return [Prism(stringer, 0.15, 0.12, "furniture") for stringer in across + along]


def rooms(seed: int = 0) -> Scene:
    """Build six rooms in two rows, rotated by 28 degrees."""
    random = np.random.default_rng(seed)
    cuts = np.concatenate([[0], np.cumsum(random.uniform(4.5, 6.5, 3))])
    middle = random.uniform(4.5, 5.5)
    depth = middle + random.uniform(4.5, 5.5)
    outline = box(0, 0, cuts[-1], depth)
    walls = [shell(outline, OUTER), masonry([(0, middle), (cuts[-1], middle)], 0.15)]
    doors = [block(cuts[0] + 1.2, middle, 0.9, 0.8), block(cuts[2] + 1.2, middle, 0.9, 0.8)]
    windows, furniture, beams, stations = [], [], [], []
    for outer in (0.0, depth):
        out = np.sign(outer - middle)
        for cut in cuts[1:-1]:
            walls.append(masonry([(cut, middle), (cut, outer)], random.uniform(0.1, 0.2)))
            doors.append(block(cut, middle + out * 1.2, 0.8, 0.9))
        for left, right in zip(cuts[:-1], cuts[1:]):
            windows.append(block((left + right) / 2, outer, random.uniform(1.2, 1.8), 0.8))
            furniture += _furniture(random, (left, right, middle, outer))
            share = random.uniform(0.25, 0.3, 2)
            stations.append((left + share[0] * (right - left), middle - share[1] * (middle - outer)))
            if right - left > 5.5:
                stations.append((right - 1.3, outer - out * 1.9))
    for x in np.arange(1.5, cuts[-1], 2.0):
        footprint = block(x, depth / 2, 0.2, depth - OUTER)
        beams.append(Prism(footprint, CEILING, random.uniform(2.6, 2.75), "slab"))
    grid = _floor_grid(cuts[1] + 0.4, cuts[2] - 0.4, 0.4, middle - 0.4)
    ceiling = Prism(outline.buffer(OUTER / 2, join_style=2), CEILING + 0.25, CEILING, "slab")
    scanners = np.array([(x, y, scanner_height(random)) for x, y in stations])
    prisms = (*pierced(walls, doors, windows, CEILING), *furniture, *beams, *grid, ceiling)
    return Scene("rooms", prisms, scanners, ghosts=GHOSTS).moved(28.0, (0.0, 0.0, 0.0))
