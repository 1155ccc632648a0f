"""The ridge of the points beside each station of an outline: where a face is, and how it runs.

Around a station all lines within a window are tried that run about as the outline does. The one with most
voxels is the ridge. An outline of pixels lies half a pixel outside the face on average, so the window is
centred half a pixel inside.
"""

from collections import namedtuple
from dataclasses import astuple, dataclass, fields, replace
from typing import Any, Callable

import numpy as np
from scipy.spatial import cKDTree

from ...kernels import kernel
from ...parallel import in_parts
from .face_points import SQUARE, FacePoints
from .settings import RidgeSettings

MOST = 1 << 15
"""Most voxels of a window that are looked at; only foliage fills one with more."""

SAMPLE = 200
"""Stations that show how dense the voxels are: their median is sure to a tenth."""

PART = 1 << 8
"""Stations whose ridges one thread finds at a time."""

_make: Callable[..., Any] = namedtuple
_Numbers = _make("_Numbers", [item.name for item in fields(RidgeSettings)])
"""The settings as the kernels take them."""


@dataclass(frozen=True)
class Stations:
    """Stations along a closed ring, the wall to the left.

    Attributes
    ----------
    xy : ndarray of float64, shape (n, 2)
    tangent : ndarray of float64, shape (n, 2)
        Unit vectors.
    """

    xy: np.ndarray
    tangent: np.ndarray


@dataclass(frozen=True)
class Ridges:
    """The ridge beside each station.

    Attributes
    ----------
    found : ndarray of bool, shape (n,)
    xy : ndarray of float64, shape (n, 2)
        The point of the ridge beside the station.
    direction : ndarray of float64, shape (n, 2)
        Unit vectors, about along the tangents.
    """

    found: np.ndarray
    xy: np.ndarray
    direction: np.ndarray


def stations_along(
    ring: np.ndarray, pixel_size: float, settings: RidgeSettings = RidgeSettings()
) -> Stations:
    """Return stations along a closed ring of corners (n + 1, 2), the first repeated, evenly spaced."""
    way = np.r_[0.0, np.cumsum(np.hypot(*np.diff(ring, axis=0).T))]
    width = max(pixel_size, settings.finest_m)
    count = max(int(np.ceil(way[-1] / (settings.step_px * width))), 8)
    at = (np.arange(count) + 0.5) * way[-1] / count

    def point(distance: np.ndarray) -> np.ndarray:
        return np.column_stack([np.interp(distance % way[-1], way, ring[:, axis]) for axis in (0, 1)])

    half = min(settings.half_chord_px * width, way[-1] / 4)
    chord = point(at + half) - point(at - half)
    length = np.hypot(*chord.T)[:, None]
    still = np.tile([1.0, 0.0], (count, 1))
    return Stations(point(at), np.divide(chord, length, out=still, where=length > 0))


def find_ridges(
    stations: Stations, points: FacePoints, pixel_size: float, settings: RidgeSettings = RidgeSettings()
) -> Ridges:
    """Find the ridge beside each station, in longer windows where the points of a slice are sparse."""
    ridges = _ridges(stations, points, pixel_size, settings)
    if not points.flat or ridges.found.all():
        return ridges
    half = _half_window(stations.xy, points, settings)
    if half > settings.along_m:
        missing = np.flatnonzero(~ridges.found)
        left = Stations(stations.xy[missing], stations.tangent[missing])
        more = _ridges(left, points, pixel_size, replace(settings, along_m=half))
        for all_of, found in zip(vars(ridges).values(), vars(more).values()):
            all_of[missing] = found
    return ridges


