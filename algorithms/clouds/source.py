"""What the reader of every cloud format offers: a file that streams its points in chunks."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

import numpy as np
from rasterio.crs import CRS

from ..errors import InputError
from ..progress import Progress


@dataclass(frozen=True)
class Chunk:
    """Consecutive points of one file.

    Attributes
    ----------
    xyz : ndarray of float64, shape (n, 3)
        Metres, relative to the origin of the cloud; always finite.
    intensity : ndarray of uint16, shape (n,), or None
        None if the file has none.
    rgb : ndarray of uint16, shape (n, 3), or None
        0..65535; None if the file has no colour.
    attributes : dict of str to ndarray, shape (n,)
        What else the points have, by name; see `Source.attributes`.
    scan : ndarray of int, shape (n,), or None
        The scan of the file that each point is from; None if the file does not say.
    station : ndarray of float64, shape (3,), or None
        Position of the scanner, relative to the origin of the cloud; None if the file does not say. All
        points of a chunk are of one scan then.
    """

    xyz: np.ndarray
    intensity: Optional[np.ndarray]
    rgb: Optional[np.ndarray]
    attributes: dict[str, np.ndarray] = field(default_factory=dict)
    scan: Optional[np.ndarray] = None
    station: Optional[np.ndarray] = None

    def subset(self, rows: np.ndarray) -> "Chunk":
        """Return some of the points, without attributes, scan and station."""
        return Chunk(
            self.xyz[rows],
            None if self.intensity is None else self.intensity[rows],
            None if self.rgb is None else self.rgb[rows],
        )


@dataclass(frozen=True)
class Source(ABC):
    """A file whose beginning was examined and that can be streamed any number of times.

    It holds no open file, so it can be sent to another process.

    Attributes
    ----------
    path : Path
    crs : CRS or None
        Horizontal coordinate reference system that the file itself states.
    warnings : tuple of str
        What the user should know about this file, in sentences.
    middle : ndarray of float64, shape (3,)
        A position amid the points, in the coordinates of the file.
    has_intensity, has_rgb : bool
        Whether the chunks carry them.
    """

    path: Path
    crs: Optional[CRS]
    warnings: tuple[str, ...]
    middle: np.ndarray
    has_intensity: bool
    has_rgb: bool

    @property
    def attributes(self) -> tuple[tuple[str, np.dtype], ...]:
        """Names and types of what else the chunks carry; normals are rotated with the points."""
        return ()

    @property
    def others(self) -> tuple[str, ...]:
        """What the points have besides coordinates, intensity and colour, by the names in the file."""
        return tuple(name for name, _ in self.attributes)

    @abstractmethod
    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order, `size` at a time, relative to `origin`.

        Raises
        ------
        InputError
            If the file is truncated or damaged.
        CancelledError
            If the caller asked to stop.
        """

    def positions(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[np.ndarray]:
        """Yield the positions of all points, as `chunks` does; formats that can skip the rest do."""
        for chunk in self.chunks(origin, progress, size):
            yield chunk.xyz

    def runs(self, points: int) -> "tuple[Source, ...]":
        """Return parts of the file, of so many points in its order, that can be read each on its own.

        The file itself is the only one if it can be read from the beginning only.
        """
        return (self,)

    @property
    def expected_points(self) -> int:
        """How many points the file announces; 0 if it does not."""
        return 0


def unreadable(path: Path, error: OSError) -> InputError:
    """Return the error for a file that the operating system refuses to read."""
    reason = error.strerror or error
    return InputError(f"{path} cannot be read ({reason}); check that it exists and that you may read it.")


def truncated(path: Path, detail: str) -> InputError:
    """Return the error for a file that ends early."""
    return InputError(f"{path} is truncated ({detail}); copy or export it again.")


def no_points(path: Path) -> InputError:
    """Return the error for a file that is sound but empty."""
    return InputError(f"{path} holds no points; leave it out or export it again.")
