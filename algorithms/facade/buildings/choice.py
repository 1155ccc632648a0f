"""The facade that is drawn, and the points around it."""

from collections.abc import Iterator, Sequence
from typing import Optional

import numpy as np
from shapely.geometry.base import BaseGeometry

from ...errors import InputError
from .facades import Facade
from .settings import BuildingSettings

NOTHING = "No facade was found, so leave FACADE 0, and FACADE_NEAR and FACADE_ALONG empty."


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
        raise InputError(NOTHING)
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


def along(
    facades: Sequence[Facade],
    shapes: Sequence[BaseGeometry],
    settings: BuildingSettings = BuildingSettings(),
) -> tuple[Facade, ...]:
    """Return the facades along lines or the borders of polygons, the one with the most beside it first.

    Each shape has the facade along which most of it runs. Other facades belong to it if it runs along most of
    them: a polygon of a building has all its facades, and that of a wall has one.

    Parameters
    ----------
    facades : sequence of Facade
        By number.
    shapes : sequence of shapely geometry
        In plan, relative to the origin of the points.
    settings : BuildingSettings

    Raises
    ------
    InputError
        If there is no facade, or a shape runs along none.
    """
    if not facades:
        raise InputError(NOTHING)
    beside = np.zeros(len(facades))
    taken = np.zeros(len(facades), bool)
    for shape in shapes:
        lengths = _lengths_beside(facades, shape, settings)
        if not lengths.any():
            raise InputError(
                f"FACADE_ALONG has a line or a polygon without a facade within {settings.along_m:g} m; give "
                "it in the coordinates of the site, along the outside of the walls."
            )
        taken[np.argmax(lengths)] = True
        taken |= lengths >= settings.along_share * np.array([facade.length for facade in facades])
        beside += lengths
    order = np.argsort(-beside, kind="stable")
    return tuple(facades[number] for number in order if taken[number])


def _lengths_beside(facades: Sequence[Facade], shape: BaseGeometry, settings: BuildingSettings) -> np.ndarray:
    """Return how much of the lines of a shape runs along each facade, shape (facades,)."""
    lengths = np.zeros(len(facades))
    least = np.cos(np.radians(settings.along_deg))
    for start, stop in _lines(shape):
        whole = float(np.linalg.norm(stop - start))
        if whole == 0:
            continue
        pieces = max(int(np.ceil(whole / settings.along_step_m)), 1)
        middles = start + ((np.arange(pieces) + 0.5) / pieces)[:, None] * (stop - start)
        distances = np.full((len(facades), pieces), np.inf)
        for number, facade in enumerate(facades):
            if abs((stop - start) @ facade.axes[0]) >= least * whole:
                distances[number] = _distances(facade, middles)
        nearest = distances.argmin(axis=0)
        near = distances.min(axis=0) <= settings.along_m
        lengths += np.bincount(nearest[near], minlength=len(facades)) * whole / pieces
    return lengths


def _lines(shape: BaseGeometry) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the ends of the straight pieces of lines, and of the outer borders of polygons."""
    for part in getattr(shape, "geoms", [shape]):
        corners = np.array(getattr(part, "exterior", part).coords)[:, :2]
        yield from zip(corners[:-1], corners[1:])


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
    return float(_distances(facade, places).mean())


def _distances(facade: Facade, places: np.ndarray) -> np.ndarray:
    """Return the distances of places in plan from a facade, shape (k,)."""
    start, stop = facade.ends
    along = stop - start
    share = np.clip((places - start) @ along / (along @ along), 0, 1)
    return np.asarray(np.linalg.norm(places - start - share[:, None] * along, axis=1))
