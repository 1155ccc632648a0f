"""Furniture, and what else stands and hangs in rooms. Lengths in metres."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, Point, Polygon, box
from shapely.geometry.base import BaseGeometry

from ..shapes import block, table
from ..things import Prism

TRIES = 30

FITTED = 0.05
"""Nothing is seen over furniture that ends so near below the ceiling."""


@dataclass
class Room:
    """A rectangular room that is being furnished.

    Parameters
    ----------
    inside : Polygon
        From face to face.
    ceiling : float
    doorways : list of Polygon
        Where nothing may stand: before and behind doors.
    windows : list of Polygon
        Where nothing high may stand.
    taken : list of Polygon
        Footprints of what stands there.
    """

    inside: Polygon
    ceiling: float
    doorways: list[BaseGeometry] = field(default_factory=list)
    windows: list[BaseGeometry] = field(default_factory=list)
    taken: list[Polygon] = field(default_factory=list)

    def along_wall(
        self, random: np.random.Generator, length: float, depth: float, gap: float, high: bool
    ) -> list[Polygon]:
        """Return a free rectangle whose back stands `gap` off a wall, in a list; an empty list if full."""
        west, south, east, north = self.inside.bounds
        for _ in range(TRIES):
            side = random.integers(4)
            span = (east - west) if side % 2 == 0 else (north - south)
            if span < length + 0.1:
                continue
            start = random.uniform(0.02, span - length)
            footprint = {
                0: box(west + start, south + gap, west + start + length, south + gap + depth),
                1: box(east - gap - depth, south + start, east - gap, south + start + length),
                2: box(west + start, north - gap - depth, west + start + length, north - gap),
                3: box(west + gap, south + start, west + gap + depth, south + start + length),
            }[int(side)]
            if self._is_free(footprint, high):
                self.taken.append(footprint)
                return [footprint]
        return []

    def free_standing(self, random: np.random.Generator, length: float, depth: float) -> list[Polygon]:
        """Return a free rectangle somewhere in the room, in a list; an empty list if full."""
        west, south, east, north = self.inside.bounds
        for _ in range(TRIES):
            x, y = random.uniform(west + 0.6, east - 0.6), random.uniform(south + 0.6, north - 0.6)
            footprint = block(x, y, length, depth, random.choice([0.0, 90.0]))
            if self.inside.buffer(-0.3).contains(footprint) and self._is_free(footprint, high=False):
                self.taken.append(footprint)
                return [footprint]
        return []

    def station(self, random: np.random.Generator) -> tuple[float, float]:
        """Return where a tripod finds room."""
        west, south, east, north = self.inside.bounds
        best, clearance = self.inside.centroid, 0.0
        for _ in range(TRIES):
            point = Point(random.uniform(west, east), random.uniform(south, north))
            near = min(point.distance(thing) for thing in (*self.taken, self.inside.exterior))
            if near > clearance:
                best, clearance = point, near
            if clearance > 0.6:
                break
        return best.x, best.y

    def _is_free(self, footprint: Polygon, high: bool) -> bool:
        kept = [*self.taken, *self.doorways, *(self.windows if high else ())]
        return not any(footprint.intersects(thing) for thing in kept)


def bookcase(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a bookcase that nearly reaches the ceiling; over a lower one the wall is seen."""
    length, gap = random.uniform(1.0, 2.8), random.uniform(0.0, 0.02)
    below = random.choice([0.0, 0.03, 0.25])
    material = "fitted" if below < FITTED else "furniture"
    return [
        Prism(footprint, room.ceiling - below, material=material)
        for footprint in room.along_wall(random, length, random.uniform(0.25, 0.35), gap, high=True)
    ]


