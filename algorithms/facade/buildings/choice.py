"""The facade that is drawn, and the points around it."""

from collections.abc import Sequence
from typing import Optional

import numpy as np

from ...errors import InputError
from .facades import Facade
from .settings import BuildingSettings


def choose(
    facades: Sequence[Facade],
    number: int = 0,
    near: Optional[np.ndarray] = None,
    settings: BuildingSettings = BuildingSettings(),
) -> Facade:
    """Return one of the facades.

    Parameters
    ----------
    facades : sequence of Facade
        By number.
    number : int
        Of the facade; 0 for the one that most points see, or the largest if no scanner's position is known.
    near : ndarray of float64, shape (k, 2), optional
        A point, or the corners of a line, in plan: the facade nearest to it on average is taken.

    settings : BuildingSettings

    Raises
    ------
    InputError
        If there is no facade of that number, or none near the point.
    """
    if not facades:
        raise InputError("No facade was found, so leave FACADE 0 and FACADE_NEAR empty.")
    if near is not None:
        nearest = min(facades, key=lambda facade: _distance(facade, near))
        if _distance(nearest, near) > settings.nearest_m:
            raise InputError(
                f"FACADE_NEAR is {_distance(nearest, near):.0f} m from the nearest facade; give it in the "
                "coordinates of the site."
            )
        return nearest
    if number > len(facades):
        raise InputError(
            f"FACADE is {number}, but the cloud has {len(facades)} facades; choose one from 1 to "
            f"{len(facades)} in the report, or 0."
        )
    return facades[max(number, 1) - 1]


def around(xyz: np.ndarray, facade: Facade, settings: BuildingSettings = BuildingSettings()) -> np.ndarray:
    """Return the rows of a facade's points and of what stands near, before and behind it.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
    facade : Facade
    settings : BuildingSettings
    """
    places = (xyz[:, :2] - facade.ends[0]) @ facade.axes.T
    beside, away = places.T
    return np.flatnonzero(
        (beside > -settings.around_m)
        & (beside < facade.length + settings.around_m)
        & (away > -settings.behind_m)
        & (away < settings.before_m)
    )


def _distance(facade: Facade, places: np.ndarray) -> float:
    start, stop = facade.ends
    along = stop - start
    share = np.clip((places - start) @ along / (along @ along), 0, 1)
    return float(np.linalg.norm(places - start - share[:, None] * along, axis=1).mean())
