"""Parts of facades. Lengths in metres, in u (right), v (up) and w (out of the wall)."""

from dataclasses import dataclass, field, replace

import numpy as np
from ichnograph.algorithms.facade.elevation import COLOURED, OPENING, PROJECTION, RECESS
from shapely.geometry import Polygon, box

from .caster import Leaves, Panel
from .scene import FacadeScene, Light, TrueDetail

U, V, W = np.eye(3)
PLASTER, STONE = (214.0, 204.0, 184.0), (178.0, 160.0, 132.0)
GLASS, WOOD, DARK = (60.0, 75.0, 85.0), (120.0, 85.0, 55.0), (35.0, 32.0, 30.0)
STREET, TRUNK = (120.0, 118.0, 115.0), (95.0, 75.0, 60.0)
FRAME_WIDTH = 0.07
ROOM = 3.0


@dataclass
class Builder:
    """Collects the parts of a facade whose wall is `width` by `height`."""

    width: float
    height: float
    holes: list = field(default_factory=list)
    panels: list = field(default_factory=list)
    leaves: list = field(default_factory=list)
    details: list = field(default_factory=list)
    rise: float = 0.0

    def front(self, outline: Polygon, w: float, colour, reflectance: float, returns: float = 1.0) -> None:
        """Add a panel along the wall."""
        self.panels.append(Panel(w * W, np.array([U, V]), outline, colour, reflectance, returns))

    def sides(self, outline: Polygon, near: float, far: float, colour, reflectance: float) -> None:
        """Add the panels between an outline at w = near and the same at w = far."""
        corners = np.array(outline.exterior.coords)
        for start, stop in zip(corners[:-1], corners[1:]):
            length = np.linalg.norm(stop - start)
            if length < 1e-9:
                continue
            along = np.array([*(stop - start) / length, 0.0])
            origin = np.array([*start, min(near, far)])
            self.panels.append(
                Panel(origin, np.array([along, W]), box(0, 0, length, abs(far - near)), colour, reflectance)
            )

    def window(self, outline: Polygon, depth: float) -> None:
        """Cut a recess with a wooden frame and a pane."""
        self.holes.append(outline)
        self.sides(outline, 0.0, -depth, PLASTER, 0.7)
        pane = outline.buffer(-FRAME_WIDTH, join_style=2)
        self.front(outline.difference(pane), -depth, WOOD, 0.35)
        self.front(pane, -depth - 0.015, GLASS, 0.12, 0.3)
        self.front(outline.buffer(1.5, join_style=2), -depth - ROOM, DARK, 0.1)
        self.details.append(TrueDetail(RECESS, outline, -depth))

    def opening(self, outline: Polygon, depth: float) -> None:
        """Cut an opening into a dark room."""
        self.holes.append(outline)
        self.sides(outline, 0.0, -depth, PLASTER, 0.7)
        self.front(outline.buffer(1.5, join_style=2), -depth - ROOM, DARK, 0.1)
        self.details.append(TrueDetail(OPENING, outline, -depth - ROOM))

    def door(self, outline: Polygon, depth: float) -> None:
        """Cut a recess with a leaf of wood."""
        self.holes.append(outline)
        self.sides(outline, 0.0, -depth, STONE, 0.6)
        self.front(outline, -depth, (96.0, 60.0, 40.0), 0.3)
        self.details.append(TrueDetail(RECESS, outline, -depth))

    def painted(self, outline: Polygon, colour, reflectance: float, thickness: float = 0.002) -> None:
        """Add paint or a shutter in the plane of the wall."""
        self.front(outline, thickness, colour, reflectance)
        self.details.append(TrueDetail(COLOURED, outline, thickness))

    def moulding(self, outline: Polygon, depth: float, colour=STONE, reflectance: float = 0.6) -> None:
        """Add a block in front of the wall."""
        self.front(outline, depth, colour, reflectance)
        self.sides(outline, 0.0, depth, colour, reflectance)
        self.details.append(TrueDetail(PROJECTION, outline, depth))

    def box(self, outline: Polygon, low: float, high: float, colour, reflectance: float) -> None:
        """Add an object in front of the wall that is not part of it, from w = low to high."""
        self.front(outline, high, colour, reflectance)
        self.sides(outline, low, high, colour, reflectance)

    def tree(self, u: float, w: float, crown: float, radius: float) -> None:
        """Plant a tree whose crown is around v = crown."""
        self.box(box(u - 0.12, -0.3, u + 0.12, crown), w - 0.12, w + 0.12, TRUNK, 0.4)
        for du, dv, share in ((0, 0, 1.0), (0.5, 0.3, 0.7), (-0.45, 0.35, 0.7)):
            centre = (u + du * radius, crown + dv * radius, w)
            self.leaves.append(Leaves(centre, share * radius, 2.5))

    def street(self, rise: float) -> None:
        """Add the ground in front of the wall, rising to the right."""
        self.rise = rise
        slope = np.array([1.0, rise, 0.0]) / np.hypot(1.0, rise)
        origin = np.array([-8.0, -8.0 * rise - 0.5 * self.width * rise, 0.0])
        self.panels.append(
            Panel(origin, np.array([slope, W]), box(0, -0.02, self.width + 16, 14), STREET, 0.3)
        )

    def corner(self, left: bool, length: float) -> None:
        """Add a side wall, towards the viewer, at an end of the wall."""
        u = 0.0 if left else self.width
        outline = box(0, -0.3, length, self.height)
        self.panels.append(Panel(u * U, np.array([W, V]), outline, STONE, 0.55))

    def build(self, name: str, light: Light, stations, gains) -> FacadeScene:
        """Return the scene; the wall reaches a little below the ground."""
        wall = box(0, 0, self.width, self.height)
        solid = box(0, -0.5, self.width, self.height)
        for hole in self.holes:
            left, bottom, right, _ = hole.bounds
            wall, solid = wall.difference(hole), solid.difference(hole)
            if bottom <= 1e-6:
                # A gate reaches the ground.
                solid = solid.difference(box(left, -0.5, right, 0))
        self.front(solid, 0.0, PLASTER, 0.75)
        details = tuple(self._above_ground(detail) for detail in self.details)
        return FacadeScene(
            name, wall, details, tuple(self.panels), tuple(self.leaves), light,
            np.array(stations, float), tuple(gains),
        )  # fmt: skip

    def _above_ground(self, detail: TrueDetail) -> TrueDetail:
        """Return a detail without its part below the street, whose height is taken at the middle."""
        left, bottom, right, top = detail.outline.bounds
        ground = self.rise * (0.5 * (left + right) - 0.5 * self.width)
        if bottom > 1e-6:
            return detail
        return replace(detail, outline=detail.outline.intersection(box(left, ground, right, top)))


def arched(left: float, bottom: float, width: float, height: float, corners: int = 48) -> Polygon:
    """Return a rectangle under a semicircle, `height` in all."""
    radius = 0.5 * width
    turns = np.linspace(0, np.pi, corners + 1)
    middle = np.array([left + radius, bottom + height - radius])
    arc = middle + radius * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return Polygon([(left, bottom), (left + width, bottom), *arc])
