"""The choice of points within one tile: a hash table of cells answers which chosen points are near."""

import numpy as np

from ...kernels import kernel
from ..tiles.lattice_points import limits_of

ROW, LEVEL = 1 << 16, 1 << 32
"""Steps of a cell's packed number from row to row and level to level of a tile."""


def choose(xyz: np.ndarray, seeds: np.ndarray, corner: tuple[int, int], reach: int) -> np.ndarray:
    """Return the rows of the points that are chosen in a tile, in the order they are chosen.

    Parameters
    ----------
    xyz : ndarray of int32, shape (n, 3)
        All lengths are lattice steps; x, y relative to `corner`.
    seeds : ndarray of int64, shape (k, 3)
        Points of other tiles that are chosen already.
    corner : tuple of int
    reach : int
        Minimum distance.
    """
    lowest, highest = limits_of(xyz)
    inside = (seeds[:, :2] > -reach) & (seeds[:, :2] < highest[:2] + reach)
    seeds = seeds[inside.all(axis=1)]
    order = _by_hash(_hashes(xyz, corner[0], corner[1]))
    # One cell of margin, so that no neighbour's number is negative.
    low = np.minimum(lowest, seeds.min(axis=0, initial=np.iinfo(np.int32).max)) - reach
    size = 1 << max(int(np.ceil(np.log2(2 * (len(xyz) + len(seeds))))), 4)
    return _choose(xyz, order, seeds, low, np.int64(reach), size)


@kernel
def _hashes(xyz: np.ndarray, corner_x: int, corner_y: int) -> np.ndarray:
    """Splitmix64 of the absolute lattice coordinates: an order without direction or pattern."""
    out = np.empty(len(xyz), np.uint64)
    for i in range(len(xyz)):
        value = np.uint64(0)
        for part in (xyz[i, 0] + corner_x, xyz[i, 1] + corner_y, np.int64(xyz[i, 2])):
            value = (value ^ np.uint64(part)) + np.uint64(0x9E3779B97F4A7C15)
            value = (value ^ (value >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
            value = (value ^ (value >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
            value = value ^ (value >> np.uint64(31))
        out[i] = value
    return out


@kernel
def _by_hash(hashes: np.ndarray) -> np.ndarray:
    """Return the rows in the order of their hashes, equal ones in their own order.

    Hashes are spread evenly, so that their first bits bring each nearly to where it belongs.
    """
    bits = 1
    while 1 << bits < len(hashes):
        bits += 1
    shift = np.uint64(64 - bits)
    starts = np.zeros((1 << bits) + 1, np.int64)
    for value in hashes:
        starts[(value >> shift) + np.uint64(1)] += 1
    starts = starts.cumsum()
    order = np.empty(len(hashes), np.int64)
    for i in range(len(hashes)):
        bucket = hashes[i] >> shift
        order[starts[bucket]] = i
        starts[bucket] += 1
    for i in range(1, len(order)):
        row, j = order[i], i - 1
        while j >= 0 and hashes[order[j]] > hashes[row]:
            order[j + 1] = order[j]
            j -= 1
        order[j + 1] = row
    return order


@kernel
def _slot(cell: int, table: np.ndarray, cells: np.ndarray, mask: np.uint64) -> np.uint64:
    """Return the slot of a cell in an open hash table: its own, or the empty one for it."""
    slot = np.uint64(cell) * np.uint64(0x9E3779B97F4A7C15)
    slot = (slot >> np.uint64(32)) & mask
    while table[slot] >= 0 and cells[slot] != cell:
        slot = (slot + np.uint64(1)) & mask
    return slot


@kernel
def _is_free(
    x: int,
    y: int,
    z: int,
    reach: int,
    table: np.ndarray,
    cells: np.ndarray,
    mask: np.uint64,
    chosen: np.ndarray,
    following: np.ndarray,
) -> bool:
    """Whether no chosen point is closer than `reach`; the search begins in the point's own cell."""
    cell = _cell(x, y, z, reach)
    for a in (0, -1, 1):
        for b in (0, -1, 1):
            for c in (0, -1, 1):
                other = table[_slot(cell + a + b * ROW + c * LEVEL, table, cells, mask)]
                while other >= 0:
                    dx, dy, dz = chosen[other, 0] - x, chosen[other, 1] - y, chosen[other, 2] - z
                    if dx * dx + dy * dy + dz * dz < reach * reach:
                        return False
                    other = following[other]
    return True


@kernel
def _cell(x: int, y: int, z: int, reach: int) -> int:
    """Pack the numbers of a cell of edge `reach` into one."""
    return x // reach + y // reach * ROW + z // reach * LEVEL


@kernel
def _choose(
    xyz: np.ndarray, order: np.ndarray, seeds: np.ndarray, low: np.ndarray, reach: int, size: int
) -> np.ndarray:
    """Return the rows of `xyz` chosen in order; `seeds` are chosen already. All in lattice steps."""
    mask = np.uint64(size - 1)
    table = np.full(size, -1, np.int32)
    cells = np.empty(size, np.int64)
    chosen = np.empty((len(seeds) + len(xyz), 3), np.int64)
    following = np.empty(len(seeds) + len(xyz), np.int32)
    kept = np.empty(len(xyz), np.int64)
    count = 0
    for i in range(-len(seeds), len(xyz)):
        if i < 0:
            x, y, z = seeds[i, 0] - low[0], seeds[i, 1] - low[1], seeds[i, 2] - low[2]
        else:
            row = order[i]
            x, y, z = xyz[row, 0] - low[0], xyz[row, 1] - low[1], xyz[row, 2] - low[2]
            if not _is_free(x, y, z, reach, table, cells, mask, chosen, following):
                continue
            kept[count - len(seeds)] = row
        cell = _cell(x, y, z, reach)
        slot = _slot(cell, table, cells, mask)
        cells[slot] = cell
        chosen[count, 0], chosen[count, 1], chosen[count, 2] = x, y, z
        following[count] = table[slot]
        table[slot] = count
        count += 1
    return kept[: count - len(seeds)]
