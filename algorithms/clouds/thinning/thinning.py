"""Thinning to a minimum distance between neighbours in space (Mueller et al. 2012, section 2.1)."""

import math
from collections import deque
from collections.abc import Collection, Iterable, Iterator
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Callable

import numpy as np

from ...parallel import begun_only
from ...progress import Progress
from ..cloud import Cloud
from ..settings import ThinningSettings
from ..tiles.lattice import to_lattice
from ..tiles.tile_store import sort_here, stray_warning
from ..tiles.tiles import Key, Sorter, Tile, Tiles, by_block
from .neighbour_table import choose

Waiting = deque[tuple[Key, Tile, Future[tuple[np.ndarray, np.ndarray]]]]
"""Tiles that are being thinned, the rows of their chosen points, and those of them near other tiles."""


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
    warnings: tuple[str, ...]


def thin_cloud(
    cloud: Cloud,
    spacing: float,
    progress: Progress = Progress(),
    settings: ThinningSettings = ThinningSettings(),
    sort: Sorter = sort_here,
) -> ThinnedCloud:
    """Thin a cloud so that no two points are closer than `spacing` metres; see `thin_tiles`.

    Parameters
    ----------
    cloud : Cloud
    spacing : float
        Minimum distance in metres.
    progress : Progress
    settings : ThinningSettings
    sort : Sorter
        Where the points are sorted and thinned.

    Raises
    ------
    InputError
        If the coordinates are not those of a site.
    """
    with sort(cloud, tile_edge(spacing, settings), True, progress.part(0.0, 0.5)) as store:
        among = set(store.counts())
        parts = [
            (deciding(own, among), (own, spacing, settings))
            for own in by_block(sorted(among), store.block_side).values()
        ]
        kept = store.on_parts(_numbers, parts, progress.part(0.5, 1.0), "Thinning")
        numbers = np.sort(np.concatenate(list(kept)))
        stray = stray_warning(cloud, store.stray_count, store.point_count)
        return ThinnedCloud(numbers, store.point_count, (*cloud.warnings, *stray))


def _numbers(
    tiles: Tiles,
    progress: Progress,
    keys: list[Key],
    own: list[Key],
    spacing: float,
    settings: ThinningSettings,
) -> np.ndarray:
    """Thin the tiles `keys`, and return the numbers of the points that are chosen in those of `own`."""
    counted = set(own)
    thinned = thin_tiles(tiles, keys, spacing, progress, settings)
    return np.concatenate([tile.index[rows] for tile, rows in thinned if tile.key in counted])


def tile_edge(spacing: float, settings: ThinningSettings = ThinningSettings()) -> float:
    """Return the tile edge (m) at which a point's neighbours lie in its own or an adjacent tile."""
    return settings.tile_edge_m * math.ceil(spacing / settings.tile_edge_m)


def deciding(keys: Iterable[Key], among: Collection[Key]) -> list[Key]:
    """Return the tiles on which the choice of points in some tiles depends, these included.

    They are what is thinned before a tile and touches it, what is thinned before that and touches that, and
    so on: three columns and a row away at most.

    Parameters
    ----------
    keys : iterable of tuple of int
        The tiles in which points are chosen.
    among : collection of tuple of int
        All tiles; fast to ask.
    """
    found = set(keys)
    for turn in ((1, 1), (1, 0), (0, 1)):
        if len(found) == len(among):
            break
        found.update(
            other
            for key in [key for key in found if _order(key)[:2] == turn]
            for other in _around(key)
            if _order(other)[:2] < turn and other in among
        )
    return sorted(found)


def thin_tiles(
    store: Tiles,
    keys: list[Key],
    spacing: float,
    progress: Progress,
    settings: ThinningSettings = ThinningSettings(),
    beside: Callable[[Tile], None] = lambda tile: None,
) -> Iterator[tuple[Tile, np.ndarray]]:
    """Choose points so that no two are closer than `spacing` and every other point is closer to one.

    Points are taken greedily: tile by tile, those of even rows and columns first, and within a tile
    in the order of a hash of the coordinates. Both depend on nothing but the coordinates, so that
    the choice is the same however the cloud is cut into files and chunks, and whatever the order of
    its points. Tiles that are taken together do not touch, and are thinned in parallel.

    Parameters
    ----------
    store : Tiles
        All points, in tiles of `tile_edge(spacing)`.
    keys : list of tuple of int
        The tiles to thin.
    spacing : float
        Minimum distance in metres.
    progress : Progress
    settings : ThinningSettings
    beside : callable
        Called for each tile on all cores, at once for tiles that do not touch.

    Yields
    ------
    tile : Tile
        All points of the tile.
    kept : ndarray of int64
        Rows of the chosen points in the tile, in the order they were chosen.
    """
    reach = to_lattice(spacing)
    rims: dict[Key, np.ndarray] = {}
    waiting: Waiting = deque()
    enough = settings.waiting_tiles * store.cores
    keys = sorted(keys, key=_order)

    def thin(tile: Tile, seeds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        beside(tile)
        kept = choose(tile.xyz, seeds, tile.corner, reach)
        return kept, _rim(tile, kept, reach)

    with begun_only(store.cores) as pool:
        for key, tile in store.tiles(keys, progress, "Thinning"):
            # A tile needs the rims of its neighbours, which are thinned before.
            while waiting and (len(waiting) > enough or _order(waiting[0][0])[:2] != _order(key)[:2]):
                yield _finished(waiting, rims)
            waiting.append((key, tile, pool.submit(thin, tile, _seeds(key, rims, store.edge))))
        while waiting:
            yield _finished(waiting, rims)


def _order(key: Key) -> tuple[int, int, int, int]:
    column, row = key
    return row % 2, column % 2, row, column


def _around(key: Key) -> list[Key]:
    """Return the eight tiles that touch a tile."""
    column, row = key
    return [(column + x, row + y) for y in (-1, 0, 1) for x in (-1, 0, 1) if x or y]


def _rim(tile: Tile, kept: np.ndarray, reach: int) -> np.ndarray:
    """Return the chosen points of a tile that can be near another tile's."""
    chosen = tile.xyz[kept].astype(np.int64)
    rim = (chosen[:, :2] < reach) | (chosen[:, :2] >= tile.edge - reach)
    return chosen[rim.any(axis=1)]


def _finished(waiting: Waiting, rims: dict[Key, np.ndarray]) -> tuple[Tile, np.ndarray]:
    """Take the longest waiting tile, and note its rim."""
    key, tile, work = waiting.popleft()
    kept, rims[key] = work.result()
    return tile, kept


def _seeds(key: Key, rims: dict[Key, np.ndarray], edge: int) -> np.ndarray:
    """Return the chosen points of the tiles around `key`, relative to its corner."""
    near = [
        rims[other] + np.array([(other[0] - key[0]) * edge, (other[1] - key[1]) * edge, 0])
        for other in _around(key)
        if other in rims
    ]
    return np.concatenate(near) if near else np.empty((0, 3), np.int64)
