"""The ridge of the points beside each place of an outline: where a face is, and how it runs.

Around a place of the outline all lines within a window are tried that run about as the outline does, and the
one with most voxels is taken. An outline of pixels lies half a pixel outside the face on average, so the
window is about the place half a pixel inside.
"""

from dataclasses import dataclass

import numpy as np
from numba import njit

from .face_points import BIN, FacePoints

FINEST = 0.1
"""Windows are as for pixels of this size (m) if they are finer: the faces do not become sharper with them."""

STEP = 0.5
"""Distance of the places along an outline, in pixels."""

CHORD = 1.5
"""Half the chord that gives the direction of an outline of pixels, in pixels."""

ALONG = 0.15
"""Half the window along a line, metres; curved walls bend little in it, and a door's jamb fills most."""

ACROSS = 1.3
"""Half the window across, in pixels."""

USUAL = 0.8
"""Standard deviation of a face's place in the window, in pixels."""

TURNS = np.radians(np.arange(-50, 51, 5))
"""Directions that are tried, from that of the outline."""

CELL = 0.01
"""Width of the lines that are tried, metres."""

BAND = 0.025
"""Points this far (m) from a line belong to it."""

APART = 0.06
"""Faces of one wall are farther apart than this (m): of two ridges, the outer one is the outline's."""

STRONG = 0.5
"""Least share of the stronger ridge's voxels that an outer ridge has."""

FEWEST, LEVELS, SPREAD = 5, 3, 0.018
"""A ridge has this many voxels in so many levels (in all of a flat cloud), and they spread along it with this
standard deviation (m): a wall's end that was not seen shows the section of its faces only."""


MOST = 1 << 15
"""Most voxels of a window that are looked at; only foliage fills one with more."""


