"""The five models of the transformation, and the settings of a registration."""

from dataclasses import dataclass
from enum import Enum
from typing import Optional


class Model(Enum):
    """Which parameters of the similarity A = m R B + T are unknown; the values are those of MODEL."""

    RIGID = 0
    SIMILARITY = 1
    LEVELLED = 2
    LEVELLED_SCALE = 3
    UNKNOWN_SCALE = 4

    @property
    def levelled(self) -> bool:
        """Whether the scan turns about the vertical only."""
        return self in (Model.LEVELLED, Model.LEVELLED_SCALE)

    @property
    def scaled(self) -> bool:
        """Whether the scale m is unknown."""
        return self in (Model.SIMILARITY, Model.LEVELLED_SCALE, Model.UNKNOWN_SCALE)

    @property
    def unknowns(self) -> int:
        """The number u of parameters of a scan."""
        return 3 + (1 if self.levelled else 3) + self.scaled

    @property
    def least_targets(self) -> int:
        """The number of targets without which there is no solution."""
        return 2 if self.levelled else 3


class Matching(Enum):
    """How a target finds its control point; the values are those of MATCHING."""

    DISTANCES = 0
    NAMES = 1


@dataclass(frozen=True)
class Settings:
    """What a user can choose.

    Attributes
    ----------
    matching : Matching
    model : Model
    sigma : float
        A priori standard deviation of a target's coordinate, in the control frame, metres.
    control_sigma : float
        The same of a surveyed coordinate, metres; 0 holds surveyed points fixed.
    tolerance : float or None
        Largest difference of two distances that match (the paper's eps_t), metres; None derives it from the
        standard deviations.
    """

    matching: Matching = Matching.DISTANCES
    model: Model = Model.RIGID
    sigma: float = 0.003
    control_sigma: float = 0.0
    tolerance: Optional[float] = None
