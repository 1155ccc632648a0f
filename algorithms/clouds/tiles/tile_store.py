"""Points of a site sorted into square tiles; what exceeds a budget of memory is on disk."""

import shutil
import tempfile
from collections import defaultdict
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from types import TracebackType
from typing import IO, Any, Callable, Optional

import numpy as np

from ...errors import InputError
from ...progress import Progress
from ..cloud import Cloud, names_of
from ..settings import TileSettings
from .counting_sort import sort_by_tile
from .lattice import to_lattice
from .tiles import Key, SortedTiles, Tile


@dataclass(frozen=True)
class _Block:
    """The records of one chunk, sorted by tile: in memory, or in the file from some byte on."""

    first: int
    records: Optional[np.ndarray]
    start: int


class TileStore(SortedTiles):
    """Points by tile, 12 bytes each, in memory and beyond a budget in a temporary file; a context manager.

    Parameters
    ----------
    edge : float
        Edge of a tile in metres.
    settings : TileSettings
    is_numbered : bool
        Whether tiles know the numbers of their points, which takes 4 bytes more.
    """

    def __init__(
        self, edge: float, settings: TileSettings = TileSettings(), is_numbered: bool = False
    ) -> None:
        self.edge = to_lattice(edge)
        self.settings = settings
        self.width = 4 if is_numbered else 3
        self.point_count = 0
        self.stray_count = 0
        self._blocks: list[_Block] = []
        self._parts: dict[Key, list[tuple[int, int, int]]] = defaultdict(list)
        self._in_memory = self._end = 0
        self._open_file: Optional[IO[bytes]] = None
        self._is_open = False

    def __enter__(self) -> "TileStore":
        self._is_open = True
        return self

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        traceback: Optional[TracebackType],
    ) -> None:
        self._is_open = False
        self._blocks.clear()
        # What is not written yet is not needed any more, even if the disk is full.
        with suppress(OSError):
            if self._open_file is not None:
                self._open_file.close()

    @property
    def _file(self) -> IO[bytes]:
        if self._open_file is None:
            with _full_disk_named():
                # Closed in __exit__.
                self._open_file = tempfile.TemporaryFile(prefix="ichnograph-", buffering=0)  # noqa: SIM115
        return self._open_file

    def expect(self, count: int) -> None:
        """Refuse points for which the temporary folder has no room.

        Raises
        ------
        InputError
            If what does not fit into the budget of memory does not fit into the folder either.
        """
        beyond = count * 4 * self.width - self.settings.memory_bytes
        if beyond <= 0:
            return
        with _full_disk_named():
            folder = tempfile.gettempdir()
            free = shutil.disk_usage(folder).free
        if beyond > free:
            raise InputError(
                f"The temporary folder {folder} has {free / 1e9:.1f} GB free, "
                f"but {count:,} points take up to {beyond / 1e9:.1f} GB; "
                "free some space, or set TMPDIR to a folder on a larger disk."
            )

    def add(self, xyz: np.ndarray, origin: np.ndarray) -> None:
        """Sort points into their tiles.

        Parameters
        ----------
        xyz : ndarray of float64, shape (n, 3)
            Metres, relative to `origin`.
        origin : ndarray of float64, shape (3,)
            Whole metres.
        """
        if not self._is_open:
            raise ValueError("the store of tiles is not open")
        farthest, highest = self.settings.max_distance_m, self.settings.max_height_m
        whole = np.rint(origin).astype(np.int64)
        keys, starts, records = sort_by_tile(xyz, whole, self.edge, farthest, highest, self.width == 4)
        for key, start, stop in zip(keys.tolist(), starts[:-1].tolist(), starts[1:].tolist()):
            self._parts[key[0], key[1]].append((len(self._blocks), start, stop - start))
        self._append(records)
        self.point_count += len(xyz)
        self.stray_count += len(xyz) - len(records)

    def counts(self) -> dict[Key, int]:
        """See `Tiles.counts`."""
        return {key: sum(count for _, _, count in parts) for key, parts in self._parts.items()}

    def tile(self, key: Key) -> Tile:
        """Read a tile; see `Tiles.tile`."""
        parts = self._parts[key]
        records = np.concatenate([self._read(*part) for part in parts])
        firsts = np.array([self._blocks[part[0]].first for part in parts], np.int64)
        first = np.repeat(firsts, [part[2] for part in parts])
        index = first + records[:, 3] if self.width == 4 else np.zeros(0, np.int64)
        corner = (key[0] * self.edge, key[1] * self.edge)
        return Tile(corner, np.ascontiguousarray(records[:, :3]), index, self.edge)

    def keep(self, key: Key, rows: np.ndarray) -> None:
        """Leave out all but some rows of the tile `key`, which ascend; no more room is taken."""
        parts, begin = [], 0
        for block, start, count in self._parts[key]:
            first, last = np.searchsorted(rows, [begin, begin + count])
            own = rows[first:last] - begin
            self._replace(block, start, self._read(block, start, count)[own])
            parts.append((block, start, len(own)))
            begin += count
        self._parts[key] = parts

    def keep_where(
        self,
        choose: Callable[..., tuple[np.ndarray, Any]],
        jobs: Mapping[Key, tuple[Any, ...]],
        progress: Progress,
        message: str,
    ) -> Iterator[tuple[Key, Any]]:
        """See `SortedTiles.keep_where`."""
        for key, (rows, result) in self.each(choose, jobs, progress, message):
            self.keep(key, rows)
            yield key, result

    def _append(self, records: np.ndarray) -> None:
        """Keep the records of one more chunk, in the file if memory is used up."""
        if self._in_memory + records.nbytes <= self.settings.memory_bytes:
            self._in_memory += records.nbytes
            self._blocks.append(_Block(self.point_count, records, 0))
            return
        self._write(self._end, records)
        self._blocks.append(_Block(self.point_count, None, self._end))
        self._end += records.nbytes

    def _read(self, number: int, start: int, count: int) -> np.ndarray:
        block = self._blocks[number]
        if block.records is not None:
            return block.records[start : start + count]
        self._file.seek(block.start + start * 4 * self.width)
        with _full_disk_named():
            records = np.fromfile(self._file, np.int32, count * self.width)
            if len(records) < count * self.width:
                raise OSError("it ends early")
        return records.reshape(count, self.width)

    def _replace(self, number: int, start: int, records: np.ndarray) -> None:
        block = self._blocks[number]
        if block.records is not None:
            block.records[start : start + len(records)] = records
        else:
            self._write(block.start + start * 4 * self.width, records)

    def _write(self, position: int, records: np.ndarray) -> None:
        self._file.seek(position)
        with _full_disk_named():
            # numpy's own writing does not notice a full disk.
            left = memoryview(np.ascontiguousarray(records).reshape(-1).view(np.uint8))
            while len(left):
                left = left[self._file.write(left) :]


