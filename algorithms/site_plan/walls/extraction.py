"""Wall pixels of a density image: thresholds, criteria, combination, closing (section 2.2)."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from ...errors import NothingFoundError
from ...progress import Progress
from .closing import bridge_corners, close_gaps
from .height_gate import Gate, Heights, make_gate
from .regions import Criteria, Selection, select_regions
from .settings import ClosingSettings, RegionSettings, WallSettings
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
    max_fill: float = 0.4
    min_elongation: float = 3.0
    closing: Optional[float] = None
    min_height: float = 0.4
    threshold_steps: int = 10
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


@dataclass(frozen=True)
class WallImage:
    """Wall pixels.

    Attributes
    ----------
    walls : ndarray of bool, shape (rows, columns)
    votes : ndarray of uint8, shape (rows, columns)
        Number of thresholds at which the pixel belonged to a wall region, before closing.
    gated : ndarray of float, shape (rows, columns)
        The density that the thresholds were applied to; 0 where no wall may stand.
    thresholds : Thresholds
    gap : float
        Widest gap that was closed, metres.
    criteria : Criteria
    parameters : WallParameters
        As they were given.
    warnings : tuple of str
    settings : WallSettings
    """

    walls: np.ndarray
    votes: np.ndarray
    gated: np.ndarray
    thresholds: Thresholds
    gap: float
    criteria: Criteria
    parameters: WallParameters
    warnings: tuple[str, ...]
    settings: WallSettings = field(default_factory=WallSettings)


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
    criteria = parameters.criteria(pixel_size)
    votes = np.zeros(gated.shape, np.uint8)
    regions = too_small = wrong_shape = 0
    steps = select_by_threshold(gated, thresholds, pixel_size, criteria, gate.column, settings.regions)
    for i, value in enumerate(thresholds.values):
        progress.update(i / len(thresholds.values), f"Threshold {value:.2f}")
        selection = next(steps)
        votes += selection.kept
        regions += selection.regions
        too_small += selection.too_small
        wrong_shape += selection.wrong_shape
    if not votes.any():
        removed = (regions, too_small, wrong_shape)
        raise NothingFoundError(_what_removed(gate, parameters, criteria, thresholds, removed))
    gap = parameters.gap(gate, settings.closing)
    walls = close_gaps(votes > 0, pixel_size, gap, gate.open_ground)
    walls = bridge_corners(walls, gated)
    found = walls, votes, gated, thresholds, gap, criteria
    return WallImage(*found, parameters, gate.warnings, settings)


def select_by_threshold(
    gated: np.ndarray,
    thresholds: Thresholds,
    pixel_size: float,
    criteria: Criteria,
    column: Optional[np.ndarray],
    settings: RegionSettings = RegionSettings(),
) -> Iterator[Selection]:
    """Yield what the criteria keep at each threshold, the lowest first.

    Parameters
    ----------
    gated : ndarray of float, shape (rows, columns)
        Density of the pixels that may be wall, 0 elsewhere.
    thresholds : Thresholds
    pixel_size : float
        Metres.
    criteria : Criteria
    column : ndarray of bool, shape (rows, columns), optional
        Pixels filled to a column's height.
    settings : RegionSettings
    """
    for value in thresholds.values:
        binary = (gated > 0) & (gated >= value * thresholds.deviation)
        yield select_regions(binary, pixel_size, criteria, column, settings)


def _what_removed(
    gate: Gate,
    parameters: WallParameters,
    criteria: Criteria,
    thresholds: Thresholds,
    removed: tuple[int, int, int],
) -> str:
    regions, small, shape = removed
    if not regions and gate.tall.any():
        return (
            f"No wall found: no pixel of the {int(gate.tall.sum())} that MIN_HEIGHT "
            f"{parameters.min_height:g} m left is as dense as THRESHOLD {thresholds.values[0]:.3g} standard "
            "deviations; lower it, or leave it empty."
        )
    return (
        f"No wall found: MIN_HEIGHT {parameters.min_height:g} m left {int(gate.tall.sum())} of "
        f"{gate.tall.size} pixels; over {len(thresholds.values)} thresholds from "
        f"{thresholds.values[0]:.3g} to {thresholds.values[-1]:.3g} standard deviations they formed "
        f"{regions} regions, of which MIN_AREA {criteria.min_area:g} m2 removed {small}, and "
        f"MAX_FILL {criteria.max_fill:g} with MIN_ELONGATION {criteria.min_elongation:g} removed "
        f"{shape}; relax the one that removed most."
    )
