"""The facade of a cloud that is measured, with what stands around it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..progress import Progress
from .buildings.choice import around, choose
from .buildings.facades import Facade, find_facades
from .elevation import Plane, Points
from .settings import FacadeSettings


@dataclass(frozen=True)
class Selection:
    """A facade, chosen among all of a cloud.

    Attributes
    ----------
    facades : tuple of Facade
        All, by number.
    chosen : Facade or None
        None if none was found, so that the cloud is measured as it is.
    points : Points
        Of the chosen facade, and of what stands near, before and behind it.
    even : ndarray of float64, shape (k, 2)
        Points of the whole cloud in plan, for the key plan.
    """

    facades: tuple[Facade, ...]
    chosen: Optional[Facade]
    points: Points
    even: np.ndarray

    @property
    def plane(self) -> Optional[Plane]:
        """The plane that becomes the main one; None if no facade was found."""
        if self.chosen is None:
            return None
        return Plane(self.chosen.normal, self.chosen.anchor, float("nan"), self.chosen.points)


def select_facade(
    points: Points,
    settings: FacadeSettings = FacadeSettings(),
    number: int = 0,
    near: Optional[Sequence[float]] = None,
    progress: Progress = Progress(),
) -> Selection:
    """Find the facades of a cloud, and return one of them.

    Parameters
    ----------
    points : Points
    settings : FacadeSettings
    number : int
        FACADE: of the facade; 0 for the one that most points see.
    near : sequence of 2 float, optional
        FACADE_NEAR: x, y in the coordinates of the site; the nearest facade is taken.
    progress : Progress

    Raises
    ------
    InputError
        If there is no such facade.
    """
    limits = settings.buildings
    facades = find_facades(
        points.xyz, points.scan, points.stations, settings.distance_m, limits, progress.part(0.0, 0.9)
    )
    even = _in_plan(points.xyz, limits.key_m)
    if not facades and near is None and number <= 1:
        return Selection((), None, points, even)
    place = None if near is None else np.reshape(near, (-1, 2)) - points.origin[:2]
    chosen = choose(facades, number, place, limits)
    if len(facades) == 1:
        return Selection(facades, chosen, points, even)
    progress.update(
        1.0,
        f"{len(facades)} facades were found; number {chosen.number} is measured: {chosen.length:.1f} m long, "
        f"{chosen.height:.1f} m high, azimuth {chosen.azimuth:.0f} degrees. FACADE takes another one.",
    )
    return Selection(facades, chosen, points.subset(around(points.xyz, chosen, limits)), even)


def _in_plan(xyz: np.ndarray, size: float) -> np.ndarray:
    """Return the middles of the squares of `size` (m) that hold points."""
    return (np.unique(np.floor(xyz[:, :2] / size).astype(np.int64), axis=0) + 0.5) * size
