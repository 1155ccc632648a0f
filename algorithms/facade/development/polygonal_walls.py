"""The sides of a bay or a polygonal tower in plan: upright planes whose ends meet."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..elevation import Plane
from ..planes.patches import Patch, extract
from ..planes.voxels import make_voxels
from .curves import Chain
from .settings import SidesSettings


@dataclass(frozen=True)
class _Side:
    """A side in plan.

    Attributes
    ----------
    start, stop : ndarray of float64, shape (2,)
        Its left and right end, as seen from outside.
    height : float
        From its lowest to its highest point (m).
    """

    start: np.ndarray
    stop: np.ndarray
    height: float

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.stop - self.start))

    @property
    def right(self) -> np.ndarray:
        return np.asarray((self.stop - self.start) / self.length)


def find_sides(
    xyz: np.ndarray, wanted: Optional[Plane], distance: float, settings: SidesSettings = SidesSettings()
) -> Optional[Chain]:
    """Return the chain of sides that meet, with the main one; None if the wall does not turn.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
    wanted : Plane, optional
        About the main side, its normal outward; the largest upright plane if not given.
    distance : float
        ds, the largest distance of a point from its plane (m).
    settings : SidesSettings
    """
    voxels = make_voxels(xyz, settings.cube_m, settings.planes.voxels)
    steep = np.sin(np.radians(settings.upright_deg))
    found = [patch for patch in extract(voxels, distance, settings.planes) if abs(patch.normal[2]) < steep]
    if wanted is not None:
        found.sort(key=lambda patch: (not _is_like(patch, wanted, distance), -patch.area))
    if not found:
        return None
    outward = found[0].normal if wanted is None else wanted.normal
    runs = _runs(found[0], outward, settings)
    if not runs:
        return None
    main = max(runs, key=lambda side: side.length)
    others = [side for side in runs if side is not main]
    others += [side for patch in found[1:] for side in _runs(patch, None, settings)]
    others = [
        side
        for side in others
        if side.length >= settings.narrowest_m and side.height >= settings.least_height * main.height
    ]
    left = _grown(main, others, -1, settings)
    right = _grown(main, others, 1, settings)
    if not left and not right:
        return None
    sides = [*left[::-1], main, *right]
    corners = [_corner(one, other) for one, other in zip(sides[:-1], sides[1:])]
    return Chain(np.array([sides[0].start, *corners, sides[-1].stop]), len(left))


def _is_like(patch: Patch, wanted: Plane, distance: float) -> bool:
    """Whether a plane is about the wanted one."""
    away = np.median(np.abs(wanted.distances(patch.centres_of_squares())))
    return bool(abs(patch.normal @ wanted.normal) > np.cos(np.radians(10)) and away <= 2 * distance)


def _runs(patch: Patch, outward: Optional[np.ndarray], settings: SidesSettings) -> list[_Side]:
    """Return a plane in plan, in the runs that a bay before it leaves; above the bay it may go on.

    The ends of a run are in order only if its outward side is known.
    """
    level = patch.normal[:2] / np.linalg.norm(patch.normal[:2])
    if outward is not None and level @ outward[:2] < 0:
        level = -level
    right = np.array([-level[1], level[0]])
    squares = patch.centres_of_squares()
    along = (squares[:, :2] - patch.anchor[:2]) @ right
    columns = np.floor((along - along.min()) / patch.side + 0.5).astype(np.int64)
    counts = np.bincount(columns)
    height = float(np.ptp(squares[:, 2]))
    walled = np.flatnonzero(counts * patch.side >= settings.walled * height)
    if not len(walled):
        return []
    breaks = np.flatnonzero(np.diff(walled) * patch.side > settings.gap_m) + 1
    sides = []
    for run in np.split(walled, breaks):
        ends = along.min() + patch.side * np.array([run[0] - 0.5, run[-1] + 0.5])
        start, stop = patch.anchor[:2] + ends[:, None] * right
        sides.append(_Side(start, stop, height))
    return sides


def _grown(main: _Side, others: Sequence[_Side], sense: int, settings: SidesSettings) -> list[_Side]:
    """Return the sides beyond the right end (sense 1) or the left end (-1), one after the other."""
    chain, left = [main], list(others)
    while True:
        candidates = []
        for number, other in enumerate(left):
            for turned in (other, _Side(other.stop, other.start, other.height)):
                gap = _gap(chain[-1], turned, sense, settings)
                if gap is not None:
                    candidates.append((gap, number, turned))
        if not candidates:
            return chain[1:]
        _, number, found = min(candidates, key=lambda item: item[:2])
        chain.append(found)
        del left[number]


def _gap(side: _Side, other: _Side, sense: int, settings: SidesSettings) -> Optional[float]:
    """Return how far two sides end from the corner between them; None if they do not meet there."""
    turn = float(np.degrees(np.arccos(np.clip(side.right @ other.right, -1, 1))))
    if not settings.least_deg <= turn <= settings.most_deg:
        return None
    corner = _corner(side, other)
    ends = (side.stop, other.start) if sense > 0 else (side.start, other.stop)
    # Positive beyond the corner: behind the oblique side of a bay, its wall may go on.
    beyond = [sense * float((ends[0] - corner) @ side.right), sense * float((corner - ends[1]) @ other.right)]
    if any(not -settings.corner_m <= length <= settings.beyond_m for length in beyond):
        return None
    return max(map(abs, beyond))


def _corner(one: _Side, other: _Side) -> np.ndarray:
    """Return where the lines of two sides cross."""
    factors = np.linalg.solve(np.column_stack([one.right, -other.right]), other.start - one.start)
    return np.asarray(one.start + factors[0] * one.right)
