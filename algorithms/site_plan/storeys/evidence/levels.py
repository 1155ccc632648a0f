"""Floor, ceiling and upright surfaces of a storey, by pixel."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ....errors import InputError
from ....kernels import kernel
from ..settings import LevelSettings
from .voxels import Voxels

LEVELS = 64
"""Number of levels that a pixel can note."""


@dataclass(frozen=True)
class Frame:
    """Square pixels; rows count from the lowest y.

    Attributes
    ----------
    left, bottom : float
        Lower left corner, metres, relative to the local origin.
    pixel_m : float
    shape : tuple of int
        Rows and columns.
    """

    left: float
    bottom: float
    pixel_m: float
    shape: tuple[int, int]

    def places(self, xy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return row and column of positions, shape (n, 2)."""
        column = np.floor((xy[:, 0] - self.left) / self.pixel_m).astype(np.int64)
        row = np.floor((xy[:, 1] - self.bottom) / self.pixel_m).astype(np.int64)
        return row, column

    def centres(self, row: np.ndarray, column: np.ndarray) -> np.ndarray:
        """Return the centres of pixels, shape (n, 2)."""
        return np.column_stack([column + 0.5, row + 0.5]) * self.pixel_m + (self.left, self.bottom)


@dataclass(frozen=True)
class Uprights:
    """Pixels that hold upright surface.

    Attributes
    ----------
    frame : Frame
    row, column : ndarray of int, shape (n,)
    xy : ndarray of float64, shape (n, 2)
        Mean position of the surface in the pixel, every level counted once, metres.
    angle : ndarray of float64, shape (n,)
        Direction of the normal, 0 to pi.
    levels : ndarray of uint64, shape (n,)
        Bit k is set if there is surface between k and k + 1 levels above the floor.
    """

    frame: Frame
    row: np.ndarray
    column: np.ndarray
    xy: np.ndarray
    angle: np.ndarray
    levels: np.ndarray


@dataclass(frozen=True)
class Storey:
    """Heights of a storey, metres.

    Attributes
    ----------
    floor : float
        Height of the floor.
    ceiling : float or None
        Height of the lowest large ceiling, of the lower edge of its layer as long as that is not measured;
        None if none was seen.
    """

    floor: float
    ceiling: Optional[float]


def find_storey(voxels: Voxels, settings: LevelSettings = LevelSettings()) -> Optional[Storey]:
    """Find the floor and the ceiling, the lowest and the next large flat layers; None if nothing is flat."""
    z = voxels.xyz[np.abs(voxels.normal[:, 2]) > settings.flat, 2]
    if not len(z):
        return None
    layer = settings.layer_m
    first = np.floor(z.min() / layer)
    counts = np.bincount((np.floor(z / layer) - first).astype(int))
    pairs = counts + np.r_[counts[1:], 0]
    large = np.flatnonzero(pairs > settings.storey_share * pairs.max())
    floor = (first + large[0] + 1) * layer
    floor = float(np.median(z[np.abs(z - floor) <= layer]))
    if voxels.xyz[:, 2].max() < floor + settings.lowest_storey_m:
        return None
    above = (first + large) * layer
    above = above[above > floor + settings.lowest_storey_m]
    return Storey(floor, float(above[0]) if len(above) else None)


def with_measured_ceiling(
    storey: Storey, voxels: Voxels, settings: LevelSettings = LevelSettings()
) -> Storey:
    """Return a storey with the usual height of the two layers that its ceiling was found in."""
    if storey.ceiling is None:
        return storey
    z = voxels.xyz[np.abs(voxels.normal[:, 2]) > settings.flat, 2]
    z = z[np.abs(z - storey.ceiling - settings.layer_m) <= settings.layer_m]
    return replace(storey, ceiling=float(np.median(z))) if len(z) else storey


def find_uprights(
    voxels: Voxels, floor: float, frame: Frame, settings: LevelSettings = LevelSettings()
) -> Uprights:
    """Gather the upright surfaces above the floor by pixel."""
    level = np.floor((voxels.xyz[:, 2] - floor) / settings.level_m).astype(np.int64)
    normal = voxels.normal
    chosen = (np.abs(normal[:, 2]) < settings.upright) & np.any(normal[:, :2] != 0, axis=1)
    chosen &= (level >= 0) & (level < LEVELS)
    xyz, normal, level = voxels.xyz[chosen], normal[chosen].astype(float), level[chosen]
    row, column = frame.places(xyz)
    key = row * frame.shape[1] + column
    order = np.argsort(key, kind="stable")
    pixels, first = np.unique(key[order], return_index=True)
    double = 2 * np.arctan2(normal[:, 1], normal[:, 0])
    values = np.column_stack([xyz[:, :2], np.cos(double), np.sin(double)])
    sums, bits = _by_pixel(values[order], level[order], np.r_[first, len(order)])
    angle = np.arctan2(sums[:, 3], sums[:, 2]) / 2 % np.pi
    return Uprights(frame, pixels // frame.shape[1], pixels % frame.shape[1], sums[:, :2], angle, bits)


@kernel
def _by_pixel(values: np.ndarray, level: np.ndarray, starts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean values of each pixel and its levels."""
    count = len(starts) - 1
    sums = np.zeros((count, values.shape[1]))
    bits = np.zeros(count, np.uint64)
    for i in range(count):
        for j in range(starts[i], starts[i + 1]):
            sums[i] += values[j]
            bits[i] |= np.uint64(1) << np.uint64(level[j])
        sums[i] /= starts[i + 1] - starts[i]
    return sums, bits


def count_levels(bits: np.ndarray) -> np.ndarray:
    """Return how many bits are set in each uint64."""
    parts = np.ascontiguousarray(bits).view(np.uint8).reshape(*bits.shape, 8)
    return np.unpackbits(parts, axis=-1).sum(axis=-1)


def frame_around(
    voxels: Voxels, pixel: float, margin: float, settings: LevelSettings = LevelSettings()
) -> Frame:
    """Return a frame that holds all voxels and a margin, metres.

    Raises
    ------
    InputError
        If it would hold more than `largest_frame_px` pixels.
    """
    low = np.floor((voxels.xyz[:, :2].min(axis=0) - margin) / pixel)
    high = np.ceil((voxels.xyz[:, :2].max(axis=0) + margin) / pixel)
    columns, rows = (high - low).astype(int).tolist()
    if columns * rows > settings.largest_frame_px:
        width, height = columns * pixel, rows * pixel
        raise InputError(
            f"The storey would be {width:.0f} x {height:.0f} m, too large for a plan of rooms: cut the "
            "cloud to a building, or check that its coordinates are metres."
        )
    return Frame(float(low[0] * pixel), float(low[1] * pixel), pixel, (rows, columns))
