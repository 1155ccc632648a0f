"""The step of colour at the border of a detail: sharp where something was made, soft or broken at a stain."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy.spatial import cKDTree
from shapely.geometry import Polygon

from ...geometry.robust import sigma_about_median
from ..outlines.surface import within
from .appearance import Appearance
from .settings import StepSettings

NARROW = "as narrow as a joint"
SOFT = "its colour changes gradually, as that of a stain or of lamplight does"
WEATHERED = "its colour differs no more than the wall's own colours do"
UNCONFIRMED = "the intensity shows no edge, as that of a shadow does not"
"""Why a region of another colour is not a detail."""


@dataclass(frozen=True)
class _Stations:
    """Medians of values in the strips beside a border, station by station.

    Attributes
    ----------
    inner, outer : ndarray of float64, shape (k, channels)
        Close to the border, within it and outside.
    innermost, outermost : ndarray of float64, shape (k, channels)
        Farther from it; nan where there are too few points.
    """

    inner: np.ndarray
    outer: np.ndarray
    innermost: np.ndarray
    outermost: np.ndarray

    @property
    def steps(self) -> np.ndarray:
        """How much the values change across the border, shape (k,)."""
        return np.asarray(np.linalg.norm(self.inner - self.outer, axis=1))

    @property
    def slopes(self) -> np.ndarray:
        """How much they change on either side of it, shape (k,)."""
        sides = (self.inner - self.innermost, self.outer - self.outermost)
        lengths = [np.linalg.norm(np.nan_to_num(side), axis=1) for side in sides]
        return np.asarray(np.maximum(*lengths))


def reason_against_colour(
    points: np.ndarray,
    looks: Appearance,
    outline: Polygon,
    spacing: float,
    colour: float,
    settings: StepSettings = StepSettings(),
) -> Optional[str]:
    """Return why a region of another colour is not a detail of the facade; None if it is one.

    Along most of the border of a detail, the colour changes from one side to the other by a clear step,
    which is larger than the changes beside the border. The intensity, where it is known, changes there too.
    The step exceeds the differences on the wall around, in intensity if it is known, since shadows have none.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 2)
        u, v of the points of the wall, ordered by v as those of a `Surface` are.
    looks : Appearance
        Of the points.
    outline : Polygon
    spacing : float
        Of the points (m).
    colour : float
        tr, the least step of colour.
    settings : StepSettings
    """
    if _width(outline) < max(settings.narrowest_m, settings.narrowest_spacings * spacing):
        return NARROW
    reach = settings.far_spacings * spacing
    near = _near(points, outline, reach)
    stations, distances = _positions(points[near], outline, spacing, settings)
    seen = _medians(looks.rgb[near].astype(float), stations, distances, spacing, settings)
    if not len(seen.inner):
        return SOFT
    # The strips across the border are farther apart than those beside it.
    farther = 2 * (settings.near_spacings + settings.middle_spacings)
    farther /= settings.far_spacings - settings.near_spacings
    clear = (seen.steps >= colour) & (seen.steps >= settings.sharper * farther * seen.slopes)
    if clear.mean() < settings.share:
        return SOFT
    decisive, values = seen, looks.rgb
    if looks.relative is not None:
        values = looks.relative[:, None]
        decisive = _medians(values[near].astype(float), stations, distances, spacing, settings)
        if np.mean(decisive.steps >= looks.threshold) < settings.confirmed:
            return UNCONFIRMED
    texture = _texture(points, values, outline, spacing, settings)
    return WEATHERED if np.median(decisive.steps) < settings.texture_sigmas * texture else None


def _near(points: np.ndarray, outline: Polygon, reach: float) -> np.ndarray:
    """Return the rows of the points within a distance of the box of an outline (m)."""
    left, bottom, right, top = outline.bounds
    first, last = np.searchsorted(points[:, 1], (bottom - reach, top + reach))
    u = points[first:last, 0]
    return np.asarray(first + np.flatnonzero((u > left - reach) & (u < right + reach)))


def _width(outline: Polygon) -> float:
    """Return the width of a shape, which is twice its area over its perimeter if it is long (m)."""
    return float(2 * outline.area / max(outline.length, 1e-9))


def _texture(
    points: np.ndarray, values: np.ndarray, outline: Polygon, spacing: float, settings: StepSettings
) -> float:
    """Return the standard deviation of values around a region, over squares as long as a station."""
    near = _near(points, outline, settings.around_m)
    near = near[~within(outline.buffer(settings.near_spacings * spacing), points[near])]
    squares = np.floor(points[near] / (settings.station_spacings * spacing)).astype(np.int64)
    _, of_point, counts = np.unique(squares, axis=0, return_inverse=True, return_counts=True)
    means = [np.bincount(of_point.reshape(-1), channel) / counts for channel in values[near].T]
    return float(np.linalg.norm([sigma_about_median(channel) for channel in means]))


def _positions(
    points: np.ndarray, outline: Polygon, spacing: float, settings: StepSettings
) -> tuple[np.ndarray, np.ndarray]:
    """Return the station along a border of each point, and the distance from it, positive within."""
    line = outline.exterior
    fine = 0.5 * spacing
    along = np.arange(0, line.length, fine)
    corners = np.array([line.interpolate(station).coords[0][:2] for station in along])
    distances, nearest = cKDTree(corners).query(points)
    signs = np.where(within(outline, points), 1.0, -1.0)
    length = max(settings.station_spacings * spacing, line.length / settings.most_stations)
    return np.floor(along[nearest] / length).astype(np.int64), signs * distances


def _medians(
    values: np.ndarray, stations: np.ndarray, distances: np.ndarray, spacing: float, settings: StepSettings
) -> _Stations:
    """Return the medians in the strips of the stations that have enough points on both sides."""
    count = int(stations.max(initial=-1)) + 1
    factors = settings.near_spacings, settings.middle_spacings, settings.far_spacings
    near, middle, far = (spacing * factor for factor in factors)
    strips = [
        (near, middle), (-middle, -near), (middle, far), (-far, -middle),
    ]  # fmt: skip
    found = []
    for low, high in strips:
        medians = np.full((count, values.shape[1]), np.nan)
        inside = np.flatnonzero((distances > low) & (distances < high))
        counts = np.bincount(stations[inside], minlength=count)
        enough = counts >= settings.fewest_points
        firsts = (np.cumsum(counts) - counts)[enough]
        low_half, high_half = firsts + (counts[enough] - 1) // 2, firsts + counts[enough] // 2
        for channel in range(values.shape[1]):
            ranked = values[inside[np.lexsort((values[inside, channel], stations[inside]))], channel]
            medians[enough, channel] = 0.5 * (ranked[low_half] + ranked[high_half])
        found.append(medians)
    both = np.isfinite(found[0][:, 0]) & np.isfinite(found[1][:, 0]) if count else np.zeros(0, bool)
    return _Stations(*(medians[both] for medians in found))
