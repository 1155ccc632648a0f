"""Ceilings, and what hangs from them: a wall reaches its ceiling, furniture ends below."""

import numpy as np
from numba import njit

from .ground import surfaces_of, wide_parts

CELL = 0.5
"""Edge in metres of the cells in which a ceiling is looked for."""

LOWEST = 2.0
"""A ceiling is at least this high (m) above the ground."""

COVER = 0.7
"""Share of the pixels of a cell that a ceiling covers, at least."""

CLEAR, CLUTTER = 5, 0.25
"""In this number of bins below a ceiling, at most this share of a cell is taken by walls and beams."""

PATCH = 4
"""A ceiling holds a level square of this many cells, 2 m; no crown is as flat."""

GAP = 2
"""Number of empty bins that the scan lines on a distant wall leave between them."""


def hanging_height(
    bits: np.ndarray, held: np.ndarray, low: float, bin_height: float, pixel_size: float
) -> np.ndarray:
    """Return the height that points fill right below the ceiling.

    Parameters
    ----------
    bits : ndarray of uint64, shape (rows, columns)
        The bins of height above the local ground that hold a point, the lowest in the lowest bit.
    held : ndarray of bool, shape (rows, columns)
        Pixels that hold a point at any height.
    low : float
        Height above the ground at which the lowest bin begins, metres.
    bin_height, pixel_size : float
        Metres.

    Returns
    -------
    ndarray of float32, shape (rows, columns)
        Metres; nan where no ceiling is near, or no point is as high.
    """
    side = max(round(CELL / pixel_size), 1)
    lowest = round((LOWEST - low) / bin_height)
    levels = _levels(bits, held, side, lowest, COVER, CLEAR, CLUTTER)
    return _hanging(bits, _ceilings(levels), side, GAP) * np.float32(bin_height)


def _ceilings(levels: np.ndarray) -> np.ndarray:
    """Keep the levels of surfaces that are wide; a beam, narrower than a cell, does not part them."""
    known = np.where(levels >= 0, levels, np.nan)
    around = np.pad(known, 1, constant_values=np.nan)
    bridged = known
    for one, other in (
        (around[1:-1, :-2], around[1:-1, 2:]),
        (around[:-2, 1:-1], around[2:, 1:-1]),
        (around[:-2, :-2], around[2:, 2:]),
        (around[:-2, 2:], around[2:, :-2]),
    ):
        level = np.isnan(bridged) & (np.abs(one - other) <= 1)
        bridged = np.where(level, np.minimum(one, other), bridged)
    surfaces = surfaces_of(bridged, 1)
    wide = wide_parts(surfaces, surfaces > 0, PATCH) & (surfaces > 0)
    return np.where(wide, bridged, -1).astype(np.int64)


@njit(nogil=True, cache=True)
def _levels(bits, held, side, lowest, cover, clear, clutter):
    """Return the bin of the lowest surface that covers each cell of `side` pixels; -1 if there is none."""
    rows, columns = (bits.shape[0] + side - 1) // side, (bits.shape[1] + side - 1) // side
    levels = np.full((rows, columns), -1, np.int64)
    for row in range(rows):
        for column in range(columns):
            cell = slice(row * side, (row + 1) * side), slice(column * side, (column + 1) * side)
            words, pixels = bits[cell].ravel(), held[cell].sum()
            if (words >> np.uint64(lowest)).max() == 0:
                continue
            full = np.zeros(64, np.int64)
            for word in words:
                for k in range(lowest - clear, 64):
                    full[k] += (word >> np.uint64(k)) & np.uint64(1)
            for k in range(lowest, 63):
                # A ceiling on the border of two bins lies in both.
                covered = 0
                for word in words:
                    covered += ((word >> np.uint64(k)) & np.uint64(3)) != 0
                if covered >= cover * pixels:
                    if full[k - clear : k].sum() <= clutter * clear * pixels:
                        levels[row, column] = k
                    break
    return levels


@njit(nogil=True, cache=True)
def _hanging(bits, levels, side, gap):
    """Count the bins filled below the ceiling of each pixel's cell, or of a cell beside it."""
    out = np.full(bits.shape, np.nan, np.float32)
    for row in range(levels.shape[0]):
        for column in range(levels.shape[1]):
            level = levels[row, column]
            if level < 0:
                level = _lowest_beside(levels, row, column)
            if level < 0:
                continue
            for r in range(row * side, min((row + 1) * side, bits.shape[0])):
                for c in range(column * side, min((column + 1) * side, bits.shape[1])):
                    word = bits[r, c]
                    if (word >> np.uint64(level - 1)) & np.uint64(15):
                        out[r, c] = _filled_below(word, level, gap)
    return out


@njit(nogil=True, cache=True)
def _lowest_beside(levels, row, column):
    """Return the lowest of the levels around a cell; -1 if there is none."""
    lowest = -1
    for r in range(max(row - 1, 0), min(row + 2, levels.shape[0])):
        for c in range(max(column - 1, 0), min(column + 2, levels.shape[1])):
            if levels[r, c] >= 0 and (lowest < 0 or levels[r, c] < lowest):
                lowest = levels[r, c]
    return lowest


@njit(nogil=True, cache=True)
def _filled_below(word, level, gap):
    """Return the number of bins from the lowest that is filled without wider gaps up to `level`."""
    end = level
    for k in range(level - 1, -1, -1):
        if (word >> np.uint64(k)) & np.uint64(1):
            end = k
        elif end - k > gap:
            break
    return level - end
