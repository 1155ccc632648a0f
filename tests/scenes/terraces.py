"""Two terraces on rising ground: rubble masonry, a plastered house that leans, people, bushes at walls."""

from dataclasses import replace

import numpy as np
from shapely.geometry import LineString, box

from .scene import Scene
from .shapes import block, bush, masonry, person, pierced, scanner_height, shell, standing, stretches
from .things import Ground, Prism

WIDTH, DEPTH = 26.0, 20.0
STEP_AT = 10.0
"""The y at which the upper terrace begins (m)."""


def _rubble_wall(random: np.random.Generator, ground: Ground, axis, thickness: float) -> list[Prism]:
    """Return a wall of rough masonry, in pieces of differing heights."""
    relief = random.uniform(0.015, 0.025)
    pieces = stretches(random, LineString(axis), thickness, 3, 6)
    return [replace(standing(piece, random.uniform(1.7, 2.3), ground), relief=relief) for piece in pieces]


def _house(random: np.random.Generator, ground: Ground, x: float, y: float) -> list[Prism]:
    """Return a roofless shell of plastered walls that lean by a degree, all to one side."""
    width, depth = random.uniform(6, 7), random.uniform(4.5, 5)
    floor = ground.height(x, y)
    prisms = pierced(
        [
            shell(box(x - width / 2, y - depth / 2, x + width / 2, y + depth / 2), 0.45),
            masonry([(x - 0.5, y - depth / 2), (x - 0.5, y + depth / 2)], 0.2),
        ],
        [block(x - width / 4, y - depth / 2, 1.0, 1.0), block(x - 0.5, y + random.uniform(-1, 1), 0.8, 0.9)],
        [block(x + width / 4, y + depth / 2, 1.2, 1.0)],
        floor + 3.2,
        floor,
    )
    towards = random.uniform(0, 2 * np.pi)
    lean = tuple(np.tan(np.radians(1.0)) * np.array([np.cos(towards), np.sin(towards)]))
    return [replace(prism, lean=lean) for prism in prisms]


def terraces(seed: int = 0) -> Scene:
    """Build a court of about 26 x 20 m in two terraces, whose ground rises by 1 m, and by 1 m at the step."""
    random = np.random.default_rng(seed)
    towards = random.uniform(0, 2 * np.pi)
    slope = 1.0 / WIDTH
    ground = Ground(
        slope * np.cos(towards),
        slope * np.sin(towards),
        undulation=0.05,
        terrace=random.uniform(0.8, 1.1),
        terrace_from=STEP_AT,
    )
    gate = random.uniform(6, 10)
    outer, retaining = random.uniform(0.55, 0.8, 2)
    prisms = _rubble_wall(
        random, ground, [(gate + 3, 0), (WIDTH, 0), (WIDTH, DEPTH), (0, DEPTH), (0, 0), (gate, 0)], outer
    )
    stairs = random.uniform(11, 15)
    prisms += _rubble_wall(random, ground, [(outer / 2, STEP_AT), (stairs, STEP_AT)], retaining)
    prisms += _rubble_wall(random, ground, [(stairs + 2, STEP_AT), (WIDTH - outer / 2, STEP_AT)], retaining)
    house = WIDTH * 0.7, STEP_AT + 5.2
    prisms += _house(random, ground, *house)
    for x, y in ((3.5, 6.0), (gate + 1.2, 3.0), (WIDTH - 4.0, 6.5), (8.0, STEP_AT + 4.0), (0.9, 2.5)):
        prisms.append(person(ground, *(np.array([x, y]) + random.uniform(-0.2, 0.2, 2))))
    plants = []
    for x, y in (
        (1.0, 7.0),
        (WIDTH * 0.6, STEP_AT - 0.9),
        (6.0, DEPTH - 0.9),
        (WIDTH + 0.9, 5.0),
        (12.0, STEP_AT + 6.5),
    ):
        plants += bush(random, ground, x, y, random.uniform(0.5, 0.9))
    stations = (
        (5.0, 4.0),
        (13.0, 5.5),
        (21.0, 3.5),
        (4.5, STEP_AT + 5.0),
        (10.0, STEP_AT + 2.0),
        (house[0] + 1.5, house[1]),
        (house[0] - 2.0, house[1] + 0.6),
        (house[0], STEP_AT + 1.6),
        (house[0], DEPTH - 1.2),
        (WIDTH - 1.5, house[1]),
        (WIDTH / 2, -7.0),
        (WIDTH + 7.0, 12.0),
        (-7.0, 8.0),
        (WIDTH / 2, DEPTH + 7.0),
    )
    scanners = [(x, y, ground.height(x, y) + scanner_height(random)) for x, y in stations]
    return Scene("terraces", tuple(prisms), np.array(scanners), ground, tuple(plants))
