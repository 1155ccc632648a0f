"""Joining the two faces of a wall, and filling what is left between (section 2.2, figure 7)."""

from typing import Optional

import numpy as np
from scipy import ndimage

from .settings import ClosingSettings


def close_gaps(
    walls: np.ndarray,
    pixel_size: float,
    gap: float,
    open_ground: Optional[np.ndarray] = None,
    settings: ClosingSettings = ClosingSettings(),
) -> np.ndarray:
    """Close gaps up to a width between faces, by a round structuring element, and fill holes.

    Where the heights are known, ground that was seen is kept open, so that a door is not walled up. A hole in
    which no ground was seen is filled up to twice the gap: between the faces of a thick wall or of a column.
    Where nothing shows the ground, as in a slice, it may be a small room if it is wider than a wall is thick.

    Parameters
    ----------
    walls : ndarray of bool, shape (rows, columns)
        Wall pixels.
    pixel_size, gap : float
        Metres. A gap of 0 closes nothing.
    open_ground : ndarray of bool, shape (rows, columns), optional
        Pixels in which the ground itself was seen and nothing rises above it.
    settings : ClosingSettings
    """
    if gap <= 0:
        return walls
    width = gap / pixel_size
    proof = np.zeros(walls.shape, bool)
    if open_ground is not None:
        # A single pixel of ground is the foot of the wall; a passage shows more of it.
        proof = ndimage.binary_opening(open_ground & ~walls, np.ones((2, 2)))
    closed = walls | (_closed(walls, width) & ~proof)
    joined = ndimage.binary_propagation(walls, np.ones((3, 3)), mask=closed)
    widest = 2 * gap if open_ground is not None else min(2 * gap, max(gap, settings.seen_m))
    return _fill_holes(joined, widest / pixel_size, proof)


def _closed(walls: np.ndarray, gap: float) -> np.ndarray:
    """Dilate and erode by the disc that just bridges `gap` pixels."""
    radius = (gap + 1) / 2 + 1e-6
    margin = int(radius) + 2
    wide = ndimage.distance_transform_edt(~np.pad(walls, margin)) <= radius
    return (ndimage.distance_transform_edt(wide) > radius)[margin:-margin, margin:-margin]


def _fill_holes(walls: np.ndarray, width: float, proof: np.ndarray) -> np.ndarray:
    """Fill the holes without proof of a gap whose largest inscribed circle is at most `width` pixels wide."""
    holes, count = ndimage.label(ndimage.binary_fill_holes(walls) & ~walls)
    if count == 0:
        return walls
    names = np.arange(count + 1)
    reach = np.asarray(ndimage.maximum(ndimage.distance_transform_edt(~walls), holes, names))
    open_holes = np.asarray(ndimage.maximum(proof, holes, names)) > 0
    fill = (2 * reach - 1 <= width) & ~open_holes
    fill[0] = False
    return walls | fill[holes]


def bridge_corners(walls: np.ndarray, density: np.ndarray) -> np.ndarray:
    """Fill the denser pixel beside each pair that touches at a corner only, until no such pair is left.

    A slanting wall one pixel wide would fall apart into pixels otherwise.
    """
    walls = walls.copy()
    while True:
        a, b, c, d = walls[:-1, :-1], walls[:-1, 1:], walls[1:, :-1], walls[1:, 1:]
        falling = np.argwhere(a & d & ~b & ~c)
        rising = np.argwhere(b & c & ~a & ~d)
        if len(falling) + len(rising) == 0:
            return walls
        _fill_denser(walls, density, falling, (0, 1), (1, 0))
        _fill_denser(walls, density, rising, (0, 0), (1, 1))


def _fill_denser(
    walls: np.ndarray,
    density: np.ndarray,
    blocks: np.ndarray,
    first: tuple[int, int],
    second: tuple[int, int],
) -> None:
    one, other = blocks + first, blocks + second
    denser = density[tuple(other.T)] > density[tuple(one.T)]
    walls[tuple(np.where(denser[:, None], other, one).T)] = True
