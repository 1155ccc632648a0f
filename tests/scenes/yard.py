"""A walled yard on gently sloping ground, with a small house, trees and bushes."""

import numpy as np
from shapely.geometry import LineString, box

from .scene import Scene
from .shapes import block, bush, pierced, scanner_height, shell, standing, stretches, tree
from .things import Ground

THICKNESS = 0.4


def _enclosure(random: np.random.Generator, ground: Ground, width: float, depth: float):
    """Return the yard's wall in pieces, with a gate gap in the south."""
    gate = width * random.uniform(0.3, 0.45)
    opening = random.uniform(2.5, 3.5)
    axis = LineString([(gate + opening, 0), (width, 0), (width, depth), (0, depth), (0, 0), (gate, 0)])
    pieces = stretches(random, axis, THICKNESS, 4, 8)
    return [standing(piece, random.uniform(2.0, 2.5), ground) for piece in pieces]


def _house(random: np.random.Generator, ground: Ground, x: float, y: float):
    """Return a roofless shell with a door in the south and two windows."""
    width, depth = random.uniform(5.5, 7), random.uniform(4.5, 5.5)
    floor = ground.height(x, y)
    return pierced(
        [shell(box(x - width / 2, y - depth / 2, x + width / 2, y + depth / 2), THICKNESS)],
        [block(x + random.uniform(-1, 1), y - depth / 2, 1.0, 1.0)],
        [block(x - width / 2, y, 1.0, 1.2), block(x + width / 2, y, 1.0, 1.2)],
        floor + 3.5,
        floor,
    )


def yard(seed: int = 0) -> Scene:
    """Build a yard of about 30 x 25 m, scanned from inside and outside."""
    random = np.random.default_rng(seed)
    ground = Ground(random.uniform(0.01, 0.03), random.uniform(-0.03, -0.01), undulation=0.05)
    width, depth = random.uniform(28, 32), random.uniform(23, 27)
    prisms = _enclosure(random, ground, width, depth)
    house = width * 0.72, depth * 0.68
    prisms += _house(random, ground, *house)
    plants = []
    for x, y in ((6, depth - 6), (width - 6, 5), (-4, depth / 2), (width / 2, depth - 3)):
        trunk, crown = tree(random, ground, x + random.uniform(-1, 1), y + random.uniform(-1, 1))
        prisms.append(trunk)
        plants += crown
    along = random.uniform(0.2, 0.8, 4)
    by_the_wall = (
        (0.7, depth * along[0]),
        (width * along[1], depth - 0.7),
        (width + 0.8, depth * along[2]),
        (width * 0.2 * along[3], 0.8),
    )
    in_the_open = [(width * share, depth * 0.3) for share in (0.3, 0.6, 0.85)]
    for x, y in (*by_the_wall, *in_the_open):
        plants += bush(random, ground, x, y, random.uniform(0.7, 1.1))
    stations = (
        (width * 0.2, depth * 0.35),
        (width * 0.45, depth * 0.75),
        (width * 0.75, depth * 0.2),
        house,
        (width * 0.4, -9.0),
        (width + 9.0, depth * 0.5),
        (-9.0, depth * 0.75),
    )
    scanners = [(x, y, ground.height(x, y) + scanner_height(random)) for x, y in stations]
    return Scene("yard", tuple(prisms), np.array(scanners), ground, tuple(plants))
