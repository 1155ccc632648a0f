"""Upright surfaces, sheets and footprints drawn straight into pixels, without points."""

from typing import NamedTuple

import numpy as np
from ichnograph.algorithms.site_plan.storeys.division.division import divide
from ichnograph.algorithms.site_plan.storeys.evidence.footprint import Footprint
from ichnograph.algorithms.site_plan.storeys.evidence.levels import Frame, Storey, Uprights
from ichnograph.algorithms.site_plan.storeys.evidence.sheets import Sheet
from ichnograph.algorithms.site_plan.storeys.evidence.uprights_along import UprightsAlong

STOREY = Storey(0.0, 2.6)

EDGE, LOW, SIZE = 0.02, -1.0, 12.0

FINE = Frame(LOW, LOW, EDGE, (int(SIZE / EDGE), int(SIZE / EDGE)))
"""Pixels of upright surfaces; both frames are 12 m square around places from -1 to 11."""

COARSE = Frame(LOW, LOW, 2 * EDGE, (int(SIZE / EDGE / 2), int(SIZE / EDGE / 2)))
"""Pixels of footprints."""


class Face(NamedTuple):
    """An upright surface from one place to another, filled between two levels of 10 cm."""

    start: tuple
    stop: tuple
    low: int = 0
    high: int = 26

    @property
    def bits(self):
        return (1 << self.high) - (1 << self.low)

    @property
    def sheet(self):
        return Sheet(np.array(self.start, float), np.array(self.stop, float), self.high - self.low, 0.002)


def sides(x0, y0, x1, y1, low=0, high=26):
    """Return the four faces of a room, or of a column."""
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    return [Face(a, b, low, high) for a, b in zip(corners, corners[1:] + corners[:1])]


def uprights_of(*faces):
    """Return the pixels of faces; where two meet, the first gives the normal."""
    pixels = {}
    for face in faces:
        start, stop = np.array(face.start, float), np.array(face.stop, float)
        way = stop - start
        angle = np.arctan2(way[0], -way[1]) % np.pi
        places = np.linspace(start, stop, int(2 * np.hypot(*way) / EDGE) + 2)
        for key, place in zip(zip(*(part.tolist() for part in FINE.places(places))), places):
            held = pixels.setdefault(key, [place, angle, 0])
            held[2] |= face.bits
    row, column = np.array(list(pixels), int).reshape(-1, 2).T
    xy = np.array([held[0] for held in pixels.values()]).reshape(-1, 2)
    angle = np.array([held[1] for held in pixels.values()], float)
    return Uprights(FINE, row, column, xy, angle, np.array([held[2] for held in pixels.values()], np.uint64))


def along(*faces):
    """Return the look-up of faces, with the lengths that the settings have for dense points."""
    return UprightsAlong(uprights_of(*faces), 0.04, 0.05, 0.08, 25.0)


def footprint_of(*spaces, floor=0.0, ceiling=2.6):
    """Return a footprint that is seen within boxes, given by two corners, and nowhere else."""
    weight = np.zeros(COARSE.shape, np.float32)
    floors, ceilings = (np.full(COARSE.shape, np.nan, np.float32) for _ in range(2))
    for x0, y0, x1, y1 in spaces:
        (row0, row1), (column0, column1) = COARSE.places(np.array([(x0, y0), (x1, y1)]) + 1e-6)
        inside = slice(row0, row1), slice(column0, column1)
        weight[inside], floors[inside], ceilings[inside] = 1.0, floor, ceiling
    return Footprint(COARSE, weight, floors, ceilings)


def with_floor(footprint, space, floor):
    """Return a footprint with a floor of another height within a box."""
    part = footprint_of(space, floor=floor)
    floors = np.where(np.isfinite(part.floor), part.floor, footprint.floor)
    return Footprint(COARSE, np.maximum(footprint.weight, part.weight), floors, footprint.ceiling)


def divided(faces, footprint):
    """Return the division of what faces bound."""
    return divide([face.sheet for face in faces], footprint, along(*faces))
