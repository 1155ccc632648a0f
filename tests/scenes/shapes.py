"""Builders of the objects that scenes share. Lengths are in metres."""

from collections.abc import Sequence

import numpy as np
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, MultiPoint, Point, Polygon, box
from shapely.ops import substring, unary_union

from .things import Ground, Plant, Prism

DOOR_HEAD = 2.1
WINDOW_SILL = 0.9


def scanner_height(random: np.random.Generator) -> float:
    """Return the height of a tripod's scanner above the ground."""
    return random.uniform(1.6, 1.75)


def disc(x: float, y: float, radius: float, corners: int = 32) -> Polygon:
    """Return a regular polygon around (x, y)."""
    turns = np.arange(corners) * 2 * np.pi / corners
    return Polygon(np.column_stack([x + radius * np.cos(turns), y + radius * np.sin(turns)]))


def block(x: float, y: float, width: float, depth: float, angle: float = 0.0) -> Polygon:
    """Return a rectangle centred on (x, y), rotated by `angle` (degrees)."""
    flat = box(x - width / 2, y - depth / 2, x + width / 2, y + depth / 2)
    return rotate(flat, angle, origin=(x, y)) if angle else flat


def masonry(axis: Sequence[tuple[float, float]], thickness: float) -> Polygon:
    """Return a wall of `thickness` along its axis, cut square at the ends."""
    return LineString(axis).buffer(thickness / 2, cap_style=2, join_style=2)


def shell(outline: Polygon, thickness: float) -> Polygon:
    """Return the walls around `outline`, which runs along their middle."""
    outer = outline.buffer(thickness / 2, join_style=2)
    return outer.difference(outline.buffer(-thickness / 2, join_style=2))


def polygons(geometry) -> list[Polygon]:
    """Return the polygons of a geometry."""
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 1e-9]


def pierced(
    walls: Sequence[Polygon],
    doors: Sequence[Polygon],
    windows: Sequence[Polygon],
    top: float,
    floor: float = 0.0,
) -> list[Prism]:
    """Return walls with openings, with a lintel over each and a sill wall below each window.

    Parameters
    ----------
    walls : sequence of Polygon
        May overlap.
    doors, windows : sequence of Polygon
        Each reaches through a wall.
    top, floor : float
        Heights of the walls' upper face and of the floor.
    """
    solid = unary_union(walls)
    openings = unary_union([*doors, *windows])
    prisms = [Prism(part, top) for part in polygons(solid.difference(openings))]
    for opening in [*doors, *windows]:
        gaps = polygons(solid.intersection(opening))
        prisms += [Prism(gap, top, floor + DOOR_HEAD, "lintel") for gap in gaps]
    for window in windows:
        gaps = polygons(solid.intersection(window))
        prisms += [Prism(gap, floor + WINDOW_SILL) for gap in gaps]
    return prisms


def standing(footprint: Polygon, height: float, ground: Ground, material: str = "wall") -> Prism:
    """Return a prism with a level top, `height` above the ground at its middle."""
    middle = footprint.representative_point()
    return Prism(footprint, ground.height(middle.x, middle.y) + height, material=material)


def stretches(
    random: np.random.Generator, axis: LineString, thickness: float, shortest: float, longest: float
) -> list[Polygon]:
    """Return a wall along `axis`, cut into pieces of random length."""
    cuts = [0.0]
    while axis.length - cuts[-1] > longest + shortest:
        cuts.append(cuts[-1] + random.uniform(shortest, longest))
    cuts.append(axis.length)
    return [
        masonry(substring(axis, start, stop).coords, thickness) for start, stop in zip(cuts[:-1], cuts[1:])
    ]


def table(x: float, y: float, width: float, depth: float) -> list[Prism]:
    """Return a board on four legs."""
    prisms = [Prism(block(x, y, width, depth), 0.75, 0.72, "furniture")]
    for side in (-1, 1):
        for end in (-1, 1):
            leg = block(x + side * (width / 2 - 0.05), y + end * (depth / 2 - 0.05), 0.05, 0.05)
            prisms.append(Prism(leg, 0.72, material="furniture"))
    return prisms


def bush(random: np.random.Generator, ground: Ground, x: float, y: float, radius: float):
    """Return the lobes of a bush on the ground, about as high as wide."""
    lobes = []
    for _ in range(5):
        east, north = random.normal(0, radius / 3, 2)
        size = random.uniform(0.45, 0.7) * radius
        up = ground.height(x + east, y + north) + random.uniform(0.5, 1.2) * size
        radii = (size, size * random.uniform(0.8, 1.2), size * random.uniform(0.8, 1.3))
        lobes.append(Plant((x + east, y + north, up), radii, random.uniform(1.5, 4.0)))
    return lobes


def tree(random: np.random.Generator, ground: Ground, x: float, y: float):
    """Return the trunk of a tree and the lobes of its crown."""
    fork = random.uniform(2.4, 3.0)
    trunk = standing(disc(x, y, random.uniform(0.12, 0.2), 16), fork + 1.0, ground, "trunk")
    crown = []
    for _ in range(7):
        east, north = random.normal(0, 0.8, 2)
        radii = tuple(random.uniform(0.8, 1.3, 3))
        up = ground.height(x, y) + fork + radii[2] + random.uniform(-0.4, 1.8)
        crown.append(Plant((x + east, y + north, up), radii, random.uniform(0.6, 1.5)))
    return trunk, crown


def person(ground: Ground, x: float, y: float) -> Prism:
    """Return a person who does not move while all stations scan."""
    return standing(disc(x, y, 0.22, 16), 1.72, ground, "person")


def rubble(random: np.random.Generator, ground: Ground, x: float, y: float) -> Prism:
    """Return a fallen block of irregular outline."""
    corners = random.uniform(-0.4, 0.4, (7, 2)) * random.uniform(0.4, 1.0)
    footprint = translate(MultiPoint(corners).convex_hull, x, y)
    return standing(footprint, random.uniform(0.15, 0.5), ground, "rubble")


def free_of(x: float, y: float, radius: float, footprints: Sequence[Polygon]) -> bool:
    """Whether all `footprints` are further than `radius` from (x, y)."""
    return all(footprint.distance(Point(x, y)) > radius for footprint in footprints)
