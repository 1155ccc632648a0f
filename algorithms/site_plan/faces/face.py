"""One side of a wall: a face, and the part of the outline that runs along it."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...geometry.circles import arc_through
from ...geometry.curves import Curve, line_through
from .face_fit import WIDE, Fit, fit_face
from .face_points import FacePoints
from .ridges import LEVELS, Ridges

PATCH = 0.05
"""Length (m) of the patches of a face, a level high, that count the same however many points they hold."""

OVERHANG = 0.15
"""How far (m) beyond the last ridge point a face is followed by its voxels."""

SOLID = 0.2
"""A face ends where its patches have less than this share of their usual number of levels: lintels go on."""

OUTERMOST = 3
"""It ends at the voxel that so many are not beyond; single voxels are noise."""

SHORTEST = 0.06
"""A face is at least so long, metres: a column of points is none."""

ROUGH, ROUGHEST = 0.015, 0.027
"""Faces with a larger rms (m) than the first may be foliage, and those with a larger than the second are."""

OPEN = 0.2
"""Before a face there are fewer voxels than this share of those on it; a bush is as full outside as in."""


@dataclass(frozen=True)
class Side:
    """A face and the part of a ring that runs along it.

    Attributes
    ----------
    curve : Line or Arc
    members : ndarray of int64, shape (n,)
        Places of the ring that lie on it, increasing; those past the ring's end count on.
    ridge : ndarray of float64, shape (n, 2)
        Their ridge points.
    start, stop : float
        Where the points of the face begin and end, as places along the curve, metres.
    rms : float
        Of the voxels about the curve, metres.
    back : bool
        Whether it is the back of a face that was seen from one side.
    """

    curve: Curve
    members: np.ndarray
    ridge: np.ndarray
    start: float
    stop: float
    rms: float
    back: bool = False

    @property
    def seen(self) -> float:
        """Share of the places from the first to the last that have a ridge point."""
        return len(self.members) / (self.members[-1] - self.members[0] + 1)

    @property
    def length(self) -> float:
        """Length in metres."""
        return self.stop - self.start


def fit_side(members: np.ndarray, curved: bool, ridges: Ridges, points: FacePoints) -> Optional[Side]:
    """Fit a face to the voxels beside places of a ring; None if there is none.

    Parameters
    ----------
    members : ndarray of int64, shape (n,)
        See `Side`.
    curved : bool
        Whether the face is round.
    ridges : Ridges
        Of the ring.
    points : FacePoints
    """
    ridge = ridges.xy[members % len(ridges.xy)]
    curve = arc_through(ridge) if curved else line_through(ridge)
    start, stop = curve.ends(ridge)
    if stop <= start:
        return None
    rows = points.near(ridge)
    place, offset = curve.station(points.xy[rows]), curve.offset(points.xy[rows])
    rows = rows[(place > start - OVERHANG) & (place < stop + OVERHANG) & (np.abs(offset) < 2 * OVERHANG)]
    xy, level, count = points.xy[rows], points.level[rows], points.count[rows]
    place = curve.station(xy)
    own = (place >= start) & (place <= stop)
    fit = fit_face(curve, xy[own], _area(place[own], level[own], count[own]))
    if fit is None:
        return None
    near = np.abs(fit.curve.offset(xy)) <= fit.reach
    fewest = min(LEVELS, points.levels)
    start, stop = _reach(fit.curve.station(xy[near]), level[near], fewest, *fit.curve.ends(ridge))
    if stop - start < SHORTEST or _is_foliage(fit, xy[own]):
        return None
    return Side(fit.curve, members, ridge, start, stop, fit.rms)


def _is_foliage(fit: Fit, xy: np.ndarray) -> bool:
    """Tell a bush, which has points before its densest line as well, from a rough face."""
    offset = fit.curve.offset(xy)
    before = np.count_nonzero((offset < -WIDE) & (offset > -2 * WIDE))
    full = before > OPEN * np.count_nonzero(np.abs(offset) < WIDE)
    return fit.rms > ROUGHEST or (fit.rms > ROUGH and full)


def _reach(place: np.ndarray, level: np.ndarray, fewest: int, start: float, stop: float) -> tuple:
    """Return where the voxels of a face begin and end, about where its ridge does."""
    patch = np.floor(place / PATCH).astype(np.int64)
    patches, levels = np.unique(np.unique(np.column_stack([patch, level]), axis=0)[:, 0], return_counts=True)
    solid = patches[levels >= max(SOLID * np.median(levels), fewest)]
    place = np.sort(place[np.isin(patch, solid)])
    if len(place) < 2 * OUTERMOST:
        return float(start), float(stop)
    return float(min(place[OUTERMOST - 1], stop)), float(max(place[-OUTERMOST], start))


def _area(place: np.ndarray, level: np.ndarray, count: np.ndarray) -> np.ndarray:
    """Return the share that each voxel has of the points of its patch."""
    patch = np.floor(place / PATCH).astype(np.int64)
    _, member = np.unique(patch * 64 + level, return_inverse=True)
    return count / np.bincount(member, count)[member]
