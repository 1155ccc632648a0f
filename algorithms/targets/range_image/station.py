"""The points of a station, relative to the scanner."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import Optional

import numpy as np

from ...clouds.settings import ReadingSettings
from ...clouds.source import Chunk, Source
from ...errors import InputError
from ...progress import Progress


@dataclass(frozen=True)
class Station:
    """A scan of one station.

    Attributes
    ----------
    position : ndarray of float64, shape (3,)
        Of the scanner, in the coordinates of the file.
    xyz : ndarray of float32, shape (n, 3)
        Relative to the scanner; at 100 m exact to 4 micrometres.
    intensity : ndarray of uint16, shape (n,), or None
    """

    position: np.ndarray
    xyz: np.ndarray
    intensity: Optional[np.ndarray]


def read_stations(
    source: Source, chosen: Optional[np.ndarray] = None, progress: Progress = Progress()
) -> Iterator[Station]:
    """Yield the stations of a file, one at a time.

    Parameters
    ----------
    source : Source
    chosen : ndarray of float64, shape (3,), optional
        Position of the scanner in a file that does not state it. Without it, the origin of the coordinates.
    progress : Progress

    Raises
    ------
    InputError
        If the file is damaged, or states positions although one is chosen.
    """
    chunks = source.chunks(np.zeros(3), progress, ReadingSettings.chunk_points)
    for _, parts in groupby(chunks, key=_scan_of):
        yield _joined(source, parts, chosen)


def _scan_of(chunk: Chunk) -> int:
    return -1 if chunk.scan is None or chunk.station is None else int(chunk.scan[0])


def _joined(source: Source, chunks: Iterator[Chunk], chosen: Optional[np.ndarray]) -> Station:
    """Return the station of consecutive chunks; they are moved to the scanner before they lose decimals."""
    positions, xyz, intensity = [], [], []
    for chunk in chunks:
        if chunk.station is not None and chosen is not None:
            raise InputError(f"{source.path} states where its scanner stood; leave STATION empty.")
        stated = np.zeros(3) if chosen is None else chosen
        positions.append(stated if chunk.station is None else chunk.station)
        xyz.append((chunk.xyz - positions[0]).astype(np.float32))
        if chunk.intensity is not None:
            intensity.append(chunk.intensity)
    return Station(positions[0], np.concatenate(xyz), np.concatenate(intensity) if intensity else None)
