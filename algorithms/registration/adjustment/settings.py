"""The settings of the adjustment: its tests, its iteration, and what counts as a line."""

from dataclasses import dataclass
from functools import cached_property

from scipy import stats

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class OutlierTestSettings:
    """The tests for outliers, and the global test."""

    significance: float = statistical(
        0.001, "Baarda's choice for data snooping: one false alarm in a thousand coordinates."
    )
    power: float = statistical(
        0.80, "Baarda's choice: an error of the minimal detectable size is found in 80 of 100 cases."
    )
    global_significance: float = statistical(
        0.05, "Of the global test, both sides together: one sound adjustment in twenty is doubted."
    )
    weak_redundancy: float = judged(
        0.1, "Below this redundancy number, hardly anything of an error shows in the residual."
    )
    least_redundancy: float = judged(
        1e-9, "A smaller redundancy number is rounding error: no other observation checks the coordinate."
    )

    @cached_property
    def critical_w(self) -> float:
        """The |w| beyond which an observation is suspected: 3.29 by default."""
        return float(stats.norm.isf(self.significance / 2))

    @cached_property
    def noncentrality(self) -> float:
        """Baarda's delta0, the shift of w that the test detects with its power: 4.13 by default."""
        return self.critical_w + float(stats.norm.ppf(self.power))


@dataclass(frozen=True)
class IterationSettings:
    """The Gauss-Newton iteration of the least squares adjustments."""

    most_rounds: int = judged(
        50, "The start values are good to the outliers, so that a handful of rounds is enough; this stops it."
    )
    smallest_step: float = judged(
        1e-10, "Metres and radians: far below the noise of any instrument, far above rounding error."
    )


@dataclass(frozen=True)
class ScaleTestSettings:
    """The t-test whether the scale differs from 1."""

    significance: float = statistical(
        0.01, "One scan in a hundred with the true scale 1 is reported as having another."
    )
    least_projection_ppm: float = physical(
        50.0, "Projections and heights above the ellipsoid change lengths by more than this on most sites."
    )
    least_projection_m: float = physical(
        0.005, "Targets and prisms differ by a few millimetres, which over a few metres looks like a scale."
    )


@dataclass(frozen=True)
class LayoutSettings:
    """Which layouts of targets count as a line, and which rotations have no unique angles."""

    flat_share: float = judged(
        1e-3,
        "Where the scale is unknown, targets that are narrower than this share of their extent count as a "
        "line.",
    )
    least_cosine: float = judged(
        1e-6, "Below this cosine of rotation_y only the sum of the other two angles is known."
    )


@dataclass(frozen=True)
class AdjustmentSettings:
    """The settings of the adjustment."""

    tests: OutlierTestSettings = OutlierTestSettings()
    iteration: IterationSettings = IterationSettings()
    scale_test: ScaleTestSettings = ScaleTestSettings()
    layout: LayoutSettings = LayoutSettings()
    std_factor: float = judged(
        10.0,
        "A scan is warned of if its targets are this many times less accurate than a picked target, as at "
        "the end of a long chain.",
    )
