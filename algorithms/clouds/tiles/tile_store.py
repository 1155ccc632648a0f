"""Points of a site sorted into square tiles on disk, so that the whole cloud is never in memory."""

import tempfile
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from types import TracebackType
from typing import IO, Optional

import numpy as np

from ...errors import InputError
from ...progress import Progress
from ..cloud import Cloud, names_of
from ..settings import TileSettings
from .lattice import tiles_of, to_lattice

Key = tuple[int, int]
"""Column and row of a tile."""

_RECORD = np.dtype([("xyz", "<i4", 3), ("index", "<i8")])


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
        Number of each point in the cloud, over all files in order.
    edge : int
        Edge of the tile, lattice steps.
    """

    corner: tuple[int, int]
    xyz: np.ndarray
    index: np.ndarray
    edge: int


class TileStore:
    """A temporary file that holds points by tile; a context manager.

    Parameters
    ----------
    edge : float
        Edge of a tile in metres.
    settings : TileSettings
    """

    def __init__(self, edge: float, settings: TileSettings = TileSettings()) -> None:
        self.edge = to_lattice(edge)
        self.settings = settings
        self.point_count = 0
        self.stray_count = 0
        self._parts: dict[Key, list[tuple[int, int]]] = defaultdict(list)
        self._end = 0
        self._open_file: Optional[IO[bytes]] = None

    def __enter__(self) -> "TileStore":
        with _full_disk_named():
            self._open_file = tempfile.TemporaryFile(prefix="ichnograph-", buffering=0)
        return self

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        traceback: Optional[TracebackType],
    ) -> None:
        # What is not written yet is not needed any more, even if the disk is full.
        with suppress(OSError):
            self._file.close()

    @property
    def _file(self) -> IO[bytes]:
        if self._open_file is None:
            raise ValueError("the store of tiles is not open")
        return self._open_file

    def add(self, xyz: np.ndarray, origin: np.ndarray) -> None:
        """Sort points into their tiles.

        Parameters
        ----------
        xyz : ndarray of float64, shape (n, 3)
            Metres, relative to `origin`.
        origin : ndarray of float64, shape (3,)
            Whole metres.
        """
        index = np.arange(self.point_count, self.point_count + len(xyz))
        self.point_count += len(xyz)
        near = np.abs(xyz[:, 2] + origin[2]) < self.settings.max_height_m
        for axis in (0, 1):
            near &= np.abs(xyz[:, axis]) < self.settings.max_distance_m
        if not near.all():
            self.stray_count += int((~near).sum())
            xyz, index = xyz[near], index[near]
        key, records = _by_tile(xyz, np.rint(origin).astype(np.int64), index, self.edge)
        starts = np.flatnonzero(np.r_[True, (np.diff(key, axis=0) != 0).any(axis=1)][: len(key)])
        for start, stop in zip(starts, np.r_[starts[1:], len(key)]):
            self._parts[tuple(key[start].tolist())].append((self._end + start, stop - start))
        self._append(records)

    def counts(self) -> dict[Key, int]:
        """Return the number of points by tile (column, row)."""
        return {key: sum(n for _, n in parts) for key, parts in self._parts.items()}

    def tile(self, key: Key) -> Tile:
        """Read the tile in column and row `key`, its points in the cloud's order."""
        records = self._records(key)
        corner = (key[0] * self.edge, key[1] * self.edge)
        return Tile(corner, np.ascontiguousarray(records["xyz"]), records["index"], self.edge)

    def keep(self, key: Key, rows: np.ndarray) -> None:
        """Leave out all but some rows of the tile `key`."""
        records = self._records(key)[rows]
        self._parts[key] = [(self._end, len(records))]
        self._append(records)

    def _records(self, key: Key) -> np.ndarray:
        blocks = []
        for start, count in self._parts[key]:
            self._file.seek(int(start) * _RECORD.itemsize)
            with _full_disk_named():
                block = np.fromfile(self._file, _RECORD, int(count))
                if len(block) < count:
                    raise OSError("it ends early")
            blocks.append(block)
        return np.concatenate(blocks)

    def _append(self, records: np.ndarray) -> None:
        self._file.seek(self._end * _RECORD.itemsize)
        with _full_disk_named():
            # numpy's own writing does not notice a full disk.
            left = memoryview(records.view(np.uint8))
            while len(left):
                left = left[self._file.write(left) :]
        self._end += len(records)

    def tiles(self, keys: list[Key], progress: Progress, message: str) -> Iterator[tuple[Key, Tile]]:
        """Yield (key, tile) in the order of `keys`, reporting progress."""
        counts = self.counts()
        total = max(sum(counts[key] for key in keys), 1)
        done = 0
        for key in keys:
            progress.update(done / total, message)
            yield key, self.tile(key)
            done += counts[key]


@contextmanager
def _full_disk_named() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise InputError(
            f"The temporary file of the points cannot be written or read ({error.strerror or error}); free "
            "some space in the temporary folder, or set TMPDIR to a folder on a larger disk."
        ) from error


def _by_tile(
    xyz: np.ndarray, origin: np.ndarray, index: np.ndarray, edge: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return tile keys (n, 2) and records (n,), both sorted by row, then column; a stable order."""
    key, steps = tiles_of(xyz, origin, edge)
    column, row = (key - key.min(axis=0)).T if len(key) else key.T
    # Scanners write neighbours in sequence, and a stable sort is fast on what is sorted already.
    order = np.argsort(row * (column.max(initial=0) + 1) + column, kind="stable")
    records = np.empty(len(key), _RECORD)
    records["xyz"] = steps[order]
    records["index"] = index[order]
    return key[order], records


def fill(store: TileStore, cloud: Cloud, progress: Progress) -> None:
    """Sort a whole cloud into `store`.

    Raises
    ------
    InputError
        If too many of the points are stray.
    """
    for chunk in cloud.chunks(progress):
        store.add(chunk.xyz, cloud.origin)
    if store.stray_count > store.settings.max_stray_share * store.point_count:
        kilometres = store.settings.max_height_m / 1000
        raise InputError(
            f"{names_of(cloud.sources)}: {store.stray_count} of {store.point_count} points lie more than "
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
