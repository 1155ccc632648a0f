"""Low ruins on a slope: broken walls, two round towers, footings, rubble and bushes."""

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.ops import substring

from .scene import Scene
from .shapes import bush, disc, free_of, masonry, rubble, scanner_height, standing, stretches
from .things import Ground, Plant, Prism

# Axes of the walls, in a field of 36 x 28 m.
WALLS = (
    ((10, 8), (26, 8), (26, 20), (10, 20), (10, 9.5)),
    ((18, 8), (18, 20)),
    ((10, 14), (18, 14)),
    ((26, 14), (34, 14), (34, 6)),
    ((2, 12), (2, 4), (8, 2)),
)
FOOTINGS = (((20, 11), (25, 11)), ((12, 23), (22, 25)), ((28, 9), (31, 9), (31, 12)))
TOWERS = ((4.5, 20.0), (31.0, 21.0))
STATIONS = (
    *TOWERS,
    (14, 11),
    (14, 17),
    (22, 16.5),
    (22, 4),
    (30, 16.3),
    (6, 8),
    (15, 26),
    (37.5, 11),
    (25, 24.5),
)


def _broken_wall(random: np.random.Generator, ground: Ground, axis: LineString) -> list[Prism]:
    """Return pieces of differing heights, some with a gap between them."""
    thickness = random.uniform(0.5, 0.8)
    prisms = []
    start = 0.0
    while start < axis.length - 0.8:
        run = min(random.uniform(3, 7), axis.length - start)
        part = substring(axis, start, start + run)
        height = random.uniform(1.0, 1.7)
        for piece in stretches(random, part, thickness, 0.8, 2.0):
            height = np.clip(height + random.normal(0, 0.2), 0.85, 1.8)
            prisms.append(standing(piece, height, ground))
        start += run + random.choice([0.0, random.uniform(0.6, 1.5)])
    return prisms


def _sector(x: float, y: float, radius: float, start: float, stop: float) -> Polygon:
    """Return a sector of a disc, from `start` to `stop` (radians)."""
    turns = np.linspace(start, stop, 40)
    rim = np.column_stack([x + radius * np.cos(turns), y + radius * np.sin(turns)])
    return Polygon([(x, y), *rim])


def _tower(random: np.random.Generator, ground: Ground, x: float, y: float) -> list[Prism]:
    """Return a ring wall in sectors of differing heights, with a door gap."""
    inner = random.uniform(2.5, 4.0) - 0.35
    outer = inner + random.uniform(0.6, 0.8)
    ring = disc(x, y, outer, 128).difference(disc(x, y, inner, 128))
    door = random.uniform(0, 2 * np.pi)
    half_door = random.uniform(0.45, 0.6) / inner
    cuts = np.linspace(door + half_door, door + 2 * np.pi - half_door, 9)
    height = random.uniform(2.0, 3.5)
    prisms = []
    for start, stop in zip(cuts[:-1], cuts[1:]):
        height = np.clip(height + random.normal(0, 0.4), 1.5, 4.0)
        footprint = ring.intersection(_sector(x, y, 2 * outer, start, stop))
        prisms.append(standing(footprint, height, ground))
    return prisms


def _footing(random: np.random.Generator, axis) -> Prism:
    footprint = masonry(axis, random.uniform(0.5, 0.8))
    return Prism(footprint, random.uniform(0.05, 0.1), follows_ground=True)


def _scatter(random: np.random.Generator, ground: Ground, prisms: list[Prism]) -> list[Plant]:
    """Add rubble to `prisms`, and return bushes: some touch walls, all keep clear of scanners."""
    walls = [prism.footprint for prism in prisms]
    scanners = [disc(x, y, 1.8) for x, y in STATIONS]
    plants = []
    for _ in range(40):
        x, y = random.uniform((0, 0), (36, 28))
        if free_of(x, y, 0.6, walls + scanners):
            prisms.append(rubble(random, ground, x, y))
    for _ in range(20):
        x, y = random.uniform((-1, -1), (37, 29))
        if free_of(x, y, 0.0, walls + scanners):
            plants += bush(random, ground, x, y, random.uniform(0.4, 0.8))
    return plants


def ruins(seed: int = 0) -> Scene:
    """Build ruins of about 36 x 28 m on a slope of 6 to 10 %."""
    random = np.random.default_rng(seed)
    slope, downhill = random.uniform(0.06, 0.10), random.uniform(0, 2 * np.pi)
    ground = Ground(slope * np.cos(downhill), slope * np.sin(downhill), undulation=0.05)
    prisms = []
    for axis in WALLS:
        jittered = np.array(axis) + random.uniform(-0.3, 0.3, 2)
        prisms += _broken_wall(random, ground, LineString(jittered))
    for x, y in TOWERS:
        prisms += _tower(random, ground, x, y)
    prisms += [_footing(random, axis) for axis in FOOTINGS]
    plants = _scatter(random, ground, prisms)
    scanners = [(x, y, ground.height(x, y) + scanner_height(random)) for x, y in STATIONS]
    return Scene("ruins", tuple(prisms), np.array(scanners), ground, tuple(plants))
