"""Thinning to a minimum distance between neighbours in space (Mueller et al. 2012, section 2.1)."""

import math
import os
from collections import deque
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numba import njit

from ...progress import Progress
from ..cloud import Cloud
from ..tiles.tile_store import Tile, TileStore, fill, stray_warning, to_lattice

TILE_EDGE = 4.0
"""Edge of a tile in metres: small enough for a tile to stay in the processor's cache."""

ROW, LEVEL = 1 << 16, 1 << 32
"""Steps of a cell's packed number from row to row and level to level of a tile."""


@dataclass(frozen=True)
class ThinnedCloud:
    """The points that remain of a cloud.

    Attributes
    ----------
    kept : ndarray of int64, shape (n,)
        Their numbers in the cloud, over all files in order; increasing.
    points_in : int
        Number of points before.
    warnings : tuple of str
    """

    kept: np.ndarray
    points_in: int
    warnings: tuple


def thin_cloud(cloud: Cloud, spacing: float, progress: Progress = Progress()) -> ThinnedCloud:
    """Thin a cloud so that no two points are closer than `spacing` metres; see `thin_tiles`.

    Raises
    ------
    InputError
        If the coordinates fit no site.
    """
    with TileStore(tile_edge(spacing)) as store:
        fill(store, cloud, progress.part(0.0, 0.5))
        thinned = thin_tiles(store, list(store.counts()), spacing, progress.part(0.5, 1.0))
        kept = np.sort(np.concatenate([tile.index[rows] for tile, rows in thinned]))
        stray = stray_warning(cloud, store.stray_count, store.point_count)
        return ThinnedCloud(kept, store.point_count, (*cloud.warnings, *stray))


def tile_edge(spacing: float) -> float:
    """Return the tile edge (m) at which a point's neighbours lie in its own or an adjacent tile."""
    return TILE_EDGE * math.ceil(spacing / TILE_EDGE)


def thin_tiles(
    store: TileStore, keys: list, spacing: float, progress: Progress
) -> Iterator[tuple[Tile, np.ndarray]]:
    """Choose points so that no two are closer than `spacing` and every other point is closer to one.

    Points are taken greedily: tile by tile, those of even rows and columns first, and within a tile
    in the order of a hash of the coordinates. Both depend on nothing but the coordinates, so that
    the choice is the same however the cloud is cut into files and chunks, and whatever the order of
    its points. Tiles that are taken together do not touch, and are thinned in parallel.

    Parameters
    ----------
    store : TileStore
        All points, in tiles of `tile_edge(spacing)`.
    keys : list of tuple of int
        The tiles to thin.
    spacing : float
        Minimum distance in metres.

    Yields
    ------
    tile : Tile
        All points of the tile.
    kept : ndarray of int64
        Rows of the chosen points in the tile, in the order they were chosen.
    """
    reach = to_lattice(spacing)
    rims = {}
    waiting = deque()
    workers = os.cpu_count() or 1
    keys = sorted(keys, key=_turn)
    with ThreadPoolExecutor(workers) as pool:
        for key, tile in store.tiles(keys, progress, "Thinning"):
            # A tile needs the rims of its neighbours, whose turn came before.
            while waiting and (len(waiting) > 2 * workers or _turn(waiting[0][0])[:2] != _turn(key)[:2]):
                yield _finished(waiting, rims, store.edge, reach)
            seeds = _seeds(key, rims, store.edge)
            waiting.append((key, tile, pool.submit(_thin, tile.xyz, seeds, tile.corner, reach)))
        while waiting:
            yield _finished(waiting, rims, store.edge, reach)


def _turn(key: tuple) -> tuple:
    column, row = key
    return row % 2, column % 2, row, column


def _finished(waiting: deque, rims: dict, edge: int, reach: int) -> tuple[Tile, np.ndarray]:
    """Take the longest waiting tile, and note its chosen points that can be near another tile's."""
    key, tile, work = waiting.popleft()
    kept = work.result()
    chosen = tile.xyz[kept].astype(np.int64)
    rim = (chosen[:, :2] < reach) | (chosen[:, :2] >= edge - reach)
    rims[key] = chosen[rim.any(axis=1)]
    return tile, kept


def _seeds(key: tuple, rims: dict, edge: int) -> np.ndarray:
    """Return the chosen points of the tiles around `key`, relative to its corner."""
    column, row = key
    near = [
        rims[column + x, row + y] + np.array([x * edge, y * edge, 0])
        for y in (-1, 0, 1)
        for x in (-1, 0, 1)
        if (x or y) and (column + x, row + y) in rims
    ]
    return np.concatenate(near) if near else np.empty((0, 3), np.int64)


def _thin(xyz: np.ndarray, seeds: np.ndarray, corner: tuple, reach: int) -> np.ndarray:
    inside = (seeds[:, :2] > -reach) & (seeds[:, :2] < xyz[:, :2].max(axis=0) + reach)
    seeds = seeds[inside.all(axis=1)]
    order = np.argsort(_hashes(xyz, corner[0], corner[1]), kind="stable")
    # One cell of margin, so that no neighbour's number is negative.
    low = np.minimum(xyz.min(axis=0), seeds.min(axis=0, initial=np.iinfo(np.int32).max)) - reach
    size = 1 << max(int(np.ceil(np.log2(2 * (len(xyz) + len(seeds))))), 4)
    return order[_choose(xyz[order], seeds, low.astype(np.int64), np.int64(reach), size)]


@njit(nogil=True, cache=True)
def _hashes(xyz, corner_x, corner_y):
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


@njit(nogil=True, cache=True)
def _slot(cell, table, cells, mask):
    """Return the slot of a cell in an open hash table: its own, or the empty one for it."""
    slot = np.uint64(cell) * np.uint64(0x9E3779B97F4A7C15)
    slot = (slot >> np.uint64(32)) & mask
    while table[slot] >= 0 and cells[slot] != cell:
        slot = (slot + np.uint64(1)) & mask
    return slot


@njit(nogil=True, cache=True)
def _is_free(x, y, z, reach, table, cells, mask, chosen, following):
    """Tell whether no chosen point is closer than `reach`; the point's own cell is asked first."""
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


@njit(nogil=True, cache=True)
def _cell(x, y, z, reach):
    """Pack the numbers of a cell of edge `reach` into one."""
    return x // reach + y // reach * ROW + z // reach * LEVEL


@njit(nogil=True, cache=True)
def _choose(xyz, seeds, low, reach, size):
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
            x, y, z = xyz[i, 0] - low[0], xyz[i, 1] - low[1], xyz[i, 2] - low[2]
            if not _is_free(x, y, z, reach, table, cells, mask, chosen, following):
                continue
            kept[count - len(seeds)] = i
        cell = _cell(x, y, z, reach)
        slot = _slot(cell, table, cells, mask)
        cells[slot] = cell
        chosen[count, 0], chosen[count, 1], chosen[count, 2] = x, y, z
        following[count] = table[slot]
        table[slot] = count
        count += 1
    return kept[: count - len(seeds)]