def _ridges(stations: Stations, points: FacePoints, pixel_size: float, settings: RidgeSettings) -> Ridges:
    """Find the ridge beside each station in windows of one length."""
    found = np.zeros(len(stations.xy), bool)
    ridges = Ridges(found, np.zeros_like(stations.xy), np.zeros_like(stations.xy))
    voxels = points.xy, points.level, points.square, points.columns
    fewest_levels = min(settings.fewest_levels, points.levels)
    outline = np.ascontiguousarray(stations.xy), np.ascontiguousarray(stations.tangent)
    asked = pixel_size, settings.turns, fewest_levels, _Numbers(*astuple(settings))

    def find(part: slice) -> None:
        result = (array[part] for array in (ridges.found, ridges.xy, ridges.direction))
        _find(*voxels, *(array[part] for array in outline), *asked, *result)

    in_parts(find, len(found), PART)
    return ridges


def _half_window(stations: np.ndarray, points: FacePoints, settings: RidgeSettings) -> float:
    """Return half the length of windows in which most stations find voxels enough for a line, metres."""
    asked = stations[:: max(len(stations) // SAMPLE, 1)]
    tree = cKDTree(points.xy[points.near(asked)])
    counts = tree.query_ball_point(asked, settings.along_m, return_length=True)
    usual = np.median(counts[counts > 0]) if np.any(counts) else settings.usual_voxels
    return min(settings.along_m * max(settings.usual_voxels / usual, 1.0), settings.longest_m)


@kernel
def _find(
    points: np.ndarray,
    level: np.ndarray,
    square: np.ndarray,
    columns: int,
    stations: np.ndarray,
    tangents: np.ndarray,
    pixel: float,
    turns: np.ndarray,
    enough: int,
    numbers: Any,
    found: np.ndarray,
    ridge: np.ndarray,
    direction: np.ndarray,
) -> None:
    """Fill `found`, `ridge` and `direction` for each station."""
    local = np.empty((MOST, 2))
    levels = np.empty(MOST, np.int64)
    inside = 0.5 * pixel
    pixel = max(pixel, numbers.finest_m)
    reach = np.hypot(numbers.along_m, numbers.across_px * pixel) + 0.02
    for i in range(len(stations)):
        tx, ty = tangents[i]
        # Half a pixel inwards, to the left.
        x, y = stations[i, 0] - inside * ty, stations[i, 1] + inside * tx
        count = _collect(points, level, square, columns, x, y, tx, ty, reach, local, levels)
        if count < numbers.fewest_voxels:
            continue
        turn, offset = _best_line(local[:count], turns, pixel, numbers)
        found[i], turn, offset = _fit(local[:count], levels[:count], turn, offset, pixel, enough, numbers)
        c, s = np.cos(turn), np.sin(turn)
        a, b = -offset * s, offset * c
        ridge[i, 0], ridge[i, 1] = x + a * tx - b * ty, y + a * ty + b * tx
        direction[i, 0], direction[i, 1] = c * tx - s * ty, c * ty + s * tx


@kernel
def _collect(
    points: np.ndarray,
    level: np.ndarray,
    square: np.ndarray,
    columns: int,
    x: float,
    y: float,
    tx: float,
    ty: float,
    reach: float,
    local: np.ndarray,
    levels: np.ndarray,
) -> int:
    """Note the voxels around a station, along and across its tangent; return their number."""
    count = 0
    column, row = int(np.floor(x / SQUARE)) + 1, int(np.floor(y / SQUARE)) + 1
    wide = int(np.ceil(reach / SQUARE))
    for r in range(row - wide, row + wide + 1):
        first = np.searchsorted(square, r * columns + column - wide)
        last = np.searchsorted(square, r * columns + column + wide + 1)
        for k in range(first, last):
            dx, dy = points[k, 0] - x, points[k, 1] - y
            if dx * dx + dy * dy <= reach * reach and count < len(local):
                local[count, 0], local[count, 1] = dx * tx + dy * ty, dy * tx - dx * ty
                levels[count] = level[k]
                count += 1
    return count


@kernel
def _best_line(local: np.ndarray, turns: np.ndarray, pixel: float, numbers: Any) -> tuple[float, float]:
    """Return turn and offset of the line with most voxels; of two parallel ones, of the outer if strong."""
    half, cell_m = numbers.across_px * pixel, numbers.cell_m
    cells = int(np.ceil(2 * half / cell_m)) + 4
    best, best_turn, best_cell = -1.0, 0.0, 0
    scores, kept = np.empty(cells), np.empty(cells)
    for turn in turns:
        scores[:] = 0.0
        c, s = np.cos(turn), np.sin(turn)
        for k in range(len(local)):
            along, across = local[k, 0] * c + local[k, 1] * s, local[k, 1] * c - local[k, 0] * s
            if abs(along) <= numbers.along_m and abs(across) < half:
                column = (across + half) / cell_m + 1.5
                cell = int(column)
                scores[cell] += 1.0 - abs(column - cell - 0.5)
                scores[cell - 1 if column - cell < 0.5 else cell + 1] += abs(column - cell - 0.5)
        for cell in range(1, cells - 1):
            offset = (cell - 1) * cell_m - half
            usual = np.exp(-0.5 * (offset / (numbers.usual_px * pixel)) ** 2)
            score = (scores[cell - 1] + 2 * scores[cell] + scores[cell + 1]) * usual
            if score > best:
                best, best_turn, best_cell = score, turn, cell
                kept[:] = scores
    chosen, strongest = best_cell, kept[best_cell - 1] + 2 * kept[best_cell] + kept[best_cell + 1]
    outer = 0.0
    for cell in range(1, best_cell - int(numbers.apart_m / cell_m)):
        score = kept[cell - 1] + 2 * kept[cell] + kept[cell + 1]
        if score >= numbers.strong_share * strongest and score > outer:
            outer, chosen = score, cell
    return best_turn, (chosen - 1) * cell_m - half


@kernel
def _fit(
    local: np.ndarray,
    levels: np.ndarray,
    turn: float,
    offset: float,
    pixel: float,
    enough: int,
    numbers: Any,
) -> tuple[bool, float, float]:
    """Fit the line to the voxels in its band; return whether it is a ridge, its turn and its offset."""
    count, seen, spread = 0, 0, 0.0
    for _ in range(3):
        c, s = np.cos(turn), np.sin(turn)
        count, seen = 0, 0
        m = np.zeros(5)
        for k in range(len(local)):
            along, across = local[k, 0] * c + local[k, 1] * s, local[k, 1] * c - local[k, 0] * s
            if abs(along) <= numbers.along_m and abs(across - offset) <= numbers.band_m:
                count += 1
                seen |= 1 << min(levels[k], 62)
                m += np.array([along, across, along * along, along * across, across * across])
        if count < numbers.fewest_voxels:
            return False, turn, offset
        m /= count
        aa, ab, bb = m[2] - m[0] * m[0], m[3] - m[0] * m[1], m[4] - m[1] * m[1]
        spread = np.sqrt(max(aa, 0.0))
        bend = 0.5 * np.arctan2(2 * ab, aa - bb)
        offset = m[1] * np.cos(bend) - m[0] * np.sin(bend)
        turn += bend
    number = 0
    while seen:
        number += seen & 1
        seen >>= 1
    sound = number >= enough and spread >= numbers.least_spread_m
    sound = sound and abs(turn) < 1.2 and abs(offset) < (numbers.across_px + 0.2) * pixel
    return sound, turn, offset + _beside(local, turn, offset, numbers)


@kernel
def _beside(local: np.ndarray, turn: float, offset: float, numbers: Any) -> float:
    """Return the mean distance from the line of the voxels right beside the station."""
    c, s = np.cos(turn), np.sin(turn)
    count, total = 0, 0.0
    for k in range(len(local)):
        along, across = local[k, 0] * c + local[k, 1] * s, local[k, 1] * c - local[k, 0] * s
        if abs(along) <= numbers.along_m / 3 and abs(across - offset) <= numbers.band_m:
            count += 1
            total += across - offset
    return total / count if count >= numbers.fewest_voxels else 0.0
