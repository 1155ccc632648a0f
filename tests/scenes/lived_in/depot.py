"""A depot: two high halls, a cell with its own ceiling in a corner, a gate, benches and tall cupboards."""

import numpy as np
from shapely.geometry import LineString, box

from ..scene import Scene
from ..shapes import DOOR_HEAD, scanner_height
from ..things import Prism
from .furniture import Room, clutter, dining_table, door_leaf, furnish, machine, wardrobe, workstation
from .openings import Openings, add_door, walls_with

OUTER = 0.3
THINGS = (wardrobe, wardrobe, workstation, workstation, machine, dining_table, clutter)


def depot(seed: int = 0) -> Scene:
    """Build two halls about 4 m high; the walls of the cell end over its lid."""
    random = np.random.default_rng(seed)
    ceiling = random.uniform(3.8, 4.6)
    length, depth, north = random.uniform(9, 12), random.uniform(6, 8), random.uniform(4, 5)
    between = random.choice([0.15, 0.2, 0.25])
    south_hall, north_hall = (
        box(0, 0, length, depth),
        box(0, depth + between, length - 1.5, depth + between + north),
    )
    halls = [Room(south_hall, ceiling), Room(north_hall, ceiling)]
    openings = Openings()
    wall = box(4.0, depth, length - 1.5, depth + between)
    add_door(random, openings, halls[1], halls[0], wall)
    gate = box(length - 0.01, 1.2, length + OUTER + 0.01, 1.2 + random.uniform(2.6, 3.8))
    openings.voids.append((gate, 0.0, 3.0))
    openings.lines += [
        LineString([(x, gate.bounds[1]), (x, gate.bounds[3])]) for x in (length, length + OUTER)
    ]
    halls[0].doorways.append(gate.buffer(1.0))
    cell, shell, lid, leaf, mouth = _cell(random, depth)
    halls[0].taken.append(shell.buffer(0.02))
    halls[0].doorways.append(mouth.buffer(0.9))
    openings.lines += [
        LineString([(x, mouth.bounds[1]), (x, mouth.bounds[3])]) for x in (mouth.bounds[0], mouth.bounds[2])
    ]
    around = south_hall.union(north_hall).union(wall).buffer(OUTER, join_style=2)
    solid = around.difference(south_hall.union(north_hall))
    furniture = [prism for hall in halls for prism in furnish(random, hall, THINGS)]
    roofs = [Prism(hall.inside, ceiling + 0.25, ceiling, "slab") for hall in halls]
    stations = [(*hall.station(random), scanner_height(random)) for hall in halls for _ in range(3)]
    stations.append((cell.centroid.x, cell.centroid.y, scanner_height(random)))
    return Scene(
        "depot",
        (
            *walls_with(solid, openings.voids, ceiling),
            *openings.fillings,
            *walls_with(shell.difference(cell), [(mouth, 0.0, DOOR_HEAD)], lid + 0.25),
            Prism(cell, lid + 0.25, lid, "slab"),
            leaf,
            *furniture,
            *roofs,
        ),
        np.array(stations),
        local_rooms=(south_hall.difference(shell), north_hall, cell),
        local_openings=tuple(openings.lines),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))


def _cell(random: np.random.Generator, depth: float):
    """Return a cell in the north-west corner of the south hall: inside, outside, lid, leaf and door."""
    width, height, thickness = random.uniform(1.6, 2.6), random.uniform(1.7, 2.6), random.choice([0.1, 0.13])
    cell = box(0, depth - height, width, depth)
    shell = box(0, depth - height - thickness, width + thickness, depth)
    start = depth - height + random.uniform(0.15, height - 1.1)
    mouth = box(width, start, width + thickness, start + 0.85)
    leaf = door_leaf((width + thickness, start), 0.83, random.uniform(-60, -20), DOOR_HEAD)
    return cell, shell, random.uniform(2.35, 2.5), leaf, mouth
