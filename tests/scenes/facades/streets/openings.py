"""Openings as they were built, and their outlines."""

from dataclasses import dataclass, field

import numpy as np
from shapely.geometry import Point, Polygon, box

from ..scene import TrueDetail

WINDOW, DOOR, PASSAGE, NICHE = "window", "door", "passage", "niche"
ARC = 20
"""Corners of half a circle, less than a millimetre off for openings as wide as a door."""


@dataclass(frozen=True)
class TrueOpening(TrueDetail):
    """An opening of a wall.

    `kind` is window, door, passage or niche; `depth` is that of what fills it, from its wall (m, negative).

    Attributes
    ----------
    shape : str
        Rectangle, segmental arch, round arch, pointed arch or circle.
    layer : float
        w of the wall around it (m).
    turned : bool
        Whether its wall is not parallel to the elevation; the outline is then as the elevation shows it.
    origin, along : tuple of 3 float
        Where a and v are 0 on its wall, and the direction of a, in u, v, w.
    built : Polygon
        Its outline on its wall, in a, v.
    """

    shape: str = "rectangle"
    layer: float = 0.0
    turned: bool = False
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    along: tuple[float, float, float] = (1.0, 0.0, 0.0)
    built: Polygon = field(default_factory=Polygon)

    @property
    def axes(self) -> np.ndarray:
        """The directions of a, v and out of its wall, as rows, shape (3, 3)."""
        along = np.array(self.along)
        return np.array([along, (0.0, 1.0, 0.0), np.cross(along, (0.0, 1.0, 0.0))])

    def places(self, points: np.ndarray) -> np.ndarray:
        """Return points of its wall, shape (n, 2) in a, v, in u, v, w."""
        return self.origin + points @ self.axes[:2]


def segmental(left: float, bottom: float, width: float, height: float, rise: float) -> Polygon:
    """Return a rectangle under a flat arch of `rise`, `height` in all."""
    radius = (0.25 * width**2 + rise**2) / (2 * rise)
    half = np.arcsin(min(0.5 * width / radius, 1.0))
    turns = np.linspace(half, -half, ARC + 1)
    middle = np.array([left + 0.5 * width, bottom + height - radius])
    arc = middle + radius * np.stack([np.sin(turns), np.cos(turns)], axis=1)
    return Polygon([(left, bottom), (left + width, bottom), *arc])


def round_arch(left: float, bottom: float, width: float, height: float) -> Polygon:
    """Return a rectangle under half a circle, `height` in all."""
    return segmental(left, bottom, width, height, 0.5 * width)


def pointed(left: float, bottom: float, width: float, height: float) -> Polygon:
    """Return a rectangle under two arcs as wide as it, `height` in all."""
    spring = bottom + height - width * np.sqrt(0.75)
    right_foot, left_foot = Point(left, spring), Point(left + width, spring)
    head = right_foot.buffer(width, 2 * ARC).intersection(left_foot.buffer(width, 2 * ARC))
    above = box(left, spring, left + width, bottom + height + width)
    return box(left, bottom, left + width, spring).union(head.intersection(above)).buffer(0)


def circle(u: float, v: float, radius: float) -> Polygon:
    """Return a circle."""
    return Point(u, v).buffer(radius, ARC // 2)
