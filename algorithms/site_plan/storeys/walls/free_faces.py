"""Faces that bound no room: facades, and walls beyond what was seen of floor and ceiling."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from ..division.outlines import parts_of, united
from ..evidence.footprint import Footprint
from ..evidence.levels import count_levels
from ..evidence.sheets import Sheet
from ..evidence.uprights_along import UprightsAlong
from ..settings import FreeFaceSettings, LevelSettings


def free_faces(
    sheets: Sequence[Sheet],
    rooms: BaseGeometry,
    faces: np.ndarray,
    uprights: UprightsAlong,
    footprint: Footprint,
    settings: FreeFaceSettings = FreeFaceSettings(),
    levels: LevelSettings = LevelSettings(),
) -> np.ndarray:
    """Return the full parts of sheets outside of all rooms.

    Parameters
    ----------
    sheets : sequence of Sheet
    rooms : Polygon or MultiPolygon
    faces : ndarray of float64, shape (n, 4)
        Faces that bound rooms; the solid lies to the left.
    uprights : UprightsAlong
    footprint : Footprint
    settings, levels : FreeFaceSettings, LevelSettings

    Returns
    -------
    ndarray of float64, shape (n, 4)
        x, y of both ends; the solid lies to the left: towards the other face of the wall, else where less
        was seen.
    """
    within = rooms.buffer(settings.apart_m)
    low, high = round(settings.from_m / levels.level_m), round(settings.to_m / levels.level_m)
    mask = ((1 << high) - 1) ^ ((1 << low) - 1)
    fewest = settings.filled * (high - low)
    found = []
    for sheet in sheets:
        outside = sheet.line.difference(within)
        for part in parts_of(outside):
            if part.length >= settings.run_m:
                found += _full_runs(np.asarray(part.coords), uprights, mask, fewest, settings.run_m)
    return np.array([_solid_left(run, faces, footprint, settings) for run in found]).reshape(-1, 4)


def screens(
    sheets: Sequence[Sheet],
    rooms: BaseGeometry,
    faces: np.ndarray,
    uprights: UprightsAlong,
    settings: FreeFaceSettings = FreeFaceSettings(),
    levels: LevelSettings = LevelSettings(),
) -> np.ndarray:
    """Return the thin walls that stand free in rooms, beside a stair for example.

    They are wider than a door's leaf, and stand farther from a wall than furniture and curtains do.
    Parameters and result are as those of `free_faces`; the side to the left is as good as the other.
    """
    inside = rooms.buffer(-settings.apart_m)
    low, high = round(settings.from_m / levels.level_m), round(settings.to_m / levels.level_m)
    mask, fewest = ((1 << high) - 1) ^ ((1 << low) - 1), settings.filled * (high - low)
    found = []
    for sheet in sheets:
        free = sheet.line.intersection(inside)
        for part in parts_of(free):
            if part.length >= settings.screen_m:
                ends = np.asarray(part.coords)
                runs = _full_runs(ends, uprights, mask, fewest, settings.screen_m)
                found += [run for run in runs if not has_wall_behind(run, faces, settings)]
    found = np.array(found).reshape(-1, 4)
    above_heads = -1 << round(settings.head_m / levels.level_m)
    middle = (found[:, :2] + found[:, 2:]) / 2
    # The railing of a stair is higher than heads at its upper end only.
    halves = np.hstack([found[:, :2], middle]), np.hstack([middle, found[:, 2:]])
    lower = np.min([uprights.mean_levels(half, above_heads) for half in halves], axis=0)
    return found[lower >= settings.head_levels]


def has_wall_behind(run: np.ndarray, faces: np.ndarray, settings: FreeFaceSettings) -> bool:
    """Return whether a face of a wall runs along a line, as near as furniture is deep."""
    along = (run[2:] - run[:2]) / np.hypot(*(run[2:] - run[:2]))
    beside = _overlaps(run, faces, along)
    along_it = (beside.cosine > settings.parallel_cosine) & (beside.overlap > settings.shortest_overlap_m)
    return bool((along_it & (np.abs(beside.across) < settings.furniture_m)).any())


def _full_runs(
    ends: np.ndarray, uprights: UprightsAlong, mask: int, fewest: float, shortest: float
) -> list[np.ndarray]:
    """Return the parts of a line on which enough levels are filled; each x, y, x, y."""
    bits, _ = uprights.stations(np.r_[ends[0], ends[-1]][None])
    full = count_levels(bits & np.uint64(mask)) >= fewest
    edges = np.flatnonzero(np.diff(np.r_[False, full, False].astype(int)))
    share = edges.reshape(-1, 2) / len(full)
    length = np.hypot(*(ends[-1] - ends[0]))
    runs = ends[0] + share[..., None] * (ends[-1] - ends[0])
    return [run.ravel() for run, (low, high) in zip(runs, share) if (high - low) * length >= shortest]


def _solid_left(
    run: np.ndarray, faces: np.ndarray, footprint: Footprint, settings: FreeFaceSettings
) -> np.ndarray:
    """Return a face with its ends in the order in which the solid lies to the left."""
    start, stop = run[:2], run[2:]
    along = (stop - start) / np.hypot(*(stop - start))
    left = np.array([-along[1], along[0]])
    opposite = _opposite(run, faces, along, settings)
    if opposite:
        return run if opposite > 0 else run[[2, 3, 0, 1]]
    stations = np.linspace(start, stop, 10)
    depths = np.linspace(0.2 * settings.front_m, settings.front_m, 6)
    sides = [
        _seen(footprint, np.concatenate([stations + sign * depth * left for depth in depths]))
        for sign in (1, -1)
    ]
    return run if sides[0] <= sides[1] else run[[2, 3, 0, 1]]


def _opposite(run: np.ndarray, faces: np.ndarray, along: np.ndarray, settings: FreeFaceSettings) -> float:
    """Return how far faces of rooms turn their solid to this one: positive from the left, else negative."""
    beside = _overlaps(run, faces, along)
    # The solid lies to the left of a face: one on the left turns it here if it runs the other way.
    facing = (beside.cosine > settings.parallel_cosine) & (beside.overlap > 0)
    facing &= np.abs(beside.across) < settings.thickest_m
    facing &= beside.way * beside.across < 0
    return float((np.sign(beside.across) * beside.overlap)[facing].sum())


@dataclass(frozen=True)
class _Beside:
    """How faces lie beside a line; arrays of shape (faces,)."""

    cosine: np.ndarray
    way: np.ndarray
    across: np.ndarray
    overlap: np.ndarray


def _overlaps(run: np.ndarray, faces: np.ndarray, along: np.ndarray) -> _Beside:
    direction = faces[:, 2:] - faces[:, :2]
    way = direction @ along / np.maximum(np.hypot(*direction.T), 1e-9)
    ends = np.stack([faces[:, :2], faces[:, 2:]], axis=1) - run[:2]
    extent, across = np.sort(ends @ along, axis=1), (ends @ np.array([-along[1], along[0]])).mean(axis=1)
    overlap = np.minimum(extent[:, 1], np.hypot(*(run[2:] - run[:2]))) - np.maximum(extent[:, 0], 0)
    return _Beside(np.abs(way), way, across, overlap)


def _seen(footprint: Footprint, xy: np.ndarray) -> float:
    row, column = footprint.frame.places(xy)
    rows, columns = footprint.weight.shape
    inside = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
    return float(np.nansum(footprint.weight[row[inside], column[inside]]))


def clear_before(faces: np.ndarray, depth: float) -> BaseGeometry:
    """Return the area right before faces, which is not wall."""
    boxes = []
    for x0, y0, x1, y1 in faces:
        length = np.hypot(x1 - x0, y1 - y0)
        x, y = depth * (y1 - y0) / length, -depth * (x1 - x0) / length
        boxes.append(Polygon([(x0, y0), (x1, y1), (x1 + x, y1 + y), (x0 + x, y0 + y)]))
    return united(boxes)
