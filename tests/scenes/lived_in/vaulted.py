"""A vaulted hall: a barrel vault, half-columns along the walls, round columns, niches and a stair."""

import numpy as np
from shapely.geometry import LineString, box
from shapely.ops import unary_union

from ..scene import Scene
from ..shapes import DOOR_HEAD, disc, polygons, scanner_height
from ..things import Prism

SPRING = 2.6
OUTER = 0.6
BAND = 0.1
"""Width of the bands that the vault is made of, metres."""


def vaulted(seed: int = 0) -> Scene:
    """Build a hall of three to five bays."""
    random = np.random.default_rng(seed)
    bays, bay = random.integers(3, 6), random.uniform(3.0, 3.8)
    width, length = random.uniform(5.0, 6.5), float(bays * bay)
    inside = box(0, 0, length, width)
    radius = random.uniform(0.2, 0.3)
    stations = np.arange(1, bays) * bay
    half_columns = [disc(x, y, radius) for x in stations for y in (0.0, width)]
    niche = random.uniform(0.5, 0.8)
    niches = [disc(x - bay / 2, width, niche) for x in (*stations, length)]
    columns = [disc(x, width / 2, random.uniform(0.18, 0.28)) for x in stations]
    open_space = unary_union([inside, *niches])
    walls = inside.buffer(OUTER + niche, join_style=2).difference(open_space)
    solid = unary_union([walls, *half_columns])
    door = box(-OUTER - niche - 0.01, width / 2 - 0.6, 0.01, width / 2 + 0.6)
    top = SPRING + width / 2 + 0.3
    prisms = [Prism(part, top) for part in polygons(solid.difference(door))]
    prisms += [Prism(part, top, DOOR_HEAD, "lintel") for part in polygons(solid.intersection(door))]
    # Above a niche the wall continues.
    prisms += [Prism(part.difference(inside), top, 2.2, "lintel") for part in niches]
    prisms += [Prism(column, SPRING + 1.0) for column in columns]
    prisms += _vault(length, width, top) + _stair(length, width)
    scanners = [
        (x - bay / 2, width * random.uniform(0.25, 0.4), scanner_height(random)) for x in (*stations, length)
    ]
    scanners.append((length / 2, width * 0.75, scanner_height(random)))
    room = open_space.difference(unary_union(half_columns))
    return Scene(
        "vaulted",
        tuple(prisms),
        np.array(scanners),
        local_rooms=(max(polygons(room), key=lambda part: part.area),),
        local_openings=(LineString([(0.0, width / 2 - 0.6), (0.0, width / 2 + 0.6)]),),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))


def _vault(length: float, width: float, top: float) -> list[Prism]:
    """Return a barrel vault as level bands."""
    edges = np.arange(0, width + BAND / 2, BAND)
    middles = (edges[:-1] + edges[1:]) / 2
    heights = SPRING + np.sqrt(np.maximum((width / 2) ** 2 - (middles - width / 2) ** 2, 0))
    bands = zip(edges[:-1], edges[1:], heights)
    return [Prism(box(0, south, length, north), top, height, "slab") for south, north, height in bands]


def _stair(length: float, width: float) -> list[Prism]:
    """Return a straight flight along the end wall."""
    return [
        Prism(
            box(length - 1.2, 0.4 + 0.28 * step, length, 0.68 + 0.28 * step),
            0.17 * (step + 1),
            material="slab",
        )
        for step in range(min(8, int((width - 1.0) / 0.28)))
    ]
