"""Ceilings, and what hangs from them: a wall reaches its ceiling, furniture ends below."""

import numpy as np
from scipy import ndimage

from ...kernels import kernel
from .ground import surfaces_of, wide_parts
from .settings import CeilingSettings


def hanging_height(
    bits: np.ndarray,
    held: np.ndarray,
    low: float,
    bin_height: float,
    pixel_size: float,
    settings: CeilingSettings = CeilingSettings(),
) -> np.ndarray:
    """Return the height that points fill right below the ceiling, or below the beam that hides it.

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
    settings : CeilingSettings

    Returns
    -------
    ndarray of float32, shape (rows, columns)
        Metres; nan without a ceiling, beside one where no point is as high, and in windows.
    """
    side = max(round(settings.cell_m / pixel_size), 1)
    lowest = round((settings.lowest_m - low) / bin_height)
    levels = _levels(bits, held, side, lowest, settings.cover, settings.clear_bins, settings.clutter)
    ceilings = _ceilings(levels, settings)
    limits = settings.beside_cells, settings.beam_bins, settings.gap_bins
    return _hanging(bits, held, ceilings, side, *limits) * np.float32(bin_height)


def _ceilings(levels: np.ndarray, settings: CeilingSettings) -> np.ndarray:
    """Keep the levels of wide surfaces; beams up to a metre wide, and what they hide, are passed over."""
    closed = ndimage.grey_closing(np.pad(levels, 2, constant_values=-1), (3, 3))[2:-2, 2:-2]
    surfaces = surfaces_of(np.where(closed >= 0, closed, np.nan), 1)
    detected = np.bincount(surfaces[np.abs(levels - closed) <= 1], minlength=surfaces.max() + 1)
    even = detected >= settings.detected_share * np.bincount(surfaces.ravel(), minlength=len(detected))
    even[0] = False
    return np.where(wide_parts(surfaces, even[surfaces], settings.patch_cells), closed, -1)


@kernel
def _levels(
    bits: np.ndarray, held: np.ndarray, side: int, lowest: int, cover: float, clear: int, clutter: float
) -> np.ndarray:
    """Return the bin of the lowest surface that covers each cell of `side` pixels; -1 without one."""
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


@kernel
def _hanging(
    bits: np.ndarray, held: np.ndarray, levels: np.ndarray, side: int, reach: int, beam: int, gap: int
) -> np.ndarray:
    """Count the bins filled below the ceiling of each pixel's cell, or of a cell near it."""
    out = np.full(bits.shape, np.nan, np.float32)
    for row in range(levels.shape[0]):
        for column in range(levels.shape[1]):
            level = levels[row, column]
            if level < 0:
                level = _lowest_beside(levels, row, column, reach)
            if level < 0:
                continue
            for r in range(row * side, min((row + 1) * side, bits.shape[0])):
                for c in range(column * side, min((column + 1) * side, bits.shape[1])):
                    top = level + 2
                    while top > level - beam and not (bits[r, c] >> np.uint64(top)) & np.uint64(1):
                        top -= 1
                    if top > level - beam:
                        out[r, c] = _filled_below(bits[r, c], min(top, level), gap)
                    elif levels[row, column] >= 0 and held[r, c] and _is_one_piece(bits[r, c], gap):
                        out[r, c] = 0
    return out


@kernel
def _lowest_beside(levels: np.ndarray, row: int, column: int, reach: int) -> int:
    """Return the lowest of the levels around a cell; -1 without one."""
    lowest = -1
    for r in range(max(row - reach, 0), min(row + reach + 1, levels.shape[0])):
        for c in range(max(column - reach, 0), min(column + reach + 1, levels.shape[1])):
            if levels[r, c] >= 0 and (lowest < 0 or levels[r, c] < lowest):
                lowest = levels[r, c]
    return lowest


@kernel
def _filled_below(word: int, level: int, gap: int) -> int:
    """Return the number of bins from the lowest that is filled without wider gaps up to `level`."""
    end = level
    for k in range(level - 1, -1, -1):
        if (word >> np.uint64(k)) & np.uint64(1):
            end = k
        elif end - k > gap:
            break
    return level - end


@kernel
def _is_one_piece(word: int, gap: int) -> bool:
    """Return whether all points stand on the ground: the head of a window hangs above its sill."""
    top = 63
    while top > 0 and not (word >> np.uint64(top)) & np.uint64(1):
        top -= 1
    end = top - _filled_below(word, top, gap)
    return word & ((np.uint64(1) << np.uint64(end)) - np.uint64(1)) == 0
