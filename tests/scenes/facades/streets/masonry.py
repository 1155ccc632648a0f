"""The walls of a street: planes of wall with their openings, and the rooms behind them."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np
from shapely.affinity import affine_transform
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from ..building import PLASTER, STONE, STREET, U, V, W
from ..caster import Leaves, Panel
from ..scene import FacadeScene, Light
from .openings import TrueOpening

WALL_THICKNESS = 0.35
FOUNDATION = 0.4
"""How far walls continue below the pavement (m)."""

PAVEMENT, KERB, ROAD = 2.0, 0.12, 14.0
CEILING, FLOOR, FURNITURE = (225.0, 222.0, 215.0), (130.0, 100.0, 75.0), (95.0, 70.0, 50.0)


@dataclass
class Face:
    """A plane of wall, with coordinates a along it to the right and v up.

    Attributes
    ----------
    origin : ndarray, shape (3,)
        Where a and v are 0, in u, v, w.
    along : ndarray, shape (3,)
        The direction of a.
    outline : Polygon
        In a, v.
    colour : tuple of 3 float
    openings : list of Polygon
    """

    origin: np.ndarray
    along: np.ndarray
    outline: Polygon
    colour: tuple[float, float, float] = PLASTER
    openings: list = field(default_factory=list)

    @property
    def normal(self) -> np.ndarray:
        return np.cross(self.along, V)

    @property
    def turned(self) -> bool:
        return bool(self.normal @ W < 0.999)

    def seen(self, outline: Polygon) -> Polygon:
        """Return an outline in a, v as the elevation shows it, in u, v."""
        return affine_transform(outline, [self.along[0], 0, 0, 1, self.origin[0], self.origin[1]])


@dataclass
class Masonry:
    """Collects the parts of a street."""

    generator: np.random.Generator
    faces: list = field(default_factory=list)
    panels: list = field(default_factory=list)
    leaves: list = field(default_factory=list)
    openings: list = field(default_factory=list)

    def about(self, value: float, spread: float = 0.06) -> float:
        """Return a value at most `spread` off."""
        return float(value + self.generator.uniform(-spread, spread))

    def chance(self, share: float) -> bool:
        return bool(self.generator.random() < share)

    def wall(self, outline: Polygon, w: float = 0.0, colour=PLASTER) -> Face:
        """Add a plane of wall parallel to the elevation."""
        return self.face(Face(w * W, U, outline, colour))

    def face(self, face: Face) -> Face:
        """Add a plane of wall."""
        self.faces.append(face)
        return face

    def front(
        self, face: Face, outline: Polygon, out: float, colour, reflectance: float, returns=1.0
    ) -> None:
        """Add a panel parallel to a wall, `out` in front of it."""
        origin = face.origin + out * face.normal
        self.panels.append(Panel(origin, np.array([face.along, V]), outline, colour, reflectance, returns))

    def sides(
        self, face: Face, outline: Polygon, near: float, far: float, colour, reflectance: float
    ) -> None:
        """Add the panels between an outline `near` and the same `far` in front of a wall."""
        corners = np.array(outline.exterior.coords)
        low, high = sorted((near, far))
        for start, stop in zip(corners[:-1], corners[1:]):
            length = np.linalg.norm(stop - start)
            if length < 1e-9:
                continue
            (a, v), (right, up) = start, (stop - start) / length
            origin = face.origin + a * face.along + v * V + low * face.normal
            axes = np.array([right * face.along + up * V, face.normal])
            self.panels.append(Panel(origin, axes, box(0, 0, length, high - low), colour, reflectance))

    def block(
        self, face: Face, outline: Polygon, low: float, high: float, colour, reflectance: float
    ) -> None:
        """Add an object between `low` and `high` in front of a wall."""
        self.front(face, outline, high, colour, reflectance)
        self.sides(face, outline, low, high, colour, reflectance)

    def foliage(self, u: float, v: float, w: float, radius: float, density: float = 2.5) -> None:
        """Add a sphere of leaves."""
        self.leaves.append(Leaves((u, v, w), radius, density))

    def opening(
        self, face: Face, outline: Polygon, kind: str, depth: float, shape: str = "rectangle"
    ) -> None:
        """Cut an opening with its reveals; what fills it is added separately, at `depth` behind the wall."""
        face.openings.append(outline)
        self.sides(face, outline, 0.0, -WALL_THICKNESS, face.colour, 0.7)
        layer = float(face.origin @ W)
        built = tuple(face.origin), tuple(face.along), outline
        self.openings.append(TrueOpening(kind, face.seen(outline), -depth, shape, layer, face.turned, *built))

    def room(self, face: Face, outline: Polygon, deep: float = 4.0) -> None:
        """Add a room with furniture behind a wall.

        Behind its back is the image of the other side of the street, as panes mirror it.
        """
        left, bottom, right, top = outline.bounds
        near, far = -WALL_THICKNESS, -WALL_THICKNESS - deep
        self.sides(face, outline, near, far, CEILING, 0.7)
        self.front(face, outline, far, CEILING, 0.6, 0.85)
        for share in (0.15, 0.6):
            start = left + self.about(share, 0.1) * (right - left)
            high = bottom + self.about(0.5, 0.2) * (top - bottom)
            back = far + self.about(0.3, 0.2) * deep
            self.block(face, box(start, bottom, start + 0.9, high), back, back + 0.5, FURNITURE, 0.4)
        if not face.turned:
            self.front(face, outline, -self.about(11.0, 1.0), STONE, 0.2)

    def ground(self, left: float, right: float) -> None:
        """Add the pavement and, a kerb lower, the road."""
        for start, stop, level in ((0.0, PAVEMENT, 0.0), (PAVEMENT, ROAD, -KERB)):
            origin = np.array([left, level, start])
            self.panels.append(
                Panel(origin, np.array([U, W]), box(0, 0, right - left, stop - start), STREET, 0.3)
            )

    def scene(
        self, name: str, stations, light: Optional[Light] = None, bulge: tuple[float, float] = (0.0, 0.0)
    ) -> FacadeScene:
        """Return the street with its walls, less their openings."""
        for face in self.faces:
            solid = face.outline
            for outline in face.openings:
                left, bottom, right, _ = outline.bounds
                solid = solid.difference(outline)
                if bottom <= 1e-6:
                    solid = solid.difference(box(left, -FOUNDATION - 1, right, 1e-3))
            for part in getattr(solid, "geoms", [solid]):
                self.front(face, part, 0.0, face.colour, 0.75)
        shown = unary_union([face.seen(face.outline) for face in self.faces])
        left, _, right, top = shown.bounds
        wall = shown.intersection(box(left, 0, right, top))
        for opening in self.openings:
            wall = wall.difference(opening.outline)
        return FacadeScene(
            name, wall, tuple(self.openings), tuple(self.panels), tuple(self.leaves), light or Light(),
            np.array(stations, float), (1.0,) * len(stations), bulge=bulge,
        )  # fmt: skip


def standing(left: float, right: float, top: float) -> Polygon:
    """Return a rectangle of wall that continues below the pavement."""
    return box(left, -FOUNDATION, right, top)


STONES = (PLASTER, STONE, (196.0, 150.0, 120.0), (170.0, 95.0, 75.0), (225.0, 220.0, 210.0))
"""Colours of walls."""
