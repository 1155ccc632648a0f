"""Wall pixels of a density image: thresholds, criteria, combination, closing (section 2.2)."""

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Optional

import numpy as np

from ...errors import NothingFoundError
from ...progress import Progress
from ...settings import judged, physical
from .closing import bridge_corners, close_gaps
from .height_gate import Gate, Heights, make_gate
from .regions import Criteria, Selection, select_regions
from .settings import ClosingSettings, WallSettings
from .thresholds import Thresholds, choose_thresholds


@dataclass(frozen=True)
class WallParameters:
    """The five parameters of the paper, the height gate, and the advanced two. None derives a value.

    Attributes
    ----------
    threshold, threshold_max : float or None
        Lowest and highest threshold in standard deviations of the density image.
    min_area : float or None
        Smallest region, m2; derived: a metre of a wall one pixel thick.
    max_fill : float
        Largest area / bounding box area of a curved wall.
    min_elongation : float
        Smallest major / minor axis of the best-fit ellipse of a straight wall.
    closing : float or None
        Widest gap that is closed, metres; derived: see `ClosingSettings`.
    min_height : float
        Least occupied height of a wall pixel, metres; 0 gives the paper's plain chain.
    threshold_steps : int
        Number of thresholds.
    """

    threshold: Optional[float] = None
    min_area: Optional[float] = None
    max_fill: float = judged(0.4, "A curved wall covers much less than its bounding box (the paper).")
    min_elongation: float = judged(3.0, "A straight wall is much longer than thick (the paper).")
    closing: Optional[float] = None
    min_height: float = physical(0.4, "Floors, beams and slab edges occupy less; low ruins occupy more.")
    threshold_steps: int = judged(10, "Walls of any density stand out at one of so many thresholds.")
    threshold_max: Optional[float] = None

    def criteria(self, pixel_size: float) -> Criteria:
        """Return the region criteria for pixels of a size in metres."""
        min_area = pixel_size * 1.0 if self.min_area is None else self.min_area
        return Criteria(min_area, self.max_fill, self.min_elongation)

    def gap(self, gate: Gate, settings: ClosingSettings = ClosingSettings()) -> float:
        """Return the widest gap to close behind a height gate, in metres."""
        if self.closing is not None:
            return self.closing
        return settings.blind_m if gate.open_ground is None else settings.seen_m


class Verdict(IntEnum):
    """What the criteria say of a pixel at one threshold."""

    FAINT = 0
    SMALL = 1
    MISSHAPEN = 2
    KEPT = 3


@dataclass(frozen=True)
class ThresholdStep:
    """What the criteria did at one threshold.

    Attributes
    ----------
    threshold : float
        In standard deviations of the density image.
    regions, too_small, wrong_shape : int
        Number of regions above the threshold, and of those removed by area and by both shape criteria.
    verdicts : ndarray of uint8, shape (n,)
        `Verdict` of each pixel that may be wall, row by row: other pixels need no memory.
    """

    threshold: float
    regions: int
    too_small: int
    wrong_shape: int
    verdicts: np.ndarray


@dataclass(frozen=True)
class WallImage:
    """Wall pixels, and what became of all others.

    Attributes
    ----------
    walls : ndarray of bool, shape (rows, columns)
    votes : ndarray of uint8, shape (rows, columns)
        Number of thresholds at which the pixel belonged to a wall region, before closing.
    gated : ndarray of float, shape (rows, columns)
        The density that the thresholds were applied to; 0 where no wall may stand.
    gate : Gate
        Where the heights let a wall stand.
    thresholds : Thresholds
    steps : tuple of ThresholdStep
        One for each threshold, the lowest first.
    gap : float
        Widest gap that was closed, metres.
    criteria : Criteria
    parameters : WallParameters
        As they were given.
    settings : WallSettings
    """

    walls: np.ndarray
    votes: np.ndarray
    gated: np.ndarray
    gate: Gate
    thresholds: Thresholds
    steps: tuple[ThresholdStep, ...]
    gap: float
    criteria: Criteria
    parameters: WallParameters
    settings: WallSettings = field(default_factory=WallSettings)

    def verdicts(self, step: ThresholdStep) -> np.ndarray:
        """Return the `Verdict` of every pixel at a threshold; uint8, shape (rows, columns)."""
        verdicts = np.full(self.gated.shape, Verdict.FAINT, np.uint8)
        verdicts[self.gated > 0] = step.verdicts
        return verdicts

    def removed(self, verdict: Verdict) -> np.ndarray:
        """Return the pixels with a verdict at any threshold; bool, shape (rows, columns)."""
        removed = np.zeros(self.gated.shape, bool)
        removed[self.gated > 0] = np.any([step.verdicts == verdict for step in self.steps], axis=0)
        return removed


