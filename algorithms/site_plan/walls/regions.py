"""The three criteria by which a connected region counts as wall (Mueller et al. 2012, section 2.2)."""

from dataclasses import dataclass
from typing import Any, Optional, Protocol

import numpy as np
from skimage.measure import label, regionprops

from .settings import RegionSettings


class Region(Protocol):
    """A connected region, as `skimage.measure.regionprops` describes it."""

    area: float
    area_convex: float
    image: np.ndarray
    slice: tuple[Any, ...]
    coords: np.ndarray
    inertia_tensor_eigvals: Any


@dataclass(frozen=True)
class Criteria:
    """Limits of the three criteria.

    Attributes
    ----------
    min_area : float
        Smallest region, m2.
    max_fill : float
        Largest area / bounding box area of a curved wall.
    min_elongation : float
        Smallest major / minor axis of the best-fit ellipse of a straight wall.
    """

    min_area: float
    max_fill: float
    min_elongation: float


@dataclass(frozen=True)
class Selection:
    """What the criteria kept of one binary image, and what each removed.

    Attributes
    ----------
    kept, small, misshapen : ndarray of bool, shape (rows, columns)
        Pixels of the regions that were kept, and of those removed by area and by both shape criteria.
    regions, too_small, wrong_shape : int
        Number of regions in the image, and of those removed by area and by both shape criteria.
    """

    kept: np.ndarray
    small: np.ndarray
    misshapen: np.ndarray
    regions: int
    too_small: int
    wrong_shape: int


def select_regions(
    binary: np.ndarray,
    pixel_size: float,
    criteria: Criteria,
    column: Optional[np.ndarray] = None,
    settings: RegionSettings = RegionSettings(),
) -> Selection:
    """Keep the connected regions of a binary image that are large enough and shaped like a wall.

    Beyond the paper, a compact region is kept as a column if it is filled to a column's height and
    looks like the outline of a solid.

    Parameters
    ----------
    binary : ndarray of bool, shape (rows, columns)
        Pixels above a threshold; regions connect over edges and corners.
    pixel_size : float
        Metres.
    criteria : Criteria
        Limits.
    column : ndarray of bool, shape (rows, columns), optional
        Pixels filled to a column's height; without it no column is kept.
    settings : RegionSettings
    """
    labels, count = label(binary, connectivity=2, return_num=True)
    area = np.bincount(labels.ravel(), minlength=count + 1) * pixel_size**2
    large = area >= criteria.min_area * (1 - 1e-9)
    large[0] = False
    passes = np.zeros(count + 1, bool)
    for region in regionprops(np.where(large[labels], labels, 0)):
        high = column is not None and column[region.slice][region.image].mean() > 0.5
        is_column = high and _is_column(region, pixel_size, settings)
        passes[region.label] = bool(wall_shape(region, criteria)) or is_column
    small, misshapen = ~large, large & ~passes
    small[0] = False
    counts = (count, int(small.sum()), int(misshapen.sum()))
    return Selection(passes[labels], small[labels], misshapen[labels], *counts)


def wall_shape(region: Region, criteria: Criteria) -> Optional[str]:
    """Return the shape criterion by which a region is a wall: 'straight', 'curved' or None."""
    major, minor = region.inertia_tensor_eigvals
    if major >= criteria.min_elongation**2 * minor and major > 0:
        return "straight"
    rows, columns = region.image.shape
    return "curved" if region.area <= criteria.max_fill * rows * columns else None


def width_of(region: Region, pixel_size: float) -> float:
    """Return the longer side of a region's bounding box in metres."""
    return max(region.image.shape) * pixel_size


def _is_column(region: Region, pixel_size: float, settings: RegionSettings) -> bool:
    """Return whether a region is the outline of a column, most of it seen; a bush is full of points."""
    width = width_of(region, pixel_size)
    hollow = width <= settings.post_width_m or region.area <= settings.hollow_share * region.area_convex
    return width <= settings.column_width_m and hollow
