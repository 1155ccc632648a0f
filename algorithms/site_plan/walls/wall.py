"""Walls as features: an outline each, and the attributes that follow from the rasters."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from affine import Affine
from shapely.geometry import Polygon
from skimage.measure import regionprops

from ...geometry.azimuths import line_azimuth
from .extraction import WallImage
from .height_gate import Heights
from .pixel_outlines import label_walls, trace_outlines
from .regions import Region, wall_shape, width_of
from .settings import WallHeightSettings


@dataclass(frozen=True)
class Wall:
    """One wall: pixels that hang together.

    Attributes
    ----------
    wall_id : int
        From 1, top to bottom of the raster.
    outline : Polygon
        World coordinates.
    kind : str
        'straight', 'curved' (also walls that meet at corners) or 'column'; under a ceiling 'wall', 'column',
        or 'parapet' with a window above it.
    length : float
        Length of the centreline, metres.
    z_base, z_top, height : float or None
        Heights that a tenth of the pixels' lowest points lie below, and of their highest points above,
        and the difference; metres. None if the heights are unknown.
    azimuth : float or None
        Direction of a straight wall, degrees clockwise from grid north, 0..180.
    density : float or None
        Mean density, points per pixel; None where no pixel may be wall.
    votes : int or None
        Number of thresholds at which at least half the wall was found.
    thickness, thick_sd, radius, coverage, rms : float or None
        See `Measures`; None as long as the faces are not known.
    body : int or None
        Under a ceiling, the number of the connected body that the wall is a piece of.
    """

    wall_id: int
    outline: Polygon
    kind: str
    length: float
    z_base: Optional[float]
    z_top: Optional[float]
    height: Optional[float]
    azimuth: Optional[float]
    density: Optional[float]
    votes: Optional[int]
    thickness: Optional[float] = None
    thick_sd: Optional[float] = None
    radius: Optional[float] = None
    coverage: Optional[float] = None
    rms: Optional[float] = None
    body: Optional[int] = None


def describe_walls(
    image: WallImage,
    heights: Optional[Heights],
    transform: Affine,
) -> tuple[Wall, ...]:
    """Make walls of wall pixels.

    Parameters
    ----------
    image : WallImage
        With the settings of its extraction.
    heights : Heights or None
        None if only the density is known.
    transform : Affine
        From (column, row) to world coordinates.

    Returns
    -------
    tuple of Wall
    """
    labels = label_walls(image.walls)
    outlines = trace_outlines(labels, transform, image.settings.outlines)
    walls = []
    for region in regionprops(labels):
        # Closing adds pixels without votes or density; every wall holds some that have both.
        found = image.votes[region.slice][region.image]
        density = image.gated[region.slice][region.image]
        z_base, z_top = _reach(heights, region, image.settings.heights)
        kind = _kind(region, image, transform.a)
        walls.append(
            Wall(
                wall_id=region.label,
                outline=outlines[region.label],
                kind=kind,
                length=band_length(outlines[region.label]),
                z_base=z_base,
                z_top=z_top,
                height=None if z_base is None or z_top is None else z_top - z_base,
                azimuth=_azimuth(region) if kind == "straight" else None,
                density=float(density[density > 0].mean()),
                votes=int(np.median(found[found > 0])),
            )
        )
    return tuple(walls)


def _kind(region: Region, image: WallImage, pixel_size: float) -> str:
    """Name the shape that a wall has after closing."""
    compact = "column" if width_of(region, pixel_size) <= image.settings.regions.column_width_m else "curved"
    return wall_shape(region, image.criteria) or compact


def band_length(outline: Polygon) -> float:
    """Return the length of the centreline of a band, from its perimeter 2 (l + t) and area l t.

    A band that closes on itself has no ends, and is half its perimeter long.
    """
    half = outline.length / 2
    if outline.interiors:
        return half
    return (half + float(np.sqrt(max(half**2 - 4 * outline.area, 0.0)))) / 2


def _reach(
    heights: Optional[Heights], region: Region, settings: WallHeightSettings
) -> tuple[Optional[float], Optional[float]]:
    """Return the base and the top of a wall, metres."""
    if heights is None:
        return None, None
    base = heights.base[region.slice][region.image]
    top = heights.top[region.slice][region.image]
    held = np.isfinite(base)
    if not held.any():
        return None, None
    low, high = settings.base_percentile, settings.top_percentile
    return float(np.percentile(base[held], low)), float(np.percentile(top[held], high))


def _azimuth(region: Region) -> float:
    south, east = region.coords.T
    return line_azimuth(np.linalg.eigh(np.cov(east, -south))[1][:, -1])