def extract_wall_pixels(
    density: np.ndarray,
    heights: Optional[Heights],
    pixel_size: float,
    parameters: WallParameters,
    progress: Progress = Progress(),
    settings: WallSettings = WallSettings(),
) -> WallImage:
    """Find the wall pixels of a density image.

    Parameters
    ----------
    density : ndarray of float, shape (rows, columns)
        Nan where no point contributes.
    heights : Heights or None
        None if only the density is known.
    pixel_size : float
        Metres.
    parameters : WallParameters
        What counts as wall.
    progress : Progress
        Reports and cancels.
    settings : WallSettings

    Raises
    ------
    NothingFoundError
        If no region is left; the message says what removed them.
    """
    gate = make_gate(density, heights, parameters.min_height, pixel_size, settings.height_gate)
    thresholds = choose_thresholds(
        density,
        gate.flat,
        gate.tall,
        parameters.threshold,
        parameters.threshold_max,
        parameters.threshold_steps,
    )
    gated = np.where(gate.tall, np.nan_to_num(density), 0.0)
    possible = gated > 0
    criteria = parameters.criteria(pixel_size)
    votes = np.zeros(gated.shape, np.uint8)
    steps = []
    for i, value in enumerate(thresholds.values):
        progress.update(i / len(thresholds.values), f"Threshold {value:.2f}")
        binary = possible & (gated >= value * thresholds.deviation)
        selection = select_regions(binary, pixel_size, criteria, gate.column, settings.regions)
        votes += selection.kept
        steps.append(_step(value, selection, possible))
    if not votes.any():
        raise NothingFoundError(_what_removed(gate, parameters, criteria, steps))
    progress.update(1.0, "Closing gaps")
    gap = parameters.gap(gate, settings.closing)
    walls = close_gaps(votes > 0, pixel_size, gap, gate.open_ground, settings.closing)
    progress.check()
    walls = bridge_corners(walls, gated)
    return WallImage(walls, votes, gated, gate, thresholds, tuple(steps), gap, criteria, parameters, settings)


def _step(value: float, selection: Selection, possible: np.ndarray) -> ThresholdStep:
    """Note what the criteria did, in the memory of the pixels that may be wall."""
    verdicts = np.full(np.count_nonzero(possible), Verdict.FAINT, np.uint8)
    verdicts[selection.small[possible]] = Verdict.SMALL
    verdicts[selection.misshapen[possible]] = Verdict.MISSHAPEN
    verdicts[selection.kept[possible]] = Verdict.KEPT
    return ThresholdStep(value, selection.regions, selection.too_small, selection.wrong_shape, verdicts)


def _what_removed(
    gate: Gate, parameters: WallParameters, criteria: Criteria, steps: list[ThresholdStep]
) -> str:
    regions = sum(step.regions for step in steps)
    small = sum(step.too_small for step in steps)
    shape = sum(step.wrong_shape for step in steps)
    if not regions and gate.tall.any():
        return (
            f"No wall found: no pixel of the {int(gate.tall.sum())} that MIN_HEIGHT "
            f"{parameters.min_height:g} m left is as dense as THRESHOLD {steps[0].threshold:.3g} standard "
            "deviations; lower it, or leave it empty."
        )
    return (
        f"No wall found: MIN_HEIGHT {parameters.min_height:g} m left {int(gate.tall.sum())} of "
        f"{gate.tall.size} pixels; over {len(steps)} thresholds from "
        f"{steps[0].threshold:.3g} to {steps[-1].threshold:.3g} standard deviations they formed "
        f"{regions} regions, of which MIN_AREA {criteria.min_area:g} m² removed {small}, and "
        f"MAX_FILL {criteria.max_fill:g} with MIN_ELONGATION {criteria.min_elongation:g} removed "
        f"{shape}; relax the one that removed most."
    )
