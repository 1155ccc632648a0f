"""Where a wall may stand, by the heights in a density raster.

A wall fills its column from the ground up without gaps. Density alone cannot see that: ceiling beams, slab
edges and crowns are as dense as walls. The occupied height can. Foliage fills its columns too, but in all of
a body, not in a sheet; and furniture ends below the ceiling that the walls beside it reach.
"""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy import ndimage

from .settings import HeightGateSettings


@dataclass(frozen=True)
class Heights:
    """The bands of heights of a density raster; float, shape (rows, columns).

    Attributes
    ----------
    occupied, base, top, ground : ndarray
        Metres.
    spread : ndarray
        Share of the pixel over which its points are spread, 0 to 1; nan where they are few.
    hanging : ndarray
        Height filled right below a ceiling, metres; nan without one.
    """

    occupied: np.ndarray
    base: np.ndarray
    top: np.ndarray
    ground: np.ndarray
    spread: np.ndarray
    hanging: np.ndarray


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
        Pixels in which the ground, foliage or furniture was seen; None if that is not known.
    warnings : tuple of str
    foliage, furniture : ndarray of bool or None
        Pixels that are high enough for a wall; None if that is not known.
    """

    tall: np.ndarray
    flat: np.ndarray
    column: Optional[np.ndarray]
    open_ground: Optional[np.ndarray]
    warnings: tuple[str, ...]
    foliage: Optional[np.ndarray] = None
    furniture: Optional[np.ndarray] = None


def make_gate(
    density: np.ndarray,
    heights: Optional[Heights],
    min_height: float,
    pixel_size: float,
    settings: HeightGateSettings = HeightGateSettings(),
) -> Gate:
    """Return the gate for a density image.

    It is open, so that every pixel may be wall, if the heights are unknown, if the cloud is a
    horizontal slice, or if `min_height` is 0.

    Parameters
    ----------
    density : ndarray of float, shape (rows, columns)
        Nan where no point contributes.
    heights : Heights or None
        Heights of the same pixels.
    min_height : float
        Least occupied height of a wall pixel, metres.
    pixel_size : float
        Metres.
    settings : HeightGateSettings
    """
    held = np.isfinite(density)
    if heights is None:
        unknown = "The raster does not have the bands of heights: MIN_HEIGHT is not applied."
        return Gate(held, held, None, None, (unknown,) if min_height > 0 else ())
    if _is_slice(held, heights, pixel_size, settings):
        sliced = (
            f"The points reach less than {settings.slice_height_m:g} m above their ground, as in a "
            "horizontal slice: MIN_HEIGHT is not applied."
        )
        nothing = np.zeros(held.shape, bool)
        # All that a slice shows stands upright: a column as well as a wall.
        return Gate(held, nothing, held, None, (sliced,) if min_height > 0 else ())
    # Rounded, as 0.4 is 0.4000000059604645 in a raster of float32.
    occupied = np.round(np.nan_to_num(heights.occupied).astype(float), 3)
    flat = held & (occupied <= settings.flat_m)
    if min_height == 0:
        return Gate(held, flat, None, None, ())
    low = np.nan_to_num(heights.base - heights.ground, nan=np.inf) <= settings.ground_step_m
    shown = np.count_nonzero(low & flat) / np.count_nonzero(np.isfinite(heights.base))
    is_seen = shown >= settings.ground_share
    rises = held & (occupied >= min_height)
    column = occupied >= settings.column_height_m
    foliage = _foliage(heights.spread, rises, occupied, pixel_size, settings)
    room = _rooms(heights.hanging, rises, pixel_size, settings)
    free = room & (heights.hanging < settings.reaching_m)
    behind = held & room & (heights.hanging >= settings.behind_m) & ~low
    tall = (rises & ~foliage & ~free) | behind
    # In a storey that was cut above its floor, where one can walk is unknown.
    open_ground = low | foliage | free if is_seen else None
    return Gate(tall, flat & ~tall, column, open_ground, (), rises & foliage, rises & free & ~foliage)


def _foliage(
    spread: np.ndarray,
    rises: np.ndarray,
    occupied: np.ndarray,
    pixel_size: float,
    settings: HeightGateSettings,
) -> np.ndarray:
    """Return the bodies whose points are spread all over, with their ragged rims."""
    loose = (occupied > settings.flat_m) & ~(spread <= settings.sheet_share)
    width = max(round(settings.body_m / pixel_size), 2)
    body = ndimage.binary_opening(loose, np.ones((width, width)))
    body = ndimage.binary_dilation(body, np.ones((3, 3)), settings.rim_px, mask=loose)
    # The sill and the head of a window fill a pixel's plan as well, but little of its height.
    labels, count = ndimage.label(body, np.ones((3, 3)))
    high = 2 * np.bincount(labels[rises], minlength=count + 1) >= np.bincount(labels.ravel())
    high[0] = False
    return high[labels]


def _rooms(
    hanging: np.ndarray, rises: np.ndarray, pixel_size: float, settings: HeightGateSettings
) -> np.ndarray:
    """Return where a ceiling was seen that most of what rises below it reaches.

    Below the roof over an excavation walls end freely, and are not furniture.
    """
    covered = np.isfinite(hanging)
    reach = 2 * max(round(settings.room_gap_m / 2 / pixel_size), 1) + 1
    labels, count = ndimage.label(ndimage.maximum_filter(covered, reach), np.ones((3, 3)))
    labels[~covered] = 0
    risen = np.bincount(labels[rises], minlength=count + 1)
    reaching = np.bincount(labels[rises & (hanging >= settings.reaching_m)], minlength=count + 1)
    rooms = 2 * reaching >= risen
    rooms[0] = False
    return rooms[labels]


def _is_slice(held: np.ndarray, heights: Heights, pixel_size: float, settings: HeightGateSettings) -> bool:
    """Return whether a cloud is a horizontal slice, which shows lines; a flat site shows its ground."""
    rise = np.nanpercentile(heights.top - heights.ground, settings.slice_percentile)
    if float(rise) >= settings.slice_height_m:
        return False
    width = max(round(settings.floor_width_m / pixel_size), 3)
    floor = ndimage.minimum_filter(held, width, mode="constant")
    floor = ndimage.maximum_filter(floor, width, origin=-1 if width % 2 == 0 else 0, mode="constant")
    return np.count_nonzero(floor) < settings.floor_share * np.count_nonzero(held)
