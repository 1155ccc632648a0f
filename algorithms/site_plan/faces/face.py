"""A face of a wall, and the part of a ring of an outline that runs along it."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.circles import arc_through
from ...geometry.curves import Curve, line_through
from .face_fit import CurveFit, fit_curve
from .face_points import FacePoints
from .ridges import Ridges
from .settings import FaceExtentSettings, FaceSettings


@dataclass(frozen=True)
class Face:
    """A face and the part of a ring that runs along it.

    Attributes
    ----------
    curve : Line or Arc
        The wall is to its left.
    members : ndarray of int64, shape (n,)
        Stations of the ring that lie on it, increasing; those past the ring's end count on.
    ridge : ndarray of float64, shape (n, 2)
        Their ridge points.
    start, stop : float
        Where the points of the face begin and end, as stations of the curve, metres.
    rms : float
        Of the voxels about the curve, metres.
    hidden : bool
        Whether it is the back of a face that was seen from one side only.
    """

    curve: Curve
    members: np.ndarray
    ridge: np.ndarray
    start: float
    stop: float
    rms: float
    hidden: bool = False

    @property
    def seen(self) -> float:
        """Share of the stations from the first to the last that have a ridge point."""
        return len(self.members) / (self.members[-1] - self.members[0] + 1)

    @property
    def length(self) -> float:
        """Length in metres."""
        return self.stop - self.start


def fit_face(
    members: np.ndarray,
    curved: bool,
    ridges: Ridges,
    points: FacePoints,
    settings: FaceSettings = FaceSettings(),
) -> Optional[Face]:
    """Fit a face to the voxels beside stations of a ring; None if they show no face.

    Parameters
    ----------
    members : ndarray of int64, shape (n,)
        See `Face`.
    curved : bool
        Whether the face is round.
    ridges : Ridges
        Of the ring.
    points : FacePoints
    settings : FaceSettings
    """
    extent = settings.extent
    ridge = ridges.xy[members % len(ridges.xy)]
    curve = arc_through(ridge) if curved else line_through(ridge)
    if curve is None:
        return None
    start, stop = curve.ends(ridge)
    if stop <= start:
        return None
    rows = points.near(ridge)
    station, offset = curve.station(points.xy[rows]), curve.offset(points.xy[rows])
    beside = (station > start - extent.overhang_m) & (station < stop + extent.overhang_m)
    rows = rows[beside & (np.abs(offset) < 2 * extent.overhang_m)]
    xy, level, count = points.xy[rows], points.level[rows], points.count[rows]
    station = curve.station(xy)
    own = (station >= start) & (station <= stop)
    area = _area(station[own], level[own], count[own], extent.patch_m)
    fit = fit_curve(curve, xy[own], area, settings.fit)
    if fit is None:
        return None
    near = np.abs(fit.curve.offset(xy)) <= fit.reach
    fewest = min(settings.ridges.fewest_levels, points.levels)
    start, stop = _reach(fit.curve.station(xy[near]), level[near], fewest, fit.curve.ends(ridge), extent)
    if stop - start < extent.shortest_m or _is_foliage(fit, xy[own], settings):
        return None
    return Face(fit.curve, members, ridge, start, stop, fit.rms)


def _is_foliage(fit: CurveFit, xy: np.ndarray, settings: FaceSettings) -> bool:
    """Return whether points belong to a bush: unlike a rough face, it has points before its densest line."""
    extent, wide = settings.extent, settings.fit.wide_m
    offset = fit.curve.offset(xy)
    before = np.count_nonzero((offset < -wide) & (offset > -2 * wide))
    full = before > extent.open_share * np.count_nonzero(np.abs(offset) < wide)
    return fit.rms > extent.roughest_m or (fit.rms > extent.rough_m and full)


def _reach(
    station: np.ndarray, level: np.ndarray, fewest: int, ends: np.ndarray, settings: FaceExtentSettings
) -> tuple[float, float]:
    """Return where the voxels of a face begin and end, near the ends of its ridge."""
    start, stop = ends
    patch = np.floor(station / settings.patch_m).astype(np.int64)
    patches, levels = np.unique(np.unique(np.column_stack([patch, level]), axis=0)[:, 0], return_counts=True)
    solid = patches[levels >= max(settings.solid_share * np.median(levels), fewest)]
    station = np.sort(station[np.isin(patch, solid)])
    outermost = settings.outermost_voxels
    if len(station) < 2 * outermost:
        return float(start), float(stop)
    return float(min(station[outermost - 1], stop)), float(max(station[-outermost], start))


def _area(station: np.ndarray, level: np.ndarray, count: np.ndarray, patch_m: float) -> np.ndarray:
    """Return the share that each voxel has of the points of its patch."""
    patch = np.floor(station / patch_m).astype(np.int64)
    _, member = np.unique(patch * 64 + level, return_inverse=True)
    return count / np.bincount(member, count)[member]
