"""The points of a site by tile, wherever they are: on this computer, or on a cluster."""

import os
from abc import ABC, abstractmethod
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from typing import Any, Callable, Optional

import numpy as np

from ...parallel import in_order
from ...progress import Progress
from ..cloud import Cloud

Key = tuple[int, int]
"""Column and row of a tile."""


@dataclass(frozen=True)
class Tile:
    """The points of one square tile.

    Attributes
    ----------
    corner : tuple of int
        Lower left corner, lattice steps.
    xyz : ndarray of int32, shape (n, 3)
        x, y relative to the corner, z absolute; lattice steps.
    index : ndarray of int64, shape (n,)
        Number of each point in the cloud, over all files in order; empty if points are not numbered.
    edge : int
        Edge of the tile, lattice steps.
    """

    corner: tuple[int, int]
    xyz: np.ndarray
    index: np.ndarray
    edge: int

    @property
    def key(self) -> Key:
        """Column and row of the tile."""
        return self.corner[0] // self.edge, self.corner[1] // self.edge

    def subset(self, rows: np.ndarray) -> "Tile":
        """Return the tile with some of its points."""
        return replace(self, xyz=self.xyz[rows], index=self.index[rows] if len(self.index) else self.index)


class Tiles(ABC):
    """Tiles that can be read one by one.

    Attributes
    ----------
    edge : int
        Edge of a tile, lattice steps.
    cores : int
        How many tiles should be worked on at a time.
    """

    edge: int
    cores: int = os.cpu_count() or 1

    @abstractmethod
    def counts(self) -> dict[Key, int]:
        """Return the number of points by tile (column, row)."""

    @abstractmethod
    def tile(self, key: Key) -> Tile:
        """Return the tile in column and row `key`, its points in the cloud's order."""

    def tiles(self, keys: Sequence[Key], progress: Progress, message: str) -> Iterator[tuple[Key, Tile]]:
        """Yield (key, tile) in the order of `keys`, reporting progress."""
        counts = self.counts()
        total = max(sum(counts[key] for key in keys), 1)
        done = 0
        for key in keys:
            progress.update(done / total, message)
            yield key, self.tile(key)
            done += counts[key]


class SortedTiles(Tiles):
    """All tiles of a cloud, and what is done to them where they are.

    What is done are functions of a module, and their arguments, so that both can be sent to another computer.
    They return something, and change nothing.

    Attributes
    ----------
    point_count, stray_count : int
        Points of the cloud, and those of them that are in no tile because they are too far away.
    block_side : int or None
        Columns, and rows, of the tiles that are worked on together; even. None if all are.
    """

    point_count: int
    stray_count: int
    block_side: Optional[int] = None

    @abstractmethod
    def keep_where(
        self,
        choose: Callable[..., tuple[np.ndarray, Any]],
        jobs: Mapping[Key, tuple[Any, ...]],
        progress: Progress,
        message: str,
    ) -> Iterator[tuple[Key, Any]]:
        """Leave out all but some points of tiles.

        Parameters
        ----------
        choose : callable(Tile, ...)
            Returns the rows that are kept, which ascend, and what is yielded.
        jobs : dict of tuple
            Further arguments of `choose`, by tile.
        progress : Progress
        message : str

        Yields
        ------
        key, result
            In any order.
        """

    def each(
        self,
        work: Callable[..., Any],
        jobs: Mapping[Key, tuple[Any, ...]],
        progress: Progress,
        message: str,
    ) -> Iterator[tuple[Key, Any]]:
        """Yield (key, work(tile, ...)) in any order; `jobs` holds the further arguments by tile."""

        def run(item: tuple[Key, Tile]) -> tuple[Key, Any]:
            key, tile = item
            return key, work(tile, *jobs[key])

        return in_order(run, self.tiles(list(jobs), progress, message))

    def on_parts(
        self,
        work: Callable[..., Any],
        parts: Sequence[tuple[list[Key], tuple[Any, ...]]],
        progress: Progress,
        message: str,
    ) -> Iterator[Any]:
        """Work on several tiles at a time.

        Parameters
        ----------
        work : callable(Tiles, Progress, list of tuple of int, ...)
        parts : sequence of (list of tuple of int, tuple)
            The tiles that are needed, and further arguments of `work`.
        progress : Progress
        message : str

        Yields
        ------
        object
            What `work` returns, in the order of the parts.
        """
        for number, (keys, arguments) in enumerate(parts):
            own = progress.part(number / len(parts), (number + 1) / len(parts))
            yield work(self, own, keys, *arguments)


Sorter = Callable[[Cloud, float, bool, Progress], AbstractContextManager[SortedTiles]]
"""Sorts a cloud into tiles of an edge in metres, whose points may be numbered."""


def by_block(keys: Iterable[Key], side: Optional[int]) -> dict[Key, list[Key]]:
    """Return the tiles of each block of `side` columns and rows, by its own column and row."""
    if side is None:
        return {(0, 0): list(keys)}
    blocks: dict[Key, list[Key]] = defaultdict(list)
    for key in keys:
        blocks[key[0] // side, key[1] // side].append(key)
    return dict(blocks)
