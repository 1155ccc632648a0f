"""What the faces of a wall tell: thickness, coverage, rms, radius and azimuth."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import Point, Polygon
from shapely.prepared import prep

from ...geometry.azimuths import mean_line_azimuth
from ...geometry.curves import Arc
from .face import Side

STEP = 0.05
"""Distance (m) of the places at which the thickness is taken."""

THICKEST = 3.0
"""Opposite faces farther apart than this (m) are not those of one wall."""

SQUARE = 1.2
"""Faces are farther apart than so many times their length only if they are the two ends of a wall."""

PARALLEL = -0.97
"""Largest cosine between the directions of the two faces of a wall."""

FEWEST = 3
"""Fewest places at which both faces were seen; fewer tell no thickness."""

ROUND = 0.5
"""A wall has a radius if at least this share of its faces is round about one centre."""

CENTRES = 0.1
"""Centres that differ by less than this share of the radius are one."""


@dataclass(frozen=True)
class Measures:
    """Measures of a wall; None where they cannot be known.

    Attributes
    ----------
    thickness, thick_sd : float or None
        Median distance of opposite faces, and the standard deviation of the distances, metres.
    coverage : float
        Share of the outline on which there are points.
    rms : float or None
        Of the points about the faces, metres.
    radius : float or None
        Of the middle of a round wall, metres.
    azimuth : float or None
        Direction of the straight faces, degrees clockwise from grid north, 0..180.
    """

    thickness: Optional[float]
    thick_sd: Optional[float]
    coverage: float
    rms: Optional[float]
    radius: Optional[float]
    azimuth: Optional[float]


def measure(sides: list, outline: Polygon) -> Measures:
    """Measure a wall by its sides.

    Parameters
    ----------
    sides : list of Side
        That the outline runs along.
    outline : Polygon
        Of the wall.
    """
    seen = [side for side in sides if not side.back]
    if not seen:
        return Measures(None, None, 0.0, None, None, None)
    lengths = np.array([side.seen * side.length for side in seen])
    distances = _thicknesses(seen, outline)
    known = len(distances) >= FEWEST
    return Measures(
        thickness=float(np.median(distances)) if known else None,
        thick_sd=float(np.std(distances)) if known else None,
        coverage=float(min(lengths.sum() / outline.length, 1.0)),
        rms=float(np.sqrt(np.average([side.rms**2 for side in seen], weights=lengths))),
        radius=_radius(seen, lengths),
        azimuth=_azimuth(seen, lengths),
    )


def _thicknesses(sides: list, outline: Polygon) -> np.ndarray:
    """Return the distances from places on the sides to the nearest face behind them, through the wall."""
    inside = prep(outline)
    low, high = (np.array([bound(side.ridge, axis=0) for side in sides]) for bound in (np.min, np.max))
    found = []
    for k, side in enumerate(sides):
        count = max(int(side.length / STEP), 1)
        place = side.start + (np.arange(count) + 0.5) * side.length / count
        xy, heading = side.curve.at(place), side.curve.heading(side.curve.at(place))
        nearest = np.full(count, np.inf)
        for other in np.flatnonzero(((high >= low[k] - THICKEST) & (low <= high[k] + THICKEST)).all(axis=1)):
            if other != k:
                nearest = np.minimum(nearest, _distance_behind(xy, heading, sides[other]))
        near = nearest <= min(THICKEST, SQUARE * side.length)
        middle = xy[near] + nearest[near, None] / 2 * np.column_stack([-heading[near, 1], heading[near, 0]])
        found.append(nearest[near][np.array([inside.contains(Point(place)) for place in middle], bool)])
    return np.concatenate(found)


def _distance_behind(xy: np.ndarray, heading: np.ndarray, other: Side) -> np.ndarray:
    """Return how far a face is behind places of another; infinite where it is not, or not parallel."""
    opposite = (heading * other.curve.heading(xy)).sum(axis=1) <= PARALLEL
    place, distance = other.curve.station(xy), other.curve.offset(xy)
    behind = opposite & (distance > 0) & (place >= other.start) & (place <= other.stop)
    return np.where(behind, distance, np.inf)


def _radius(sides: list, lengths: np.ndarray) -> Optional[float]:
    """Return the middle between the outer and the inner radius of a round wall."""
    arcs = [(side.curve, length) for side, length in zip(sides, lengths) if isinstance(side.curve, Arc)]
    if not arcs:
        return None
    longest = max(arcs, key=lambda item: item[1])[0]
    near = CENTRES * longest.radius
    same = [(arc, length) for arc, length in arcs if np.hypot(*(arc.centre - longest.centre)) <= near]
    if sum(length for _, length in same) < ROUND * lengths.sum():
        return None
    means = [
        np.average([arc.radius for arc, _ in part], weights=[length for _, length in part])
        for part in ([item for item in same if item[0].sense == turn] for turn in (1, -1))
        if part
    ]
    return float(np.mean(means))


def _azimuth(sides: list, lengths: np.ndarray) -> Optional[float]:
    """Return the mean direction of the straight sides, by their squared lengths: ends hardly count."""
    straight = [
        (side.curve.direction, length**2)
        for side, length in zip(sides, lengths)
        if not isinstance(side.curve, Arc)
    ]
    return mean_line_azimuth(*zip(*straight)) if straight else None
