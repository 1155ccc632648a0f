"""The facade of a cloud that is measured, with what stands around it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
import pandas as pd
from shapely.affinity import translate
from shapely.geometry.base import BaseGeometry

from ..progress import Progress
from .buildings.choice import along, around, choose
from .buildings.facades import Facade, find_facades
from .development.development import FLAT, Development, develop
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
    wanted : tuple of Facade
        Those that ALL draws, by number.
    whole : Points
        Of the cloud.
    rows : ndarray of int64, or None
        Of the points of the chosen facade, and of what stands near, before and behind it; None for all.
    even : ndarray of float64, shape (k, 2)
        Points of the whole cloud in plan, for the key plan.
    development : Development or None
        How the points are rolled out before they are measured; None for a flat facade.
    """

    facades: tuple[Facade, ...]
    chosen: Optional[Facade]
    wanted: tuple[Facade, ...]
    whole: Points
    rows: Optional[np.ndarray]
    even: np.ndarray
    development: Optional[Development] = None

    @property
    def points(self) -> Points:
        """The points that are measured; copied at each call, so that facades that wait take no memory."""
        points = self.whole if self.rows is None else self.whole.subset(self.rows)
        return points if self.development is None else self.development.flat(points)

    @property
    def plane(self) -> Optional[Plane]:
        """The plane that becomes the main one; None if no facade was found."""
        if self.development is not None:
            return self.development.plane
        if self.chosen is None:
            return None
        return Plane(self.chosen.normal, self.chosen.anchor, float("nan"), self.chosen.points)

    def unrolled(self, settings: FacadeSettings = FacadeSettings()) -> "Selection":
        """Return the facade as UNROLL wants it: as it is, or rolled out.

        Raises
        ------
        NothingFoundError
            If its wall does not turn.
        """
        if settings.unroll == FLAT:
            return self
        rows = None
        if self.chosen is not None:
            wide = replace(settings.buildings, around_m=settings.development.reach_m)
            rows = around(self.whole.xyz, self.chosen, wide)
        points = self.whole if rows is None else self.whole.subset(rows)
        found = develop(points, settings.unroll, self.plane, settings.distance_m, settings.development)
        return replace(self, rows=rows, development=found)

    def of(self, facade: Facade, settings: FacadeSettings = FacadeSettings()) -> "Selection":
        """Return the same cloud with another facade chosen."""
        if len(self.facades) == 1:
            return replace(self, development=None)
        rows = around(self.whole.xyz, facade, settings.buildings)
        return replace(self, chosen=facade, rows=rows, development=None)


def select_facade(
    points: Points,
    settings: FacadeSettings = FacadeSettings(),
    number: int = 0,
    near: Optional[Sequence[float]] = None,
    shapes: Sequence[BaseGeometry] = (),
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
    shapes : sequence of shapely geometry
        FACADE_ALONG: lines and polygons in the coordinates of the site; the facade along them is taken, and
        those along them are wanted.
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
    if not facades and near is None and number <= 1 and not shapes:
        return Selection((), None, (), points, None, even)
    x, y = -points.origin[:2]
    beside = along(facades, [translate(shape, x, y) for shape in shapes], limits) if shapes else facades
    if shapes and near is None and number == 0:
        chosen = beside[0]
    else:
        place = None if near is None else np.reshape(near, (-1, 2)) - points.origin[:2]
        chosen = choose(facades, number, place, limits)
    wanted = tuple(sorted(beside, key=lambda facade: facade.number))
    selection = Selection(facades, chosen, wanted, points, None, even)
    if len(facades) == 1:
        return selection
    progress.update(
        1.0,
        f"{len(facades)} facades were found; number {chosen.number} is measured: {chosen.length:.1f} m long, "
        f"{chosen.height:.1f} m high, azimuth {chosen.azimuth:.0f} degrees. FACADE takes another one.",
    )
    return selection.of(chosen, settings)


def _in_plan(xyz: np.ndarray, size: float) -> np.ndarray:
    """Return the middles of the squares of `size` (m) that hold points."""
    cells = np.floor(xyz[:, :2] / size).astype(np.int64)
    corner = cells.min(axis=0)
    columns, rows = (cells - corner).T
    height = rows.max() + 1
    held = np.sort(pd.unique(columns * height + rows))
    return (np.stack([held // height, held % height], axis=1) + corner + 0.5) * size
