"""The measures of a wall by its faces: thickness, coverage, rms, radius and azimuth."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import Point, Polygon
from shapely.prepared import prep

from ...geometry.azimuths import mean_line_azimuth
from ...geometry.curves import Arc
from .face import Face
from .settings import MeasureSettings


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


def measure(
    faces: Sequence[Face], outline: Polygon, settings: MeasureSettings = MeasureSettings()
) -> Measures:
    """Measure a wall by its faces.

    Parameters
    ----------
    faces : sequence of Face
        Along which the outline runs.
    outline : Polygon
        Of the wall.
    settings : MeasureSettings
    """
    seen = [face for face in faces if not face.hidden]
    if not seen:
        return Measures(None, None, 0.0, None, None, None)
    lengths = np.array([face.seen * face.length for face in seen])
    distances = _thicknesses(seen, outline, settings)
    known = len(distances) >= settings.fewest_stations
    return Measures(
        thickness=float(np.median(distances)) if known else None,
        thick_sd=float(np.std(distances)) if known else None,
        coverage=float(min(lengths.sum() / outline.length, 1.0)),
        rms=float(np.sqrt(np.average([face.rms**2 for face in seen], weights=lengths))),
        radius=_radius(seen, lengths, settings),
        azimuth=_azimuth(seen, lengths),
    )


def _thicknesses(faces: Sequence[Face], outline: Polygon, settings: MeasureSettings) -> np.ndarray:
    """Return the distances from stations on the faces to the nearest face behind them, through the wall."""
    inside, thickest = prep(outline), settings.sizes.thickest_m
    low, high = (np.array([bound(face.ridge, axis=0) for face in faces]) for bound in (np.min, np.max))
    found = []
    for k, face in enumerate(faces):
        count = max(int(face.length / settings.step_m), 1)
        station = face.start + (np.arange(count) + 0.5) * face.length / count
        xy, heading = face.curve.at(station), face.curve.heading(face.curve.at(station))
        nearest = np.full(count, np.inf)
        for other in np.flatnonzero(((high >= low[k] - thickest) & (low <= high[k] + thickest)).all(axis=1)):
            if other != k:
                behind = _distance_behind(xy, heading, faces[other], settings)
                nearest = np.minimum(nearest, behind)
        near = nearest <= min(thickest, settings.square * face.length)
        middle = xy[near] + nearest[near, None] / 2 * np.column_stack([-heading[near, 1], heading[near, 0]])
        found.append(nearest[near][np.array([inside.contains(Point(point)) for point in middle], bool)])
    return np.concatenate(found)


def _distance_behind(
    xy: np.ndarray, heading: np.ndarray, other: Face, settings: MeasureSettings
) -> np.ndarray:
    """Return how far a face is behind points of another; infinite where it is not, or not parallel."""
    opposite = (heading * other.curve.heading(xy)).sum(axis=1) <= settings.largest_cosine
    station, distance = other.curve.station(xy), other.curve.offset(xy)
    behind = opposite & (distance > 0) & (station >= other.start) & (station <= other.stop)
    return np.where(behind, distance, np.inf)


def _radius(faces: Sequence[Face], lengths: np.ndarray, settings: MeasureSettings) -> Optional[float]:
    """Return the middle between the outer and the inner radius of a round wall."""
    arcs = [(face.curve, length) for face, length in zip(faces, lengths) if isinstance(face.curve, Arc)]
    if not arcs:
        return None
    longest = max(arcs, key=lambda item: item[1])[0]
    near = settings.centre_share * longest.radius
    same = [(arc, length) for arc, length in arcs if np.hypot(*(arc.centre - longest.centre)) <= near]
    if sum(length for _, length in same) < settings.round_share * lengths.sum():
        return None
    means = [
        np.average([arc.radius for arc, _ in part], weights=[length for _, length in part])
        for part in ([item for item in same if item[0].sense == sense] for sense in (1, -1))
        if part
    ]
    return float(np.mean(means))


def _azimuth(faces: Sequence[Face], lengths: np.ndarray) -> Optional[float]:
    """Return the mean direction of the straight faces, by their squared lengths: ends hardly count."""
    straight = [
        (face.curve.direction, length**2)
        for face, length in zip(faces, lengths)
        if not isinstance(face.curve, Arc)
    ]
    return mean_line_azimuth(*zip(*straight)) if straight else None
