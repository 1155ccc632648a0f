"""A storey of a terraced house: chimney breasts, a flight through the ceiling, a round corner."""

import numpy as np
from shapely.geometry import LineString, Polygon, box
from shapely.ops import unary_union

from ..scene import Scene
from ..shapes import DOOR_HEAD, block, disc, scanner_height
from ..things import Prism
from .furniture import Room, bookcase, clutter, dining_table, furnish, kitchen, sofa, wardrobe
from .openings import Openings, add_door, add_window, walls_with

CEILING = 2.7
FLOOR_ABOVE = 2.95
ROOF = 5.4
OUTER = 0.35
PARTITION = 0.12
HEARTH = 0.95
RISE, GOING, FLIGHT = 0.18, 0.26, 0.85
OPEN_STEPS = 7
"""So many steps are solid; under the others, a panel that rises above the cut hides a closet."""


def terraced_house(seed: int = 0) -> Scene:
    """Build the front and the back room of a house, with the hall and its stair beside them."""
    random = np.random.default_rng(seed)
    width, length = random.uniform(5.4, 6.6), random.uniform(9.5, 11.5)
    side, middle, radius = 1.95, length * random.uniform(0.42, 0.52), random.uniform(1.0, 1.7)
    west = side + PARTITION
    corner, round_corner = _corner(width, length, radius)
    outline = box(0, 0, width, length).difference(corner)
    hall = box(0, 0, side, length)
    front = Room(box(west, 0, width, middle), CEILING)
    back = Room(box(west, middle + PARTITION, width, length), CEILING)
    breasts = [_breast(random, room.inside) for room in (front, back)]
    openings = Openings()
    add_door(random, openings, back, front, box(west, middle, width - 0.6, middle + PARTITION))
    lobby = Room(hall, CEILING)
    add_door(random, openings, front, lobby, box(side, 0.3, west, middle - 0.3))
    add_door(random, openings, back, lobby, box(side, middle + 0.5, west, length - radius))
    for room, breast in zip((front, back), breasts):
        room.taken.append(breast.buffer(0.05))
    back.taken.append(corner.buffer(0.2))
    add_window(random, openings, front, box(-9, 0, width + 9, length + 9), OUTER)
    _round_window(openings, round_corner)
    _front_door(openings)
    spaces = unary_union([hall, front.inside, back.inside]).difference(corner)
    rooms = tuple(room.inside.difference(unary_union([corner, *breasts])) for room in (front, back))
    solid = unary_union([outline.buffer(OUTER, join_style=2).difference(spaces), *breasts])
    hearths = [_hearth(breast) for breast in breasts]
    flight, well = _flight()
    openings.voids += [(hearth, 0.0, HEARTH) for hearth in hearths]
    walls = [_over_hearth(prism, hearths) for prism in walls_with(solid, openings.voids, CEILING)]
    sets = ((sofa, bookcase, dining_table, clutter), (kitchen, dining_table, wardrobe))
    furniture = [
        prism for room, things in zip((front, back), sets) for prism in furnish(random, room, things)
    ]
    shell = outline.buffer(OUTER, join_style=2)
    above = [
        Prism(shell.difference(outline), ROOF, CEILING, "lintel"),
        Prism(shell, ROOF + 0.2, ROOF, "slab"),
    ]
    stations = [(*room.station(random), scanner_height(random)) for room in (front, front, back, back)]
    stations += [(1.4, y, scanner_height(random)) for y in (0.9, 4.6, length - 1.0)]
    return Scene(
        "terraced_house",
        (
            *walls,
            *openings.fillings,
            *flight,
            *furniture,
            Prism(outline.difference(well), FLOOR_ABOVE, CEILING, "slab"),
            *above,
        ),
        np.array(stations),
        local_rooms=rooms,
        local_doubtful_rooms=(hall,),
        local_openings=tuple(openings.lines),
    ).moved(random.uniform(0, 90), (0.0, 0.0, 0.0))


def _corner(width: float, length: float, radius: float) -> tuple[Polygon, tuple[float, float, float]]:
    """Return what a round corner takes from a rectangle, and its circle: x, y, radius."""
    x, y = width - radius, length - radius
    return box(x, y, width, length).difference(disc(x, y, radius, 96)), (x, y, radius)


def _breast(random: np.random.Generator, room: Polygon) -> Polygon:
    """Return a chimney breast on the east wall of a room."""
    _, south, east, north = room.bounds
    depth, width = random.uniform(0.3, 0.45), random.uniform(1.2, 1.6)
    y = south + (north - south) * random.uniform(0.38, 0.48)
    return box(east - depth, y - width / 2, east, y + width / 2)


def _hearth(breast: Polygon) -> Polygon:
    """Return the footprint of the hearth in a chimney breast."""
    west, _, east, _ = breast.bounds
    return block(breast.centroid.x, breast.centroid.y, east - west, 0.9)


def _over_hearth(prism: Prism, hearths: list[Polygon]) -> Prism:
    """Return what stands above a hearth as wall, because plans are cut above it."""
    if prism.bottom == HEARTH and any(prism.footprint.intersects(hearth) for hearth in hearths):
        return Prism(prism.footprint, prism.top, prism.bottom)
    return prism


def _round_window(openings: Openings, circle: tuple[float, float, float]) -> None:
    """Put a window into the round corner."""
    x, y, radius = circle
    turns = np.radians(np.linspace(35, 55, 9))
    ways = np.column_stack([np.cos(turns), np.sin(turns)])
    inner, outer = (np.array([x, y]) + distance * ways for distance in (radius - 0.02, radius + OUTER + 0.05))
    openings.voids.append((Polygon([*inner, *outer[::-1]]), 0.9, DOOR_HEAD))
    openings.lines += [
        LineString(np.array([x, y]) + distance * ways) for distance in (radius, radius + OUTER)
    ]


def _front_door(openings: Openings) -> None:
    """Put a closed door into the front wall of the hall."""
    openings.voids.append((box(0.8, -OUTER - 0.01, 1.75, 0.01), 0.0, DOOR_HEAD))
    openings.fillings.append(Prism(box(0.8, -0.16, 1.75, -0.12), DOOR_HEAD, 0.0, "furniture"))
    openings.lines += [LineString([(0.8, y), (1.75, y)]) for y in (0.0, -OUTER)]


def _flight() -> tuple[list[Prism], Polygon]:
    """Return a flight along the west wall with the panel below it, and the opening in the ceiling."""
    prisms, start, count = [], 2.4, int(np.ceil(FLOOR_ABOVE / RISE))
    for step in range(count):
        south, top = start + GOING * step, RISE * (step + 1)
        solid = step < OPEN_STEPS
        prisms.append(Prism(box(0, south, FLIGHT, south + GOING), top, 0.0 if solid else top - 0.25, "slab"))
        if not solid and top < CEILING:
            prisms.append(Prism(box(FLIGHT - 0.05, south, FLIGHT, south + GOING), top - 0.25))
    well = box(0, start + GOING * 2, FLIGHT + 0.1, start + GOING * count)
    return prisms, well
