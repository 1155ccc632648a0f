"""The pictures of the report of a site plan."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from affine import Affine
from shapely.geometry import Polygon

from ..html import Markup, element
from ..maps import Map
from ..pictures import image, shrunk
from .gate import Gate
from .plan import SitePlan
from .regions import Selection

MARGIN = 2.0
"""Metres shown around what may be wall."""

LARGEST, THUMBNAIL = 1200, 300
"""Most pixels of a raster that a picture is wide or high; blocks of more become one."""

FACE, ROOM = "#a8321a", "#2a8a96"


class Fate(IntEnum):
    """What became of a pixel; the largest is shown where several share a dot of the picture."""

    UNSEEN = 0
    SURFACE = 1
    LOW = 2
    FAINT = 3
    SMALL = 4
    MISSHAPEN = 5
    CLOSED = 6
    WALL = 7


COLOURS = {
    Fate.UNSEEN: (255, 255, 255),
    Fate.SURFACE: (238, 241, 243),
    Fate.LOW: (150, 205, 160),
    Fate.FAINT: (170, 190, 205),
    Fate.SMALL: (160, 110, 200),
    Fate.MISSHAPEN: (235, 160, 40),
    Fate.CLOSED: (70, 150, 215),
    Fate.WALL: (34, 48, 58),
}


@dataclass(frozen=True)
class View:
    """The part of a raster that pictures show.

    Attributes
    ----------
    rows, columns : slice
    world : Map
        Of that part.
    corners : ndarray, shape (2, 2)
        World coordinates of its north-west and south-east corners.
    """

    rows: slice
    columns: slice
    world: Map
    corners: np.ndarray

    @classmethod
    def around(cls, pixels: np.ndarray, transform: Affine) -> "View":
        """Return the view of the pixels that are set, with a margin."""
        margin = round(MARGIN / transform.a)
        spans = []
        for axis in (0, 1):
            places = np.flatnonzero(pixels.any(axis=1 - axis))
            spans.append(slice(max(places[0] - margin, 0), min(places[-1] + 1 + margin, pixels.shape[axis])))
        rows, columns = spans
        corners = np.array([transform * (columns.start, rows.start), transform * (columns.stop, rows.stop)])
        return cls(rows, columns, Map.around(corners), corners)

    def part(self, values: np.ndarray, largest: int = LARGEST) -> np.ndarray:
        """Return the part of an array that is shown, shrunk to at most so many pixels."""
        shown = values[self.rows, self.columns]
        return shrunk(shown, max(1, -(-max(shown.shape) // largest)))

    def sheet(self, rgb: np.ndarray, *parts: Markup) -> Markup:
        """Return a map over a picture of the part."""
        (left, top), (right, bottom) = self.world.place(self.corners)
        return self.world.sheet(image(rgb, left, top, right - left, bottom - top), *parts)

    def areas(self, outlines: Iterable, colour: str, opacity: float) -> Markup:
        """Return polygons, filled and bordered in a colour."""
        path = "".join(self._ring(ring) for outline in outlines for ring in _rings(outline))
        return element(
            "path",
            d=path,
            fill=colour,
            fill_opacity=opacity,
            fill_rule="evenodd",
            stroke=colour,
            stroke_width=1,
        )

    def _ring(self, ring) -> str:
        return (
            "M"
            + "L".join(f"{x:.1f} {y:.1f}" for x, y in self.world.place(np.asarray(ring.coords)[:-1]))
            + "z"
        )


def _rings(outline: Polygon) -> tuple:
    return (outline.exterior, *outline.interiors)


def fates(
    plan: SitePlan, gate: Gate, held: np.ndarray, small: np.ndarray, misshapen: np.ndarray
) -> np.ndarray:
    """Tell what became of each pixel, as `Fate`; uint8, shape (rows, columns).

    Parameters
    ----------
    plan : SitePlan
    gate : Gate
        With which the plan was made.
    held : ndarray of bool, shape (rows, columns)
        Pixels that hold density.
    small, misshapen : ndarray of bool, shape (rows, columns)
        Pixels that belonged, at any threshold, to a region removed by area or by shape.
    """
    found = plan.image
    rules = {
        Fate.WALL: found.votes > 0,
        Fate.CLOSED: found.walls,
        Fate.MISSHAPEN: misshapen,
        Fate.SMALL: small,
        Fate.FAINT: found.gated > 0,
        Fate.LOW: held & ~gate.tall & ~gate.flat,
        Fate.SURFACE: held,
    }
    return np.select(list(rules.values()), [np.uint8(fate) for fate in rules], np.uint8(Fate.UNSEEN))


def coloured(fate: np.ndarray) -> np.ndarray:
    """Return the colours of pixels; uint8, shape (rows, columns, 3)."""
    return np.array([COLOURS[kind] for kind in Fate], np.uint8)[fate]


def fates_at(selection: Selection) -> np.ndarray:
    """Tell what became of the pixels above one threshold."""
    rules = {Fate.WALL: selection.kept, Fate.MISSHAPEN: selection.misshapen, Fate.SMALL: selection.small}
    return np.select(list(rules.values()), [np.uint8(fate) for fate in rules], np.uint8(Fate.UNSEEN))
