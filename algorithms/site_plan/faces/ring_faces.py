"""The sides of a wall along one ring of its outline."""

from dataclasses import dataclass
from typing import Callable, Optional

import numpy as np

from ...geometry.curves import Arc
from .face import Side, fit_side
from .face_points import FacePoints
from .ridge_segments import cut_into_pieces, scatter_of
from .ridges import Places, Ridges, find_ridges, places_along

GAP = 0.4
"""A face goes on behind what hides it for up to this length (m) of an outline."""

SAME_WAY = 0.9
"""Least cosine of the directions of two pieces that may be one face."""

NO_WORSE = 1.15
"""Two pieces are one face if it fits their points with at most so many times their rms, and each on average
lies within that of it: what parts them is then the relief of the face."""


@dataclass(frozen=True)
class RingSides:
    """A ring of an outline, and its sides in the ring's order.

    Attributes
    ----------
    places : Places
    step : float
        Distance of the places, metres.
    sides : tuple of Side
    closed : bool
        Whether a single side goes all the way round.
    """

    places: Places
    step: float
    sides: tuple
    closed: bool = False


def find_sides(ring: np.ndarray, points: FacePoints, pixel_size: float) -> RingSides:
    """Find the sides of a ring, shape (n + 1, 2), the wall to its left."""
    places = places_along(ring, pixel_size)
    ridges = find_ridges(places, points, pixel_size)
    step = float(np.hypot(*np.diff(ring, axis=0).T).sum() / len(places.xy))
    found = np.flatnonzero(ridges.found)
    pieces = _pieces(found, ridges, step)
    if pieces:
        # The row is cut where a piece begins, and looked at again, so that its beginning is no corner.
        begin = np.searchsorted(found, pieces[len(pieces) // 2][0][0])
        found = np.r_[found[begin:], found[:begin] + len(places.xy)]
        pieces = _pieces(found, ridges, step)

    def fit(members: np.ndarray, curved: bool) -> Optional[Side]:
        return fit_side(members, curved, ridges, points)

    sides = [side for side in (fit(members, curved) for members, curved in pieces) if side is not None]
    sides = tuple(_joined(sides, fit, round(GAP / step)))
    return RingSides(places, step, sides, _goes_round(sides, len(places.xy), step))


def _pieces(found: np.ndarray, ridges: Ridges, step: float) -> list:
    """Return the places of each piece, and whether it is curved."""
    sigma = scatter_of(ridges.xy[found % len(ridges.xy)])
    pieces = []
    for row in np.split(found, np.flatnonzero(np.diff(found) * step > GAP) + 1):
        rows = row % len(ridges.xy)
        cut = cut_into_pieces(ridges.xy[rows], ridges.direction[rows], sigma)
        pieces += [(row[piece.first : piece.last + 1], piece.curved) for piece in cut]
    return pieces


def _joined(sides: list, fit: Callable, gap: int) -> list:
    """Join neighbours that are pieces of one face."""
    k = 0
    while k + 1 < len(sides):
        joined = _join(sides[k], sides[k + 1], fit, gap)
        if joined is None:
            k += 1
        else:
            sides[k : k + 2] = [joined]
            k = max(k - 1, 0)
    return sides


def _join(one: Side, other: Side, fit: Callable, gap: int) -> Optional[Side]:
    curved = isinstance(one.curve, Arc)
    if curved != isinstance(other.curve, Arc) or other.members[0] - one.members[-1] > gap:
        return None
    ways = one.curve.heading(one.ridge[-1]) @ other.curve.heading(other.ridge[0])
    if ways < SAME_WAY:
        return None
    joined = fit(np.r_[one.members, other.members], curved)
    if joined is None:
        return None
    weights = len(one.members), len(other.members)
    apart = np.sqrt(np.average([one.rms**2, other.rms**2], weights=weights))
    shift = max(abs(np.median(joined.curve.offset(side.ridge))) for side in (one, other))
    return joined if max(joined.rms, shift) <= NO_WORSE * apart else None


def _goes_round(sides: tuple, count: int, step: float) -> bool:
    if len(sides) != 1:
        return False
    free = count - (sides[0].members[-1] - sides[0].members[0])
    return isinstance(sides[0].curve, Arc) and free * step < GAP
