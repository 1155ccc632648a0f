"""Points of a site sorted into square tiles on disk, so that the whole cloud is never in memory.

Coordinates are integers on a lattice of 10 micrometres, fixed to the coordinate system's origin. A tile's
border, a pixel's edge and a distance are then the same however the cloud is cut into files or chunks, and at
any size of the coordinates.
"""

import tempfile
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numba import njit

from ...errors import InputError
from ...progress import Progress
from ..cloud import Cloud, names_of

LATTICE = 1e-5
"""Step of the lattice, in metres: a tenth of the finest step that scanners' files use."""

FINE = 1e-7
"""Step of the integers that coordinates are rounded from, in metres; finer than files are written."""

MAX_HEIGHT = 20_000.0
"""Heights beyond this, in metres, fit no site: stray measurements or geocentric coordinates."""

MAX_DISTANCE = 1e9
"""Points farther than this (m) from the others are stray; the lattice's integers end not much later."""

_RECORD = np.dtype([("xyz", "<i4", 3), ("index", "<i8")])


def to_lattice(metres: float) -> int:
    """Return a length in steps of the lattice."""
    return round(metres / LATTICE)


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

    corner: tuple
    xyz: np.ndarray
    index: np.ndarray
    edge: int


class TileStore:
    """A temporary file that holds points by tile; a context manager.

    Parameters
    ----------
    edge : float
        Edge of a tile in metres.
    """

    def __init__(self, edge: float) -> None:
        self.edge = to_lattice(edge)
        self.point_count = 0
        self.stray_count = 0
        self._parts = defaultdict(list)
        self._end = 0
        self._file = None

    def __enter__(self) -> "TileStore":
        self._file = tempfile.TemporaryFile(prefix="ichnograph-")
        return self

    def __exit__(self, *exception) -> None:
        self._file.close()

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
        near = np.abs(xyz[:, 2] + origin[2]) < MAX_HEIGHT
        for axis in (0, 1):
            near &= np.abs(xyz[:, axis]) < MAX_DISTANCE
        if not near.all():
            self.stray_count += int((~near).sum())
            xyz, index = xyz[near], index[near]
        key, records = _by_tile(xyz, np.rint(origin).astype(np.int64), index, self.edge)
        starts = np.flatnonzero(np.r_[True, (np.diff(key, axis=0) != 0).any(axis=1)][: len(key)])
        for start, stop in zip(starts, np.r_[starts[1:], len(key)]):
            self._parts[tuple(key[start].tolist())].append((self._end + start, stop - start))
        self._append(records)

    def counts(self) -> dict:
        """Return the number of points by tile (column, row)."""
        return {key: sum(n for _, n in parts) for key, parts in self._parts.items()}

    def tile(self, key: tuple) -> Tile:
        """Read the tile in column and row `key`, its points in the cloud's order."""
        records = self._records(key)
        corner = (key[0] * self.edge, key[1] * self.edge)
        return Tile(corner, np.ascontiguousarray(records["xyz"]), records["index"], self.edge)

    def keep(self, key: tuple, rows: np.ndarray) -> None:
        """Leave out all but some rows of the tile `key`."""
        records = self._records(key)[rows]
        self._parts[key] = [(self._end, len(records))]
        self._append(records)

    def _records(self, key: tuple) -> np.ndarray:
        blocks = []
        for start, count in self._parts[key]:
            self._file.seek(int(start) * _RECORD.itemsize)
            blocks.append(np.fromfile(self._file, _RECORD, int(count)))
        return np.concatenate(blocks)

    def _append(self, records: np.ndarray) -> None:
        self._file.seek(self._end * _RECORD.itemsize)
        records.tofile(self._file)
        self._end += len(records)

    def tiles(self, keys: list, progress: Progress, message: str) -> Iterator[tuple]:
        """Yield (key, tile) in the order of `keys`, reporting progress."""
        counts = self.counts()
        total = max(sum(counts[key] for key in keys), 1)
        done = 0
        for key in keys:
            progress.update(done / total, message)
            yield key, self.tile(key)
            done += counts[key]


def _by_tile(xyz: np.ndarray, origin: np.ndarray, index: np.ndarray, edge: int) -> tuple:
    """Return tile keys (n, 2) and records (n,), both sorted by row, then column; a stable order."""
    key, place = _place(np.ascontiguousarray(xyz), origin, edge, round(1 / FINE), round(LATTICE / FINE))
    column, row = (key - key.min(axis=0)).T if len(key) else key.T
    # Scanners write neighbours in sequence, and a stable sort is fast on what is sorted already.
    order = np.argsort(row * (column.max(initial=0) + 1) + column, kind="stable")
    records = np.empty(len(key), _RECORD)
    records["xyz"] = place[order]
    records["index"] = index[order]
    return key[order], records


@njit(nogil=True, cache=True)
def _place(xyz, origin, edge, per_metre, steps):
    """Return the tile of each point, and its lattice coordinates about the tile's corner."""
    key = np.empty((len(xyz), 2), np.int64)
    place = np.empty((len(xyz), 3), np.int32)
    for i in range(len(xyz)):
        for axis in range(2):
            value = _rounded(xyz[i, axis], origin[axis], per_metre, steps)
            key[i, axis] = value // edge
            place[i, axis] = value - key[i, axis] * edge
        place[i, 2] = _rounded(xyz[i, 2], origin[2], per_metre, steps)
    return key, place


@njit(nogil=True, cache=True)
def _rounded(value, origin, per_metre, steps):
    """Round to the lattice by way of finer integers: a tie must not depend on the origin."""
    fine = np.int64(np.rint(value * per_metre)) + origin * per_metre
    return (fine + steps // 2) // steps


def fill(store: TileStore, cloud: Cloud, progress: Progress) -> None:
    """Sort a whole cloud into `store`.

    Raises
    ------
    InputError
        If the heights of more than 1 % of the points fit no site.
    """
    for chunk in cloud.chunks(progress):
        store.add(chunk.xyz, cloud.origin)
    if store.stray_count > 0.01 * store.point_count:
        raise InputError(
            f"{names_of(cloud.sources)}: {store.stray_count} of {store.point_count} points lie more than "
            f"{MAX_HEIGHT / 1000:.0f} km high or deep; transform geocentric coordinates to a projected "
            "coordinate reference system in metres first."
        )


def stray_warning(cloud: Cloud, stray: int, total: int) -> tuple:
    """Return the sentence that says how many points are left out, or nothing."""
    if not stray:
        return ()
    return (
        f"{names_of(cloud.sources)}: {stray} of {total} points lie far away from the site and are left out.",
    )
