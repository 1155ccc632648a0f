"""What the search for targets returns."""

from dataclasses import dataclass, field
from enum import Enum
from typing import Optional

import numpy as np
from rasterio.crs import CRS


class Kind(Enum):
    """What a target looks like."""

    CHECKERBOARD = "black and white"
    SPHERE = "sphere"


@dataclass(frozen=True)
class Target:
    """A target that was found.

    Attributes
    ----------
    kind : Kind
    xyz : ndarray of float64, shape (3,)
        The centre, relative to the scanner, in the directions of the axes of the file.
    covariance : ndarray, shape (3, 3)
        Of the centre, square metres.
    size : float
        Width of the pattern, or diameter of the sphere, metres.
    points : int
        On which the centre rests.
    incidence_deg : float or None
        Angle between the ray and the normal of the plane; None for spheres.
    quality : float
        From 0 to 1: how well the points agree with the target, and how much of it was seen.
    doubt : str
        Why it may not be a target; empty if there is no doubt.
    possible : tuple of float
        The sizes that the points allow, metres; one if the size is certain.
    """

    kind: Kind
    xyz: np.ndarray
    covariance: np.ndarray
    size: float
    points: int
    incidence_deg: Optional[float]
    quality: float
    doubt: str = ""
    possible: tuple[float, ...] = ()

    @property
    def std(self) -> float:
        """Standard deviation of the centre in space, metres."""
        return float(np.sqrt(np.trace(self.covariance)))


@dataclass(frozen=True)
class Rejection:
    """What looked like a target, and the test that it failed.

    Attributes
    ----------
    kind : Kind
    xyz : ndarray, shape (3,)
        Relative to the scanner.
    test : str
        What was tested, in words.
    passed : int
        Number of tests before this one.
    value, limit : float
        What was found, and what would have passed.
    unit : str
    """

    kind: Kind
    xyz: np.ndarray
    test: str
    passed: int
    value: float
    limit: float
    unit: str = ""

    @property
    def miss(self) -> float:
        """How far the value is from the limit, as a ratio of at least 1."""
        low, high = sorted((abs(self.value), abs(self.limit)))
        return high / max(low, 1e-9)


@dataclass(frozen=True)
class View:
    """A target as the scanner saw it.

    Attributes
    ----------
    picture : ndarray of uint8, shape (rows, columns)
        Intensities, or ranges where there are none, from dark to bright; from the upper left corner.
    centre : tuple of 2 float
        Column and row of the fitted centre.
    height : float
        Of the picture, at the distance of the target, metres.
    """

    picture: np.ndarray
    centre: tuple[float, float]
    height: float


@dataclass(frozen=True)
class StationTargets:
    """The targets of one station.

    Attributes
    ----------
    name : str
        Of the scan.
    position : ndarray of float64, shape (3,)
        Of the scanner, in the coordinates of the file.
    step : float
        Angle between neighbouring points, radians.
    points : int
    has_intensity : bool
    targets : tuple of Target
        Sure ones first, then doubtful ones; each from the left to the right.
    views : tuple of View
        One for each target.
    rejections : tuple of Rejection
    """

    name: str
    position: np.ndarray
    step: float
    points: int
    has_intensity: bool
    targets: tuple[Target, ...]
    views: tuple[View, ...]
    rejections: tuple[Rejection, ...]

    @property
    def sure(self) -> tuple[Target, ...]:
        """The targets without doubt."""
        return tuple(target for target in self.targets if not target.doubt)

    def place(self, target: Target) -> np.ndarray:
        """Return the centre of a target in the coordinates of the file."""
        return np.asarray(self.position + target.xyz)

    @property
    def places(self) -> np.ndarray:
        """The centres of the targets without doubt in the coordinates of the file, shape (n, 3)."""
        return np.array([self.place(target) for target in self.sure]).reshape(-1, 3)

    @property
    def covariances(self) -> np.ndarray:
        """Their covariances, square metres, shape (n, 3, 3)."""
        return np.array([target.covariance for target in self.sure]).reshape(-1, 3, 3)


@dataclass(frozen=True)
class TargetSearch:
    """The targets of all stations.

    Attributes
    ----------
    stations : tuple of StationTargets
    crs : CRS or None
    warnings : tuple of str
    """

    stations: tuple[StationTargets, ...]
    crs: Optional[CRS] = None
    warnings: tuple[str, ...] = field(default=())

    @property
    def count(self) -> int:
        """Number of targets without doubt."""
        return sum(len(station.sure) for station in self.stations)
