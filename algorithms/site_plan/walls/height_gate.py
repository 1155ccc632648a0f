"""What the heights in a density raster tell: where a wall may stand, and where none can.

A wall fills its column from the ground up without gaps. Density alone cannot see that: ceiling beams, slab
edges and crowns are as dense as walls. The occupied height can. Foliage fills its columns too, but in all of
a body, not in a sheet; and furniture ends below the ceiling that the walls beside it reach.
"""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy import ndimage

FLAT = 0.15
"""Occupied height (m) up to which a pixel shows horizontal surfaces only: a single bin."""

GROUND_STEP = 0.3
"""A lowest point up to this height (m) above the local ground is the ground itself."""

GROUND_SHARE = 0.05
"""Share of the pixels with points that show the ground, at least, unless it was cut off."""

COLUMN_HEIGHT = 1.5
"""Occupied height (m) of a column: three quarters of the window that is looked at."""

SLICE = 0.7
"""A horizontal slice does not rise this high (m) above what would be its ground."""

FLOOR_WIDTH, FLOOR_SHARE = 1.0, 0.2
"""Nor does it show a floor: squares of this width (m) that cover this share of the pixels with points."""


SHEET = 0.5
"""Share of a pixel up to which points are spread that stand above one another; of walls, 0.2 to 0.4."""

BODY = 0.4
"""Foliage is at least this thick (m) each way: more than a partition with two rough faces."""

REACHES = 0.2
"""What fills this height (m) right below a ceiling reaches it: two bins, as one may be the ceiling itself."""

BEHIND = 0.5
"""Height (m) that a wall fills below the ceiling where furniture hides it; a beam is lower."""

ROOM_GAP = 0.5
"""Ceilings up to this far apart (m), as on both sides of a beam, are of one room."""


NOT_TOLD = (
    "The raster has no bands of spread and hanging height, so vegetation and furniture are not told from "
    "walls; make it anew with 'densityimage'."
)


@dataclass(frozen=True)
class Heights:
    """The bands of a density raster that tell heights; float, shape (rows, columns).

    Attributes
    ----------
    occupied, base, top, ground : ndarray
        Metres.
    spread : ndarray or None
        Share of the pixel over which its points are spread, 0 to 1; nan where they are few. None in
        rasters of older versions.
    hanging : ndarray or None
        Height filled right below a ceiling, metres; nan where there is none. None as well.
    """

    occupied: np.ndarray
    base: np.ndarray
    top: np.ndarray
    ground: np.ndarray
    spread: Optional[np.ndarray] = None
    hanging: Optional[np.ndarray] = None


@dataclass(frozen=True)
class Gate:
    """Masks of shape (rows, columns).

    Attributes
    ----------
    tall : ndarray of bool
        Pixels that may be wall.
    flat : ndarray of bool
        Pixels that show horizontal surfaces only.
    column : ndarray of bool or None
        Pixels filled to a column's height; None if that is not known.
    open_ground : ndarray of bool or None
        Pixels in which the ground was seen, or what is no wall; None if that is not known.
    warnings : tuple of str
    foliage, furniture : ndarray of bool or None
        Pixels that are high enough, but no wall; None if that is not known.
    """

    tall: np.ndarray
    flat: np.ndarray
    column: Optional[np.ndarray]
    open_ground: Optional[np.ndarray]
    warnings: tuple
    foliage: Optional[np.ndarray] = None
    furniture: Optional[np.ndarray] = None


