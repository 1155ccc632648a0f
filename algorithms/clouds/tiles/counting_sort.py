"""Points sorted by tile in two passes: one counts the points of each tile, one moves them to their own."""

import numpy as np

from ...kernels import kernel
from .lattice_points import on_lattice


def sort_by_tile(
    xyz: np.ndarray, origin: np.ndarray, edge: int, farthest: float, highest: float, is_numbered: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Sort points into square tiles; those of a tile remain in their order.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
        Metres, relative to `origin`.
    origin : ndarray of int64, shape (3,)
        Metres.
    edge : int
        Of a tile, in lattice steps.
    farthest, highest : float
        Points as far from the origin in x or y, or as high or deep, are left out, metres.
    is_numbered : bool
        Whether each record has the number of its point.

    Returns
    -------
    keys : ndarray of int64, shape (k, 2)
        Column and row of the tiles, in the order in which they appear.
    starts : ndarray of int64, shape (k + 1,)
        Where the records of each tile begin, and how many there are.
    records : ndarray of int32, shape (m, 3) or (m, 4)
        x, y from the lower left corner of the tile, z absolute, lattice steps; the number of the point.
    """
    size = 1 << max(int(np.ceil(np.log2(2 * len(xyz) + 1))), 4)
    points = np.ascontiguousarray(xyz), origin, np.int64(edge)
    tile, keys, starts = _count(*points, farthest, highest, size)
    return keys, starts, _put(*points, tile, keys, starts, 4 if is_numbered else 3)


@kernel
def _count(
    xyz: np.ndarray, origin: np.ndarray, edge: int, farthest: float, highest: float, size: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the number of each point's tile, -1 for stray points, the tiles, and where they begin."""
    mask = np.uint64(size - 1)
    numbers = np.full(size, -1, np.int32)
    keys = np.empty((len(xyz), 2), np.int64)
    counts = np.zeros(len(xyz) + 1, np.int64)
    tile = np.empty(len(xyz), np.int32)
    known, last = 0, -1
    for i in range(len(xyz)):
        high = abs(xyz[i, 2] + origin[2])
        if not (high < highest and abs(xyz[i, 0]) < farthest and abs(xyz[i, 1]) < farthest):
            tile[i] = -1
            continue
        x, y = on_lattice(xyz[i, 0], origin[0]), on_lattice(xyz[i, 1], origin[1])
        # Scanners write neighbours in sequence.
        if last < 0 or not (0 <= x - keys[last, 0] * edge < edge and 0 <= y - keys[last, 1] * edge < edge):
            column, row = x // edge, y // edge
            slot = (np.uint64(column) * np.uint64(0x9E3779B97F4A7C15)) ^ np.uint64(row)
            slot = ((slot * np.uint64(0x94D049BB133111EB)) >> np.uint64(32)) & mask
            last = numbers[slot]
            while last >= 0 and (keys[last, 0] != column or keys[last, 1] != row):
                slot = (slot + np.uint64(1)) & mask
                last = numbers[slot]
            if last < 0:
                last = numbers[slot] = known
                keys[known, 0], keys[known, 1] = column, row
                known += 1
        tile[i] = last
        counts[last + 1] += 1
    return tile, keys[:known].copy(), counts[: known + 1].cumsum()


@kernel
def _put(
    xyz: np.ndarray,
    origin: np.ndarray,
    edge: int,
    tile: np.ndarray,
    keys: np.ndarray,
    starts: np.ndarray,
    width: int,
) -> np.ndarray:
    """Return the records of the points in the order of their tiles."""
    records = np.empty((starts[-1], width), np.int32)
    following = starts[:-1].copy()
    for i in range(len(xyz)):
        number = tile[i]
        if number < 0:
            continue
        k = following[number]
        following[number] += 1
        records[k, 0] = on_lattice(xyz[i, 0], origin[0]) - keys[number, 0] * edge
        records[k, 1] = on_lattice(xyz[i, 1], origin[1]) - keys[number, 1] * edge
        records[k, 2] = on_lattice(xyz[i, 2], origin[2])
        if width > 3:
            records[k, 3] = i
    return records
