"""The pictures of the report of a site plan."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Optional

import numpy as np
from affine import Affine

from ...reporting.pictures import shrunk
from ..results import SitePlan
from ..walls.extraction import Verdict

MARGIN = 0.1
"""Share of what may be wall that is shown around it."""

LARGEST, THUMBNAIL = 1200, 300
"""Most pixels of a raster that a picture is wide or high; blocks of more become one."""


class Fate(IntEnum):
    """What became of a pixel; the largest is shown where several share a dot of the picture."""

    UNSEEN = 0
    SURFACE = 1
    LOW = 2
    FOLIAGE = 3
    FURNITURE = 4
    FAINT = 5
    SMALL = 6
    MISSHAPEN = 7
    CLOSED = 8
    WALL = 9


COLOURS = {
    Fate.UNSEEN: (255, 255, 255),
    Fate.SURFACE: (238, 241, 243),
    Fate.LOW: (150, 205, 160),
    Fate.FOLIAGE: (70, 140, 70),
    Fate.FURNITURE: (185, 145, 110),
    Fate.FAINT: (170, 190, 205),
    Fate.SMALL: (160, 110, 200),
    Fate.MISSHAPEN: (235, 160, 40),
    Fate.CLOSED: (70, 150, 215),
    Fate.WALL: (34, 48, 58),
}

FATE_OF = {
    Verdict.FAINT: Fate.UNSEEN,
    Verdict.SMALL: Fate.SMALL,
    Verdict.MISSHAPEN: Fate.MISSHAPEN,
    Verdict.KEPT: Fate.WALL,
}


@dataclass(frozen=True)
class View:
    """The part of a raster that pictures show.

    Attributes
    ----------
    rows, columns : slice
    corners : ndarray, shape (2, 2)
        World coordinates of its north-west and south-east corners.
    """

    rows: slice
    columns: slice
    corners: np.ndarray

    @classmethod
    def around(cls, pixels: np.ndarray, transform: Affine) -> "View":
        """Return the view of the pixels that are set, with a margin."""
        set_pixels = [np.flatnonzero(pixels.any(axis=1 - axis)) for axis in (0, 1)]
        margin = round(MARGIN * max(np.ptp(found) + 1 for found in set_pixels))
        rows, columns = (
            slice(max(found[0] - margin, 0), min(found[-1] + 1 + margin, size))
            for found, size in zip(set_pixels, pixels.shape)
        )
        corners = np.array([transform * (columns.start, rows.start), transform * (columns.stop, rows.stop)])
        return cls(rows, columns, corners)

    def part(self, values: np.ndarray) -> np.ndarray:
        """Return the part of an array that is shown."""
        return values[self.rows, self.columns]


def fates(plan: SitePlan, view: View) -> np.ndarray:
    """Return what became of each pixel that a view shows, as `Fate`; uint8."""
    found, gate, held = plan.image, plan.image.gate, view.part(np.isfinite(plan.density.density))
    low = ~view.part(gate.tall) & ~view.part(gate.flat)
    rules = {
        Fate.WALL: view.part(found.votes) > 0,
        Fate.CLOSED: view.part(found.walls),
        Fate.MISSHAPEN: view.part(found.removed(Verdict.MISSHAPEN)),
        Fate.SMALL: view.part(found.removed(Verdict.SMALL)),
        Fate.FAINT: view.part(found.gated) > 0,
        Fate.FOLIAGE: _known(gate.foliage, view, held),
        Fate.FURNITURE: _known(gate.furniture, view, held),
        Fate.LOW: held & low,
        Fate.SURFACE: held,
    }
    return _numbered(rules)


def _known(mask: Optional[np.ndarray], view: View, held: np.ndarray) -> np.ndarray:
    return np.zeros_like(held) if mask is None else view.part(mask)


def fates_at(verdicts: np.ndarray, view: View) -> np.ndarray:
    """Return what became, at one threshold, of the pixels that a view shows; from their `Verdict`."""
    return np.array([FATE_OF[verdict] for verdict in Verdict], np.uint8)[view.part(verdicts)]


def _numbered(rules: Mapping[Fate, np.ndarray]) -> np.ndarray:
    """Return the number of the first rule that holds."""
    return np.select(list(rules.values()), [np.uint8(fate) for fate in rules], np.uint8(Fate.UNSEEN))


def coloured(fate: np.ndarray, largest: int = LARGEST) -> np.ndarray:
    """Return the colours of pixels, in a picture at most so many pixels wide and high."""
    return np.array([COLOURS[kind] for kind in Fate], np.uint8)[fitted(fate, largest)]


def fitted(values: np.ndarray, largest: int = LARGEST) -> np.ndarray:
    """Return the largest values of blocks of pixels, so that at most so many are left in a row or column."""
    return shrunk(values, max(1, -(-max(values.shape) // largest)))
