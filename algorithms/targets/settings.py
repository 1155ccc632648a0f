"""Settings of the search for targets."""

from dataclasses import dataclass, field
from enum import Enum
from typing import Optional

import numpy as np

from ..settings import judged, physical
from .checkerboards.settings import CheckerboardSettings
from .range_image.settings import RangeImageSettings
from .spheres.settings import SphereSettings


class Wanted(Enum):
    """KIND: what is searched for."""

    BOTH = 0
    CHECKERBOARDS = 1
    SPHERES = 2


@dataclass(frozen=True)
class TargetSettings:
    """What is searched for, and the constants of all stages.

    Attributes
    ----------
    wanted : Wanted
    size : float, optional
        Width of the pattern or diameter of the sphere, metres; without it the usual ones are tried.
    station : ndarray of float64, shape (3,), optional
        Position of the scanner, for clouds that do not state it; without it, their origin.
    """

    wanted: Wanted = Wanted.BOTH
    size: Optional[float] = None
    station: Optional[np.ndarray] = None
    range_image: RangeImageSettings = field(default=RangeImageSettings())
    checkerboards: CheckerboardSettings = field(default=CheckerboardSettings())
    spheres: SphereSettings = field(default=SphereSettings())
    most_candidates: int = judged(
        1500, "Of each kind and station; a quarter of a minute of fits. Targets are among the best."
    )
    same_place: float = physical(0.6, "In units of the size: targets do not overlap.")
    tiled_reach: float = physical(2.5, "In units of the size: corners of tiles within it are the next ones.")
    most_tiles: int = judged(1, "Crossings that may lie beside a target, as that of a second target.")
    most_large: int = judged(
        2, "Places near a target where fields cross that are larger: paint and panels; large tiles have more."
    )
    view: float = judged(1.6, "Height of a picture in the report, in units of the size.")
    view_pixels: int = judged(160, "Most rows of such a picture.")
