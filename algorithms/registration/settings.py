"""The five models of the transformation, and the settings of a registration."""

import math
from dataclasses import dataclass, field
from enum import Enum
from typing import Optional

from .adjustment.settings import AdjustmentSettings
from .lists.settings import ListSettings
from .matching.settings import MatchingSettings
from .simulation.settings import SimulationSettings
from .surfaces.settings import SurfaceSettings


class Model(Enum):
    """Which parameters of the similarity A = m R B + T are unknown; the values are those of MODEL."""

    RIGID = 0
    SIMILARITY = 1
    LEVELLED = 2
    LEVELLED_SCALE = 3
    UNKNOWN_SCALE = 4

    @property
    def levelled(self) -> bool:
        """Whether the scan rotates about the vertical only."""
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
        """The smallest number of targets that determines a solution."""
        return 2 if self.levelled else 3


class Matching(Enum):
    """How a target is matched with a control point; the values are those of MATCHING."""

    DISTANCES = 0
    NAMES = 1


@dataclass(frozen=True)
class Settings:
    """What a user chooses, and the settings of the stages.

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
    most_std : float or None
        A scan with a larger standard deviation is warned of, metres; None is `std_factor` times `sigma`.
    lists : ListSettings
    matches : MatchingSettings
    adjustment : AdjustmentSettings
    simulation : SimulationSettings
    surfaces : SurfaceSettings
    """

    matching: Matching = Matching.DISTANCES
    model: Model = Model.RIGID
    sigma: float = 0.003
    control_sigma: float = 0.0
    tolerance: Optional[float] = None
    most_std: Optional[float] = None
    lists: ListSettings = field(default=ListSettings())
    matches: MatchingSettings = field(default=MatchingSettings())
    adjustment: AdjustmentSettings = field(default=AdjustmentSettings())
    simulation: SimulationSettings = field(default=SimulationSettings())
    surfaces: SurfaceSettings = field(default=SurfaceSettings())

    @property
    def named(self) -> bool:
        """Whether names identify the control point of a target."""
        return self.matching is Matching.NAMES

    @property
    def free_scale(self) -> bool:
        """Whether the scale may be any, not only near 1: if unknown, or if names identify the points."""
        return self.model is Model.UNKNOWN_SCALE or (self.named and self.model.scaled)

    @property
    def std_limit(self) -> float:
        """The standard deviation from which on a scan is warned of, metres."""
        return self.adjustment.std_factor * self.sigma if self.most_std is None else self.most_std

    @property
    def distance_factor(self) -> float:
        """How many standard deviations two distances that match may differ by."""
        if self.tolerance is None:
            return self.matches.tolerances.distance_factor
        return self.tolerance / self._distance_std

    @property
    def distance_tolerance(self) -> float:
        """The tolerance of distances between surveyed points: the user's, or the derived one, metres."""
        return self.distance_factor * self._distance_std

    @property
    def _distance_std(self) -> float:
        """The standard deviation of the difference of two distances."""
        return math.sqrt(2 * self.sigma**2 + 2 * self.control_sigma**2)
