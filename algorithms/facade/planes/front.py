"""The side from which a facade is seen: the street, not the rooms behind the windows."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy import ndimage

from .inner_face import Face, find_face
from .settings import SideSettings

AUTOMATIC, EAST, WEST = 0, 1, 2
"""Values of SIDE: found from the points; towards the eastern half of the horizon; towards the western."""


@dataclass(frozen=True)
class Side:
    """The side from which a wall is seen.

    Attributes
    ----------
    sign : int
        1 if it is the side of the normal of the plane, -1 if it is the other side.
    sure : float
        0 where both sides are alike, 1 where there is no doubt.
    reason : str
        What decided, for the log.
    inner : Face or None
        The inner face of the wall, if the points show it.
    """

    sign: int
    sure: float
    reason: str
    inner: Optional[Face] = None


@dataclass(frozen=True)
class _Evidence:
    """What was seen on one side of a wall.

    Attributes
    ----------
    over : int
        Pixels of the wall that have points on this side.
    through : int
        Pixels of its holes that have points on this side.
    far : int
        Points far from the wall.
    face : Face or None
    """

    over: int
    through: int
    far: int
    face: Optional[Face]

    @property
    def share(self) -> float:
        """The part of the pixels with points that are pixels of the wall."""
        return self.over / max(self.over + self.through, 1)

    @property
    def covered(self) -> float:
        """The part of the wall that a parallel face covers."""
        return 0.0 if self.face is None else self.face.share


def find_side(
    uvw: np.ndarray,
    wall: np.ndarray,
    scanners: np.ndarray,
    settings: SideSettings = SideSettings(),
) -> Side:
    """Return the side from which a wall is seen.

    The scanners decide if their positions are known. Otherwise a parallel face close to the wall is its
    inner face. Otherwise points close behind a wall are only seen in its holes, and points before it
    are seen before the wall as well.

    Parameters
    ----------
    uvw : ndarray of float64, shape (n, 3)
        Of all points around the wall; w along the normal of its plane.
    wall : ndarray of bool, shape (n,)
        Which points are on the wall.
    scanners : ndarray of float64, shape (n,)
        w of the scanner that measured each point; nan where it is not known.
    settings : SideSettings
    """
    known = scanners[wall]
    known = known[np.isfinite(known)]
    if len(known):
        share = float(np.mean(known > 0))
        reason = (
            f"the scanners that measured {100 * max(share, 1 - share):.0f} % of the wall stood on that side"
        )
        return Side(1 if share >= 0.5 else -1, abs(2 * share - 1), reason, _inner(uvw, wall, share, settings))
    before, behind = (_evidence(uvw, wall, sign, settings) for sign in (1, -1))
    return _by_inner_face(before, behind, settings) or _by_holes(before, behind, settings)


def given_side(uvw: np.ndarray, wall: np.ndarray, settings: SideSettings = SideSettings()) -> Side:
    """Return the side of the normal, which the user has chosen, with the inner face of the wall.

    Parameters
    ----------
    uvw : ndarray of float64, shape (n, 3)
        Of all points around the wall; w along the normal of its plane.
    wall : ndarray of bool, shape (n,)
        Which points are on the wall.
    settings : SideSettings
    """
    return Side(1, 1.0, "SIDE says so", _inner(uvw, wall, 1.0, settings))


def _inner(uvw: np.ndarray, wall: np.ndarray, share: float, settings: SideSettings) -> Optional[Face]:
    behind = _evidence(uvw, wall, -1 if share >= 0.5 else 1, settings)
    return behind.face if behind.covered >= settings.covered else None


def _by_inner_face(before: _Evidence, behind: _Evidence, settings: SideSettings) -> Optional[Side]:
    """Return the side opposite the inner face; None if no parallel face covers enough of the wall."""
    sides = ((1, before, behind), (-1, behind, before))
    for sign, own, other in sides:
        face = other.face
        if face and other.covered >= settings.covered and other.covered >= settings.clearer * own.covered:
            reason = (
                f"{face.offset:.2f} m behind it a parallel surface, its inner face, covers "
                f"{100 * face.share:.0f} % of the wall, and one in front {100 * own.covered:.0f} %"
            )
            return Side(sign, 1 - own.covered * settings.clearer / other.covered, reason, face)
    return None


def _by_holes(before: _Evidence, behind: _Evidence, settings: SideSettings) -> Side:
    """Return the side opposite the one whose points are seen only in the holes of the wall."""
    least = settings.fewest_pixels
    # Without holes, or without anything beside the wall, both shares are 1.
    shares = [
        (own.over + least) / (own.over + own.through + least) if own.through else 1.0
        for own in (before, behind)
    ]
    sure = abs(shares[0] - shares[1])
    if sure >= settings.least_difference:
        sign = 1 if shares[0] > shares[1] else -1
        here, there = (before, behind) if sign == 1 else (behind, before)
        reason = (
            f"{100 - 100 * there.share:.0f} % of the pixels with points close behind the wall lie in its "
            f"holes, and {100 - 100 * here.share:.0f} % of those close in front"
        )
        return Side(sign, sure, reason)
    sign = 1 if before.far >= behind.far else -1
    reason = (
        f"most points far from the wall are on that side ({max(before.far, behind.far)} of "
        f"{before.far + behind.far}), and its holes do not show which side is the front"
    )
    return Side(sign, 0.0, reason)


def _evidence(uvw: np.ndarray, wall: np.ndarray, sign: int, settings: SideSettings) -> _Evidence:
    size = settings.pixel_m
    corner = uvw[wall, :2].min(axis=0) - size
    cells = np.floor((uvw[:, :2] - corner) / size).astype(np.int64)
    shape = tuple(cells[wall].max(axis=0) + 2)
    inside = ((cells >= 0) & (cells < shape)).all(axis=1)
    flat = np.where(inside, cells[:, 0] * shape[1] + cells[:, 1], -1)
    own = np.zeros(shape, bool)
    own.ravel()[flat[wall]] = True
    solid = ndimage.binary_erosion(ndimage.binary_closing(own), np.ones((3, 3)))
    holes = _enclosed(own) & ~ndimage.binary_dilation(ndimage.binary_closing(own), np.ones((3, 3)))
    distances = sign * uvw[:, 2]
    near = inside & (distances > settings.nearest_m) & (distances < settings.farthest_m)
    held = np.unique(flat[near])
    on = near & solid.ravel()[np.maximum(flat, 0)]
    face = find_face(flat[on], distances[on], int(own.sum()), settings)
    far = int(np.count_nonzero(inside & (distances > settings.far_m)))
    seen = np.zeros(shape, bool)
    seen.ravel()[held] = True
    # A bay in front fills one hole, as large as it is; windows are many.
    pieces, _ = ndimage.label(holes)
    counts = np.minimum(np.bincount(pieces[seen & holes]), settings.most_m2 / size**2)
    return _Evidence(int(solid.ravel()[held].sum()), int(counts.sum()), far, face)


def _enclosed(wall: np.ndarray) -> np.ndarray:
    """Return the pixels with the wall on at least three of their four sides."""
    sides = [np.logical_or.accumulate(wall, axis=axis) for axis in (0, 1)]
    sides += [np.logical_or.accumulate(wall[::-1], axis=0)[::-1]]
    sides += [np.logical_or.accumulate(wall[:, ::-1], axis=1)[:, ::-1]]
    return ~wall & (np.sum(sides, axis=0) >= 3)
