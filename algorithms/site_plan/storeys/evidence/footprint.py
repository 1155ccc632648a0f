"""The footprint of a storey: where floor or ceiling was seen."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

from ..settings import FootprintSettings, LevelSettings
from .levels import Frame, Storey, Uprights, count_levels
from .sheets import Sheet
from .voxels import Voxels


@dataclass(frozen=True)
class Footprint:
    """How sure it is that a pixel belongs to a room.

    Attributes
    ----------
    frame : Frame
    weight : ndarray of float32, shape (rows, columns)
        0 (nothing was seen) to 1; nan where upright surfaces make it unknown.
    floor, ceiling : ndarray of float32, shape (rows, columns)
        Heights of the lowest flat surface below `top_m`, or of the step of a stair above it, and of the
        highest in reach of a ceiling, metres; nan where none was seen.
    """

    frame: Frame
    weight: np.ndarray
    floor: np.ndarray
    ceiling: np.ndarray


def find_footprint(
    voxels: Voxels,
    storey: Storey,
    uprights: Uprights,
    sheets: Sequence[Sheet],
    frame: Frame,
    settings: FootprintSettings = FootprintSettings(),
    levels: LevelSettings = LevelSettings(),
) -> Footprint:
    """Rate every pixel by what was seen of floor and ceiling."""
    z = voxels.xyz[:, 2]
    touching = np.abs(z - storey.floor) < settings.touching_m
    if storey.ceiling is not None:
        touching |= np.abs(z - storey.ceiling) < settings.touching_m
    flat = np.abs(voxels.normal[:, 2]) > levels.flat
    flat |= touching & ~voxels.normal.any(axis=1)
    xyz = voxels.xyz[flat]
    row, column = frame.places(xyz)
    low = xyz[:, 2] < storey.floor + settings.top_m
    high = xyz[:, 2] > storey.floor + levels.lowest_storey_m
    floor = _extreme(np.fmin, row[low], column[low], xyz[low, 2], frame.shape)
    steps = ~low & ~high
    step = _extreme(np.fmin, row[steps], column[steps], xyz[steps, 2], frame.shape)
    floor = _climbed(floor, step, round(settings.tread_m / frame.pixel_m), settings.riser_m)
    ceiling = _extreme(np.fmax, row[high], column[high], xyz[high, 2], frame.shape)
    reach = 2 * round(settings.around_m / frame.pixel_m) + 1
    around = ndimage.maximum_filter(np.where(np.isnan(ceiling), -np.inf, ceiling), reach)
    weight = np.zeros(frame.shape, np.float32)
    weight[np.isfinite(ceiling)] = settings.soffit_weight
    weight[np.isfinite(floor)] = settings.floor_weight
    weight[ceiling >= around - settings.drop_m] = settings.ceiling_weight
    neutral = _are_upright(uprights, frame, settings.upright_levels)
    barrier = neutral | _drawn(sheets, frame, settings.barrier_m)
    weight = _closed(weight, barrier, _gaps(xyz[low | high], frame, settings))
    weight[neutral | (barrier & (weight == 0))] = np.nan
    return Footprint(frame, weight, floor, ceiling)


def _extreme(
    function: np.ufunc, row: np.ndarray, column: np.ndarray, z: np.ndarray, shape: tuple[int, int]
) -> np.ndarray:
    heights = np.full(shape, np.nan, np.float32)
    function.at(heights, (row, column), z.astype(np.float32))
    return heights


def _climbed(floor: np.ndarray, step: np.ndarray, reach: int, riser: float) -> np.ndarray:
    """Return heights of the floor with the steps that lead on from it, one after the other."""
    floor = floor.copy()
    free = np.isnan(floor) & np.isfinite(step)
    while free.any():
        around = ndimage.maximum_filter(np.where(np.isnan(floor), -np.inf, floor), 2 * reach + 1)
        reached = free & (step <= around + riser)
        if not reached.any():
            break
        floor[reached] = step[reached]
        free &= ~reached
    return floor


def _are_upright(uprights: Uprights, frame: Frame, fewest: int) -> np.ndarray:
    """Return which pixels hold so many levels of upright surface."""
    pixels = frame.places(uprights.xy)
    bits = np.zeros(frame.shape, np.uint64)
    np.bitwise_or.at(bits, pixels, uprights.levels)
    many = np.zeros(frame.shape, bool)
    held = bits > 0
    many[held] = count_levels(bits[held]) >= fewest
    return many


def _drawn(sheets: Sequence[Sheet], frame: Frame, extension: float) -> np.ndarray:
    """Return which pixels sheets lie on, or would lie on if they were longer."""
    drawn = np.zeros(frame.shape, bool)
    for sheet in sheets:
        count = int(3 * (sheet.length + 2 * extension) / frame.pixel_m) + 2
        beyond = extension * sheet.direction
        row, column = frame.places(np.linspace(sheet.start - beyond, sheet.stop + beyond, count))
        inside = (row >= 0) & (row < frame.shape[0]) & (column >= 0) & (column < frame.shape[1])
        drawn[row[inside], column[inside]] = True
    return drawn


def _gaps(xyz: np.ndarray, frame: Frame, settings: FootprintSettings) -> np.ndarray:
    """Return how many pixels a gap is closed from each side, by the spacing of floor and ceiling around it.

    Far from a scanner they are sparse, because the rays graze them.
    """
    if len(xyz) <= settings.neighbours:
        return np.ones(frame.shape, int)
    # Splits in the middle cost half of balanced ones.
    tree = cKDTree(xyz, balanced_tree=False)
    distance = tree.query(xyz, settings.neighbours + 1, workers=-1)[0][:, -1]
    spacing = _usual_around(distance / np.sqrt(2.0), xyz, frame, round(settings.around_m / frame.pixel_m))
    gap = np.minimum(settings.closed_spacings * spacing, settings.closed_m)
    return np.maximum(np.rint(gap / frame.pixel_m).astype(int), 1)


def _usual_around(values: np.ndarray, xyz: np.ndarray, frame: Frame, block: int) -> np.ndarray:
    """Return for each pixel the median of the values of the points in its block, or in the nearest one."""
    row, column = (place // block for place in frame.places(xyz))
    rows, columns = (-(-length // block) for length in frame.shape)
    number = row * columns + column
    held = np.unique(number)
    usual = np.full(rows * columns, np.nan)
    usual[held] = ndimage.median(values, number, held)
    usual = usual.reshape(rows, columns)
    nearest = ndimage.distance_transform_edt(np.isnan(usual), return_distances=False, return_indices=True)
    pixels = usual[tuple(nearest)].repeat(block, 0).repeat(block, 1)
    return pixels[: frame.shape[0], : frame.shape[1]]


def _closed(weight: np.ndarray, barrier: np.ndarray, gaps: np.ndarray) -> np.ndarray:
    """Close gaps up to so many pixels from each side, but nothing behind a barrier."""
    closed = weight.copy()
    free = ~barrier
    for value in np.unique(weight[weight > 0]):
        for radius in np.unique(gaps):
            seen = ndimage.binary_dilation((weight >= value) & free, iterations=radius, mask=free)
            unseen = ndimage.binary_dilation(free & ~seen, iterations=radius, mask=free)
            filled = free & ~unseen & (gaps >= radius)
            closed[filled] = np.maximum(closed[filled], value)
    return closed
