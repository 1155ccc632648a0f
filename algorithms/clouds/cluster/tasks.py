"""What workers do: functions without side effects, so that Dask can repeat them if a worker is lost."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable

import numpy as np

from ...errors import InputError
from ...progress import Progress
from ..settings import ReadingSettings, TileSettings
from ..source import Source
from ..tiles.counting_sort import sort_by_tile
from ..tiles.tiles import Key, Tile, Tiles

Block = dict[Key, Tile]
"""The tiles of a block."""

Records = dict[Key, list[tuple[int, np.ndarray]]]
"""Parts of tiles, each with the number of the point that its own numbers are counted from."""


@dataclass(frozen=True)
class Call:
    """A function and its arguments; Dask does not look for tasks in it, as it would in a tuple."""

    function: Callable[..., Any]
    arguments: Any


@dataclass(frozen=True)
class Run:
    """Consecutive points of a file, and how they are sorted.

    Attributes
    ----------
    source : Source
    size : int
        Bytes of the file, by which another file of the same path is noticed.
    origin : ndarray of float64, shape (3,)
        Whole metres.
    edge : int
        Of a tile, lattice steps.
    is_numbered : bool
        Whether tiles know the numbers of their points.
    """

    source: Source
    size: int
    origin: np.ndarray
    edge: int
    is_numbered: bool


@dataclass(frozen=True)
class Summary:
    """What is known of a sorted run without its points.

    Attributes
    ----------
    point_count, stray_count : int
        All points, and those of them that are in no tile.
    counts : dict of int
        Points by tile.
    messages : tuple of str
        What the reader of the file said.
    """

    point_count: int
    stray_count: int
    counts: dict[Key, int]
    messages: tuple[str, ...]


def plugin_version() -> str:
    """Return the version of the toolbox."""
    text = Path(__file__).parents[3].joinpath("metadata.txt").read_text(encoding="utf-8")
    return next(line for line in text.splitlines() if line.startswith("version=")).partition("=")[2]


def sort_run(run: Run, settings: TileSettings = TileSettings()) -> tuple[Summary, Records]:
    """Sort the points of a run into tiles.

    Raises
    ------
    InputError
        If the worker cannot read the file, or not the same.
    """
    path = run.source.path
    found = path.stat().st_size if path.is_file() else None
    if found is None:
        raise InputError(
            f"SCHEDULER: a worker does not find {path}; keep the clouds where all workers find them by the "
            "same path."
        )
    if found != run.size:
        raise InputError(
            f"SCHEDULER: a worker finds another file than this computer as {path}; keep the clouds where all "
            "workers find them by the same path."
        )
    messages: dict[str, None] = {}
    progress = Progress(lambda _, message: messages.setdefault(message))
    records: Records = {}
    whole = np.rint(run.origin).astype(np.int64)
    farthest = settings.max_distance_m, settings.max_height_m
    done = sorted_points = 0
    for xyz in run.source.positions(run.origin, progress, ReadingSettings.chunk_points):
        keys, starts, own = sort_by_tile(xyz, whole, run.edge, *farthest, run.is_numbered)
        for key, start, stop in zip(keys.tolist(), starts[:-1].tolist(), starts[1:].tolist()):
            records.setdefault((key[0], key[1]), []).append((done, own[start:stop]))
        done += len(xyz)
        sorted_points += len(own)
    counts = {key: sum(len(part) for _, part in parts) for key, parts in records.items()}
    said = tuple(message for message in messages if message)
    return Summary(done, done - sorted_points, counts, said), records


def summary_of(run: tuple[Summary, Records]) -> Summary:
    """Return what is known of a sorted run without its points."""
    return run[0]


def part_of(run: tuple[Summary, Records], keys: Iterable[Key]) -> Records:
    """Return some tiles of a sorted run, all of which it holds."""
    return {key: run[1][key] for key in keys}


def block_of(parts: list[Records], firsts: list[int], edge: int) -> Block:
    """Join the parts of the tiles of a block.

    Parameters
    ----------
    parts : list of dict
        Of each run, in the order of the cloud.
    firsts : list of int
        Number of the first point of each run in the cloud.
    edge : int
        Of a tile, lattice steps.
    """
    found: Records = {}
    for first, part in zip(firsts, parts):
        for key, records in part.items():
            found.setdefault(key, []).extend((first + start, own) for start, own in records)
    return {key: _joined(key, records, edge) for key, records in found.items()}


def _joined(key: Key, parts: list[tuple[int, np.ndarray]], edge: int) -> Tile:
    records = np.concatenate([own for _, own in parts])
    index = np.zeros(0, np.int64)
    if records.shape[1] > 3:
        first = np.repeat(np.array([first for first, _ in parts], np.int64), [len(own) for _, own in parts])
        index = first + records[:, 3]
    return Tile((key[0] * edge, key[1] * edge), np.ascontiguousarray(records[:, :3]), index, edge)


def subset(block: Block, keys: Iterable[Key]) -> Block:
    """Return some tiles of a block."""
    return {key: block[key] for key in keys}


def each(block: Block, call: Call) -> list[tuple[Key, Any]]:
    """Call a function for tiles; the arguments of the call are the further ones of the function, by tile."""
    return [(key, call.function(block[key], *arguments)) for key, arguments in call.arguments.items()]


def kept_of(block: Block, call: Call) -> tuple[Block, list[tuple[Key, tuple[int, Any]]]]:
    """Leave out points; see `SortedTiles.keep_where`.

    Returns
    -------
    block : dict
        With all its tiles.
    found : list of (key, (number of points, result))
    """
    left, found = dict(block), []
    for key, (rows, result) in each(block, call):
        left[key] = block[key].subset(rows)
        found.append((key, (len(rows), result)))
    return left, found


def first_of(pair: tuple[Any, Any]) -> Any:
    """Return the first of a pair."""
    return pair[0]


def second_of(pair: tuple[Any, Any]) -> Any:
    """Return the second of a pair."""
    return pair[1]


def on_part(blocks: list[Block], call: Call) -> Any:
    """Call a function for the tiles of blocks; see `SortedTiles.on_parts`."""
    tiles = {key: tile for block in blocks for key, tile in block.items()}
    return call.function(HeldTiles(tiles), Progress(), list(tiles), *call.arguments)


class HeldTiles(Tiles):
    """Tiles in memory, worked on by one thread: a worker has a task for each of its own."""

    cores = 1

    def __init__(self, tiles: Mapping[Key, Tile]) -> None:
        self.edge = next(iter(tiles.values())).edge
        self._tiles = tiles

    def counts(self) -> dict[Key, int]:
        """See `Tiles.counts`."""
        return {key: len(tile.xyz) for key, tile in self._tiles.items()}

    def tile(self, key: Key) -> Tile:
        """See `Tiles.tile`."""
        return self._tiles[key]
