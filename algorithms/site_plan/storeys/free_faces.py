"""Faces that bound no room: facades, and walls beyond what was seen of floor and ceiling."""

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.ops import unary_union

from .evidence import UprightsAlong
from .footprint import Footprint
from .levels import count_levels
from .settings import FreeFaceSettings, LevelSettings


def free_faces(
    sheets: list,
    rooms,
    uprights: UprightsAlong,
    footprint: Footprint,
    settings: FreeFaceSettings = FreeFaceSettings(),
    levels: LevelSettings = LevelSettings(),
) -> np.ndarray:
    """Return the full parts of sheets outside of all rooms.

    Parameters
    ----------
    sheets : list of Sheet
    rooms : Polygon or MultiPolygon
    uprights : UprightsAlong
    footprint : Footprint
    settings, levels : FreeFaceSettings, LevelSettings

    Returns
    -------
    ndarray of float64, shape (n, 4)
        x, y of both ends; the side on which less was seen lies to the left.
    """
    within = rooms.buffer(settings.apart_m)
    low, high = round(settings.from_m / levels.level_m), round(settings.to_m / levels.level_m)
    mask = ((1 << high) - 1) ^ ((1 << low) - 1)
    fewest = settings.filled * (high - low)
    found = []
    for sheet in sheets:
        outside = LineString([sheet.start, sheet.stop]).difference(within)
        for part in getattr(outside, "geoms", [outside]):
            if part.length >= settings.run_m:
                found += _full_runs(np.asarray(part.coords), uprights, mask, fewest, settings.run_m)
    return np.array([_turned(run, footprint, settings.front_m) for run in found]).reshape(-1, 4)


def _full_runs(ends: np.ndarray, uprights: UprightsAlong, mask: int, fewest: float, shortest: float) -> list:
    """Return the parts of a line on which enough levels are filled; each x, y, x, y."""
    bits, _ = uprights.stations(np.r_[ends[0], ends[-1]][None])
    full = count_levels(bits & np.uint64(mask)) >= fewest
    edges = np.flatnonzero(np.diff(np.r_[False, full, False].astype(int)))
    share = edges.reshape(-1, 2) / len(full)
    length = np.hypot(*(ends[-1] - ends[0]))
    places = ends[0] + share[..., None] * (ends[-1] - ends[0])
    return [place.ravel() for place, (low, high) in zip(places, share) if (high - low) * length >= shortest]


def _turned(run: np.ndarray, footprint: Footprint, front: float) -> np.ndarray:
    """Turn a face so that the side of which less was seen lies to the left."""
    start, stop = run[:2], run[2:]
    x, y = (stop - start) / np.hypot(*(stop - start))
    places = np.linspace(start, stop, 10)
    sides = [
        _seen(footprint, np.concatenate([places + sign * d * np.array([-y, x]) for d in np.linspace(0.06, front, 6)]))
        for sign in (1, -1)
    ]
    return run if sides[0] <= sides[1] else run[[2, 3, 0, 1]]


def _seen(footprint: Footprint, places: np.ndarray) -> float:
    row, column = footprint.frame.places(places)
    rows, columns = footprint.weight.shape
    inside = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
    return float(np.nansum(footprint.weight[row[inside], column[inside]]))


def clear_before(faces: np.ndarray, depth: float):
    """Return the area right before faces, which is no wall."""
    boxes = []
    for x0, y0, x1, y1 in faces:
        length = np.hypot(x1 - x0, y1 - y0)
        x, y = depth * (y1 - y0) / length, -depth * (x1 - x0) / length
        boxes.append(Polygon([(x0, y0), (x1, y1), (x1 + x, y1 + y), (x0 + x, y0 + y)]))
    return unary_union(boxes)
