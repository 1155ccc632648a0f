"""Sorted tiles on the workers of a cluster: only results come here, or tiles that are asked for."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any, Callable

import numpy as np

from ...progress import Progress
from ..tiles.tiles import Key, SortedTiles, Tile, by_block
from .connection import Cluster, Task
from .tasks import Block, Call, each, first_of, kept_of, on_part, second_of, subset


class RemoteTiles(SortedTiles):
    """All tiles of a cloud, on a cluster.

    Parameters
    ----------
    cluster : Cluster
    edge : int
        Of a tile, lattice steps.
    blocks : dict of future
        The tiles by block.
    counts : dict of int
        Points by tile.
    point_count, stray_count : int
    """

    def __init__(
        self,
        cluster: Cluster,
        edge: int,
        blocks: dict[Key, Any],
        counts: dict[Key, int],
        point_count: int,
        stray_count: int,
    ) -> None:
        self.edge = edge
        self.block_side = cluster.settings.block_tiles
        self.point_count, self.stray_count = point_count, stray_count
        self._cluster, self._blocks, self._counts = cluster, blocks, counts
        self._sizes = {block: len(keys) for block, keys in by_block(counts, self.block_side).items()}

    def counts(self) -> dict[Key, int]:
        """See `Tiles.counts`."""
        return dict(self._counts)

    def tile(self, key: Key) -> Tile:
        """Fetch a tile; see `Tiles.tile`."""
        found: Block = self._cluster.result(self._some(self._block_of(key), [key]), Progress())
        return found[key]

    def tiles(self, keys: Sequence[Key], progress: Progress, message: str) -> Iterator[tuple[Key, Tile]]:
        """Fetch tiles; those that follow each other in one block together. See `Tiles.tiles`."""
        groups = [(block, list(group)) for block, group in groupby(keys, self._block_of)]
        tasks = ((self._points(own), subset, (self._blocks[block], own)) for block, own in groups)
        for found in self._cluster.results(tasks, self._points(keys), progress, message):
            yield from found.items()

    def each(
        self,
        work: Callable[..., Any],
        jobs: Mapping[Key, tuple[Any, ...]],
        progress: Progress,
        message: str,
    ) -> Iterator[tuple[Key, Any]]:
        """Work on each tile where it is; see `SortedTiles.each`."""
        tasks = (
            (self._points(keys), each, (self._blocks[block], Call(work, {key: jobs[key] for key in keys})))
            for block, keys in by_block(jobs, self.block_side).items()
        )
        for found in self._cluster.results(tasks, self._points(jobs), progress, message):
            yield from found

    def keep_where(
        self,
        choose: Callable[..., tuple[np.ndarray, Any]],
        jobs: Mapping[Key, tuple[Any, ...]],
        progress: Progress,
        message: str,
    ) -> Iterator[tuple[Key, Any]]:
        """Leave out points where they are; see `SortedTiles.keep_where`."""
        blocks, found = {}, []
        for block, keys in by_block(jobs, self.block_side).items():
            call = Call(choose, {key: jobs[key] for key in keys})
            pair = self._cluster.submit(kept_of, self._blocks[block], call)
            blocks[block] = self._cluster.submit(first_of, pair)
            found.append((self._points(keys), second_of, (pair,)))
        total = self._points(jobs)
        self._blocks = {**self._blocks, **blocks}
        for kept in self._cluster.results(found, total, progress, message):
            for key, (count, result) in kept:
                self._counts[key] = count
                yield key, result

    def on_parts(
        self,
        work: Callable[..., Any],
        parts: Sequence[tuple[list[Key], tuple[Any, ...]]],
        progress: Progress,
        message: str,
    ) -> Iterator[Any]:
        """Work on several tiles at a time where most of them are; see `SortedTiles.on_parts`."""
        total = sum(self._points(keys) for keys, _ in parts)
        return self._cluster.results(self._tasks(work, parts), total, progress, message)

    def _tasks(
        self, work: Callable[..., Any], parts: Sequence[tuple[list[Key], tuple[Any, ...]]]
    ) -> Iterator[Task]:
        for keys, arguments in parts:
            blocks = by_block(keys, self.block_side).items()
            yield (
                self._points(keys),
                on_part,
                ([self._some(block, own) for block, own in blocks], Call(work, arguments)),
            )

    def _some(self, block: Key, keys: list[Key]) -> Any:
        """Return the future of some tiles of a block, or of all."""
        if len(keys) == self._sizes[block]:
            return self._blocks[block]
        return self._cluster.submit(subset, self._blocks[block], keys)

    def _block_of(self, key: Key) -> Key:
        side = self._cluster.settings.block_tiles
        return key[0] // side, key[1] // side

    def _points(self, keys: Any) -> int:
        return sum(self._counts[key] for key in keys)