def make_gate(density: np.ndarray, heights: Optional[Heights], min_height: float, pixel_size: float) -> Gate:
    """Return the gate for a density image.

    It is open, so that every pixel may be wall, if the heights are unknown, if the cloud is a
    horizontal slice, or if `min_height` is 0.

    Parameters
    ----------
    density : ndarray of float, shape (rows, columns)
        Nan where there is none.
    heights : Heights or None
        Heights of the same pixels.
    min_height : float
        Least occupied height of a wall pixel, metres.
    pixel_size : float
        Metres.
    """
    held = np.isfinite(density)
    if heights is None:
        unknown = "The raster has no bands of heights: MIN_HEIGHT is not applied."
        return Gate(held, held, None, None, (unknown,) if min_height > 0 else ())
    if _is_slice(held, heights, pixel_size):
        sliced = (
            f"The points reach less than {SLICE:g} m above their ground, as in a horizontal slice: "
            "MIN_HEIGHT is not applied."
        )
        nothing = np.zeros(held.shape, bool)
        # What a slice shows is standing: a column as well as a wall.
        return Gate(held, nothing, held, None, (sliced,) if min_height > 0 else ())
    # Rounded, as 0.4 is 0.4000000059604645 in a raster of float32.
    occupied = np.round(np.nan_to_num(heights.occupied).astype(float), 3)
    flat = held & (occupied <= FLAT)
    if min_height == 0:
        return Gate(held, flat, None, None, ())
    low = np.nan_to_num(heights.base - heights.ground, nan=np.inf) <= GROUND_STEP
    shown = np.count_nonzero(low & flat) / np.count_nonzero(np.isfinite(heights.base))
    is_seen = shown >= GROUND_SHARE
    rises = held & (occupied >= min_height)
    column = occupied >= COLUMN_HEIGHT
    if heights.spread is None or heights.hanging is None:
        return Gate(rises, flat & ~rises, column, low if is_seen else None, (NOT_TOLD,))
    foliage = _foliage(heights, rises, occupied, pixel_size)
    room = _rooms(heights, rises, pixel_size)
    free = room & (heights.hanging < REACHES)
    behind = held & room & (heights.hanging >= BEHIND) & ~low
    tall = (rises & ~foliage & ~free) | behind
    # Of a storey that was cut above its floor it is not known where one can walk.
    open_ground = low | foliage | free if is_seen else None
    return Gate(tall, flat & ~tall, column, open_ground, (), rises & foliage, rises & free & ~foliage)


def _foliage(heights: Heights, rises: np.ndarray, occupied: np.ndarray, pixel_size: float) -> np.ndarray:
    """Tell bodies whose points are spread all over, with their ragged rims."""
    loose = (occupied > FLAT) & ~(heights.spread <= SHEET)
    body = ndimage.binary_opening(loose, np.ones((max(round(BODY / pixel_size), 2),) * 2))
    body = ndimage.binary_dilation(body, np.ones((3, 3)), 2, mask=loose)
    # The sill and the head of a window fill a pixel's plan as well, but little of its height.
    labels, count = ndimage.label(body, np.ones((3, 3)))
    high = 2 * np.bincount(labels[rises], minlength=count + 1) >= np.bincount(labels.ravel())
    high[0] = False
    return high[labels]


def _rooms(heights: Heights, rises: np.ndarray, pixel_size: float) -> np.ndarray:
    """Tell where a ceiling was seen that most of what rises below it reaches.

    It is not so below the roof over an excavation, whose walls are no furniture.
    """
    covered = np.isfinite(heights.hanging)
    reach = 2 * max(round(ROOM_GAP / 2 / pixel_size), 1) + 1
    labels, count = ndimage.label(ndimage.maximum_filter(covered, reach), np.ones((3, 3)))
    labels[~covered] = 0
    risen = np.bincount(labels[rises], minlength=count + 1)
    reaching = np.bincount(labels[rises & (heights.hanging >= REACHES)], minlength=count + 1)
    rooms = 2 * reaching >= risen
    rooms[0] = False
    return rooms[labels]


def _is_slice(held: np.ndarray, heights: Heights, pixel_size: float) -> bool:
    """Tell a horizontal slice, which shows lines, from a flat site, which shows its ground."""
    if float(np.nanpercentile(heights.top - heights.ground, 99.9)) >= SLICE:
        return False
    width = max(round(FLOOR_WIDTH / pixel_size), 3)
    floor = ndimage.minimum_filter(held, width, mode="constant")
    floor = ndimage.maximum_filter(floor, width, origin=-1 if width % 2 == 0 else 0, mode="constant")
    return np.count_nonzero(floor) < FLOOR_SHARE * np.count_nonzero(held)