@dataclass(frozen=True)
class Places:
    """Places along a closed ring, the wall to the left.

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
    """The ridge beside each place.

    Attributes
    ----------
    found : ndarray of bool, shape (n,)
    xy : ndarray of float64, shape (n, 2)
        The point of the ridge beside the place.
    direction : ndarray of float64, shape (n, 2)
        Unit vectors, about along the tangents.
    """

    found: np.ndarray
    xy: np.ndarray
    direction: np.ndarray


def places_along(ring: np.ndarray, pixel_size: float) -> Places:
    """Return places along a closed ring of corners (n + 1, 2), the first repeated, evenly spaced."""
    way = np.r_[0.0, np.cumsum(np.hypot(*np.diff(ring, axis=0).T))]
    width = max(pixel_size, FINEST)
    count = max(int(np.ceil(way[-1] / (STEP * width))), 8)
    at = (np.arange(count) + 0.5) * way[-1] / count

    def point(distance: np.ndarray) -> np.ndarray:
        return np.column_stack([np.interp(distance % way[-1], way, ring[:, axis]) for axis in (0, 1)])

    half = min(CHORD * width, way[-1] / 4)
    chord = point(at + half) - point(at - half)
    length = np.hypot(*chord.T)[:, None]
    return Places(point(at), np.divide(chord, length, out=np.tile([1.0, 0.0], (count, 1)), where=length > 0))


def find_ridges(places: Places, points: FacePoints, pixel_size: float) -> Ridges:
    """Find the ridge beside each place."""
    found = np.zeros(len(places.xy), bool)
    ridges = Ridges(found, np.zeros_like(places.xy), np.zeros_like(places.xy))
    voxels = points.xy, points.level, points.square, points.columns
    fewest_levels = min(LEVELS, points.levels)
    outline = np.ascontiguousarray(places.xy), np.ascontiguousarray(places.tangent)
    _find(*voxels, *outline, pixel_size, TURNS, fewest_levels, ridges.found, ridges.xy, ridges.direction)
    return ridges


@njit(nogil=True, cache=True)
def _find(points, level, square, columns, places, tangents, pixel, turns, enough, found, ridge, direction):
    """Fill `found`, `ridge` and `direction` for each place."""
    local = np.empty((MOST, 2))
    levels = np.empty(MOST, np.int64)
    inside = 0.5 * pixel
    pixel = max(pixel, FINEST)
    reach = np.hypot(ALONG, ACROSS * pixel) + 0.02
    for i in range(len(places)):
        tx, ty = tangents[i]
        # Half a pixel inwards, to the left.
        x, y = places[i, 0] - inside * ty, places[i, 1] + inside * tx
        count = _collect(points, level, square, columns, x, y, tx, ty, reach, local, levels)
        if count < FEWEST:
            continue
        turn, offset = _best_line(local[:count], turns, pixel)
        found[i], turn, offset = _fit(local[:count], levels[:count], turn, offset, pixel, enough)
        c, s = np.cos(turn), np.sin(turn)
        a, b = -offset * s, offset * c
        ridge[i, 0], ridge[i, 1] = x + a * tx - b * ty, y + a * ty + b * tx
        direction[i, 0], direction[i, 1] = c * tx - s * ty, c * ty + s * tx


@njit(nogil=True, cache=True)
def _collect(points, level, square, columns, x, y, tx, ty, reach, local, levels):
    """Note the voxels around a place, along and across its tangent; return their number."""
    count = 0
    column, row = int(np.floor(x / BIN)) + 1, int(np.floor(y / BIN)) + 1
    wide = int(np.ceil(reach / BIN))
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


@njit(nogil=True, cache=True)
def _best_line(local, turns, pixel):
    """Return turn and offset of the line with most voxels; of two parallel ones, of the outer if strong."""
    half = ACROSS * pixel
    cells = int(np.ceil(2 * half / CELL)) + 4
    best, best_turn, best_cell = -1.0, 0.0, 0
    scores, kept = np.empty(cells), np.empty(cells)
    for turn in turns:
        scores[:] = 0.0
        c, s = np.cos(turn), np.sin(turn)
        for k in range(len(local)):
            along, across = local[k, 0] * c + local[k, 1] * s, local[k, 1] * c - local[k, 0] * s
            if abs(along) <= ALONG and abs(across) < half:
                place = (across + half) / CELL + 1.5
                cell = int(place)
                scores[cell] += 1.0 - abs(place - cell - 0.5)
                scores[cell - 1 if place - cell < 0.5 else cell + 1] += abs(place - cell - 0.5)
        for cell in range(1, cells - 1):
            offset = (cell - 1) * CELL - half
            usual = np.exp(-0.5 * (offset / (USUAL * pixel)) ** 2)
            score = (scores[cell - 1] + 2 * scores[cell] + scores[cell + 1]) * usual
            if score > best:
                best, best_turn, best_cell = score, turn, cell
                kept[:] = scores
    chosen, strongest = best_cell, kept[best_cell - 1] + 2 * kept[best_cell] + kept[best_cell + 1]
    outer = 0.0
    for cell in range(1, best_cell - int(APART / CELL)):
        score = kept[cell - 1] + 2 * kept[cell] + kept[cell + 1]
        if score >= STRONG * strongest and score > outer:
            outer, chosen = score, cell
    return best_turn, (chosen - 1) * CELL - half


@njit(nogil=True, cache=True)
def _fit(local, levels, turn, offset, pixel, enough):
    """Fit the line to the voxels in its band; return whether it is one, its turn and its offset."""
    count, seen, spread = 0, 0, 0.0
    for _ in range(3):
        c, s = np.cos(turn), np.sin(turn)
        count, seen = 0, 0
        m = np.zeros(5)
        for k in range(len(local)):
            along, across = local[k, 0] * c + local[k, 1] * s, local[k, 1] * c - local[k, 0] * s
            if abs(along) <= ALONG and abs(across - offset) <= BAND:
                count += 1
                seen |= 1 << min(levels[k], 62)
                m += np.array([along, across, along * along, along * across, across * across])
        if count < FEWEST:
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
    sound = number >= enough and spread >= SPREAD and abs(turn) < 1.2 and abs(offset) < (ACROSS + 0.2) * pixel
    return sound, turn, offset + _beside(local, turn, offset)


@njit(nogil=True, cache=True)
def _beside(local, turn, offset):
    """Return the mean distance from the line of the voxels right beside the place."""
    c, s = np.cos(turn), np.sin(turn)
    count, total = 0, 0.0
    for k in range(len(local)):
        along, across = local[k, 0] * c + local[k, 1] * s, local[k, 1] * c - local[k, 0] * s
        if abs(along) <= ALONG / 3 and abs(across - offset) <= BAND:
            count += 1
            total += across - offset
    return total / count if count >= FEWEST else 0.0