def wardrobe(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a wardrobe as high as a door."""
    length, gap = random.uniform(1.0, 2.2), random.uniform(0.0, 0.03)
    return [
        Prism(footprint, random.uniform(1.9, 2.2), material="furniture")
        for footprint in room.along_wall(random, length, random.uniform(0.55, 0.65), gap, high=True)
    ]


def kitchen(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a counter with cupboards above it, and a fridge."""
    prisms = []
    for footprint in room.along_wall(random, random.uniform(1.8, 2.6), 0.6, 0.0, high=True):
        upper = _nearest_side(footprint, room.inside).buffer(0.35, cap_style=2).intersection(footprint)
        counter = Prism(footprint, 0.9, material="furniture")
        prisms += [counter, Prism(upper, 2.15, 1.45, "furniture")]
    fridges = room.along_wall(random, 0.6, 0.6, 0.02, high=True)
    return prisms + [Prism(footprint, 1.8, material="furniture") for footprint in fridges]


def bed(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a bed with its head at a wall."""
    return [
        Prism(footprint, 0.5, material="furniture")
        for footprint in room.along_wall(random, random.uniform(0.9, 1.8), 2.0, 0.02, high=False)
    ]


def sofa(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a sofa, its back to a wall."""
    return [
        Prism(footprint, 0.8, material="furniture")
        for footprint in room.along_wall(random, random.uniform(1.6, 2.3), 0.9, 0.05, high=False)
    ]


def dining_table(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a table with four chairs."""
    prisms = []
    for footprint in room.free_standing(random, 1.4, 0.8):
        x, y = footprint.centroid.x, footprint.centroid.y
        prisms += table(x, y, 1.4, 0.8)
        for east, north in ((-0.4, -0.6), (0.4, -0.6), (-0.4, 0.6), (0.4, 0.6)):
            prisms.append(Prism(block(x + east, y + north, 0.4, 0.4), 0.45, 0.42, "furniture"))
            prisms.append(Prism(block(x + east, y + 1.3 * north, 0.4, 0.03), 0.9, 0.45, "furniture"))
    return prisms


def workstation(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a desk with a screen at its back, which stands some way before a wall."""
    prisms = []
    gap = random.uniform(0.03, 0.25)
    for footprint in room.along_wall(random, random.uniform(1.4, 3.2), 0.75, gap, high=False):
        back = _nearest_side(footprint, room.inside).buffer(0.03, cap_style=2).intersection(footprint)
        prisms.append(Prism(back, random.uniform(1.2, 1.5), material="furniture"))
        prisms.append(Prism(footprint.difference(back), 0.74, 0.71, "furniture"))
    return prisms


def clutter(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return boxes about the floor, one on another here and there."""
    prisms = []
    for _ in range(random.integers(2, 5)):
        size = random.uniform(0.25, 0.6, 3)
        height = size[2] * random.choice([1, 1, 2.5])
        footprints = room.free_standing(random, size[0], size[1])
        prisms += [Prism(footprint, height, material="furniture") for footprint in footprints]
    return prisms


def machine(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a machine: a body of irregular outline with a higher head."""
    prisms = []
    for footprint in room.free_standing(random, random.uniform(1.0, 3.0), random.uniform(0.7, 1.4)):
        cut = footprint.intersection(footprint.buffer(-0.02).envelope.buffer(0.1))
        prisms.append(Prism(cut, random.uniform(0.9, 1.6), material="furniture"))
        head = block(footprint.centroid.x, footprint.centroid.y, 0.6, 0.5)
        prisms.append(Prism(head, random.uniform(1.7, 2.7), material="furniture"))
    return prisms


def boat(random: np.random.Generator, room: Room) -> list[Prism]:
    """Return a boat on trestles, its hull in two strakes."""
    prisms = []
    for footprint in room.free_standing(random, 5.5, 1.8):
        hull = _lens(footprint)
        prisms.append(Prism(hull.buffer(-0.15), 1.0, 0.6, "furniture"))
        prisms.append(Prism(hull, 1.6, 1.0, "furniture"))
    return prisms


def curtain(random: np.random.Generator, line: LineString, top: float) -> Prism:
    """Return a curtain in folds along a line."""
    count = int(line.length / 0.04)
    stations = np.linspace(0, line.length, count)
    points = np.array([line.interpolate(station).coords[0] for station in stations])
    along = (points[-1] - points[0]) / line.length
    folds = 0.03 * np.sin(stations * 2 * np.pi / random.uniform(0.12, 0.2))
    waved = LineString(points + folds[:, None] * np.array([-along[1], along[0]]))
    return Prism(waved.buffer(0.004, cap_style=2), top, 0.04, "cloth", passing=0.15)


def door_leaf(hinge: tuple[float, float], width: float, angle_deg: float, head: float) -> Prism:
    """Return an open leaf that stands off its hinge at an angle, counted from the x axis."""
    flat = box(0.0, -0.02, width, 0.02)
    leaf = translate(rotate(flat, angle_deg, origin=(0, 0)), *hinge)
    return Prism(leaf, head - 0.02, 0.01, "furniture")


Furnishing = Callable[[np.random.Generator, Room], list[Prism]]


def furnish(random: np.random.Generator, room: Room, things: Sequence[Furnishing]) -> list[Prism]:
    """Return things put into a room one after the other, as far as they find room."""
    return [prism for thing in things for prism in thing(random, room)]


def _nearest_side(footprint: Polygon, inside: Polygon) -> LineString:
    """Return the side of a rectangle that is nearest to the walls."""
    corners = list(footprint.exterior.coords)
    sides = [LineString(pair) for pair in zip(corners, corners[1:])]
    return min(sides, key=lambda side: inside.exterior.distance(side.centroid))


def _lens(footprint: Polygon) -> Polygon:
    """Return the outline of a hull in a rectangle."""
    west, south, east, north = footprint.bounds
    x, y = footprint.centroid.x, footprint.centroid.y
    turns = np.linspace(0, 2 * np.pi, 33)[:-1]
    return Polygon(
        np.column_stack([x + (east - west) / 2 * np.cos(turns), y + (north - south) / 2 * np.sin(turns)])
    )