@contextmanager
def _full_disk_named() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise InputError(
            f"The temporary file of the points cannot be written or read ({error.strerror or error}); free "
            "some space in the temporary folder, or set TMPDIR to a folder on a larger disk."
        ) from error


def fill(store: TileStore, cloud: Cloud, progress: Progress) -> None:
    """Sort a whole cloud into `store`.

    Raises
    ------
    InputError
        If too many of the points are stray, or the temporary folder has no room for them.
    """
    store.expect(cloud.expected_points)
    for xyz in cloud.positions(progress):
        store.add(xyz, cloud.origin)
    refuse_strays(cloud, store.stray_count, store.point_count, store.settings)


@contextmanager
def sort_here(
    cloud: Cloud, edge: float, is_numbered: bool, progress: Progress, settings: TileSettings = TileSettings()
) -> Iterator[SortedTiles]:
    """Sort a cloud into tiles on this computer; see `tiles.Sorter`."""
    with TileStore(edge, settings, is_numbered) as store:
        fill(store, cloud, progress)
        yield store


def refuse_strays(cloud: Cloud, stray: int, total: int, settings: TileSettings = TileSettings()) -> None:
    """Refuse a cloud of which too many points are too high or too far away to be sorted.

    Raises
    ------
    InputError
    """
    if stray > settings.max_stray_share * total:
        kilometres = settings.max_height_m / 1000
        raise InputError(
            f"{names_of(cloud.sources)}: {stray} of {total} points lie more than "
            f"{kilometres:.0f} km high or deep; transform geocentric coordinates to a projected "
            "coordinate reference system in metres first."
        )


def stray_warning(cloud: Cloud, stray: int, total: int) -> tuple[str, ...]:
    """Return the sentence that says how many points are left out, or nothing."""
    if not stray:
        return ()
    return (
        f"{names_of(cloud.sources)}: {stray} of {total} points lie far away from the site and are left out.",
    )
