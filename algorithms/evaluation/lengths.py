"""Compare the lengths of a schedule with lengths measured by hand, as table 1 of the facade paper."""

import math
from dataclasses import dataclass

import numpy as np

from ..errors import NothingFoundError
from .length_lists import LengthList
from .settings import LengthSettings

UNITS = {"millimetres": 1000.0, "centimetres": 100.0, "decimetres": 10.0, "feet": 3.28084, "inches": 39.3701}
"""How many there are in a metre."""


@dataclass(frozen=True)
class Length:
    """A length, measured twice.

    Attributes
    ----------
    id : str
        Of the detail.
    dimension : str
        width, height or sill.
    automatic, manual : float
        In metres.
    std : float
        Standard deviation of the automatic one (m); nan if it is not known.
    """

    id: str
    dimension: str
    automatic: float
    manual: float
    std: float

    @property
    def difference(self) -> float:
        """Automatic minus manual (m)."""
        return self.automatic - self.manual


@dataclass(frozen=True)
class LengthComparison:
    """All lengths that were measured twice.

    Attributes
    ----------
    lengths : tuple of Length
        In the order of the reference.
    warnings : tuple of str
        Sentences about lengths of the reference that the schedule lacks.
    """

    lengths: tuple[Length, ...]
    warnings: tuple[str, ...]

    @property
    def differences(self) -> np.ndarray:
        """Automatic minus manual, shape (n,) (m)."""
        return np.array([length.difference for length in self.lengths])

    @property
    def mean(self) -> float:
        """Mean of the differences (m)."""
        return float(self.differences.mean())

    @property
    def std(self) -> float:
        """Standard deviation of the differences (m); nan of a single one."""
        return float(self.differences.std(ddof=1)) if len(self.lengths) > 1 else math.nan

    @property
    def largest(self) -> float:
        """The largest absolute difference (m)."""
        return float(np.abs(self.differences).max())


def compare_lengths(
    schedule: LengthList, reference: LengthList, settings: LengthSettings = LengthSettings()
) -> LengthComparison:
    """Pair the lengths of a reference with those of a schedule by id and dimension.

    Raises
    ------
    NothingFoundError
        If the two have no length in common.
    """
    known = {(item.id, item.dimension): item for item in schedule.lengths}
    lengths, unknown = [], []
    for item in reference.lengths:
        found = known.get((item.id, item.dimension))
        if found:
            lengths.append(Length(item.id, item.dimension, found.length, item.length, found.std))
        else:
            unknown.append(f"{item.dimension} of {item.id}")
    if not lengths:
        raise NothingFoundError(
            f"{schedule.source} has no length of {reference.source}; use the ids of the schedule "
            "in both, and its column facade if it has one."
        )
    warnings = (f"{schedule.source} has no {', '.join(unknown)}.",) if unknown else ()
    doubt = _doubtful_unit(schedule.source, reference.source, lengths, settings)
    return LengthComparison(tuple(lengths), (*schedule.warnings, *reference.warnings, *doubt, *warnings))


def _doubtful_unit(
    schedule: str, reference: str, lengths: list[Length], settings: LengthSettings
) -> tuple[str, ...]:
    """Return a sentence if one list seems to be in another unit than metres."""
    ratios = [item.manual / item.automatic for item in lengths if item.automatic and item.manual]
    ratio = abs(float(np.median(ratios))) if ratios else 1.0
    for unit, in_metre in UNITS.items():
        for source, other, times in ((reference, schedule, ratio), (schedule, reference, 1 / ratio)):
            if abs(times / in_metre - 1) < settings.same_unit:
                return (
                    f"The lengths of {source} are about {times:.0f} times those of {other}, as if they were "
                    f"in {unit}; write metres, or the unit in the header, as 'width [mm]'.",
                )
    return ()
