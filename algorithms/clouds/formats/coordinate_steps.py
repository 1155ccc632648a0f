"""How finely a file stores its coordinates, and whether they can be metres.

Single precision far from the origin loses millimetres. Whole numbers are seldom metres.
"""

from pathlib import Path

import numpy as np

from ..settings import PrecisionSettings


def step_warning(
    path: Path,
    xyz: np.ndarray,
    metres: tuple[float, float, float] = (1.0, 1.0, 1.0),
    settings: PrecisionSettings = PrecisionSettings(),
) -> tuple[str, ...]:
    """Return a sentence on the steps of coordinates that were stored in single precision somewhere.

    Parameters
    ----------
    path : Path
    xyz : ndarray of float64, shape (n, 3)
        A sample, in the units of the file.
    metres : tuple of 3 float
        How many metres the units are.
    settings : PrecisionSettings
    """
    steps = [_step(column, settings) * unit for column, unit in zip(xyz.T, metres)]
    coarse = _coarse(steps, settings.coarsest_step_m, ".2g")
    if not coarse:
        return ()
    return (
        f"The coordinates of {path} have single precision, so they lie in steps of {coarse}; "
        "export it with double precision, or with coordinates near 0.",
    )


def unit_warning(
    path: Path,
    xyz: np.ndarray,
    unit_stated: bool = False,
    settings: PrecisionSettings = PrecisionSettings(),
) -> tuple[str, ...]:
    """Return a sentence if coordinates can be millimetres, unless a unit is stated; see `step_warning`."""
    known = xyz[np.isfinite(xyz).all(axis=1)]
    if unit_stated or len(known) < settings.fewest_whole:
        return ()
    if np.any(known % 1) or np.ptp(known, axis=0).max() < settings.widest_whole_m:
        return ()
    return (
        f"The coordinates of {path} are whole numbers, which were read as metres; if they are "
        "millimetres, convert them, or write the unit into the names of the columns.",
    )


def rounding_warning(
    path: Path,
    xyz: np.ndarray,
    metres: tuple[float, float, float] = (1.0, 1.0, 1.0),
    settings: PrecisionSettings = PrecisionSettings(),
) -> tuple[str, ...]:
    """Return a sentence on coordinates with too few decimals, as in spreadsheets; see `step_warning`."""
    known = xyz[np.isfinite(xyz).all(axis=1)]
    if len(known) < settings.fewest_rounded:
        return ()
    steps = [
        0.0 if _are_slices(column * unit, settings) else _decimal_step(column) * unit
        for column, unit in zip(known.T, metres)
    ]
    coarse = _coarse(steps, settings.coarsest_scale_m, "g")
    if not coarse:
        return ()
    return (
        f"The coordinates of {path} are multiples of {coarse}; if they were rounded, and do not "
        "form a grid, export it with three decimals or more.",
    )


def _coarse(steps: list[float], coarsest: float, form: str) -> str:
    """Return the steps (m) that are too coarse, with their axes, for a message."""
    return ", ".join(f"{step:{form}} m in {axis}" for axis, step in zip("xyz", steps) if step >= coarsest)


def _are_slices(values: np.ndarray, settings: PrecisionSettings) -> bool:
    """Whether coordinates (m) are few near the origin; few national ones are rounded, as in 5.8123E+06."""
    few = len(np.unique(values)) < settings.fewest_steps
    return few and bool(np.abs(values).max() < settings.largest_local_m)


def _decimal_step(values: np.ndarray) -> float:
    """Return the largest power of ten of which all `values` are multiples; 0 if they are equal, or finer."""
    if np.ptp(values) == 0:
        return 0.0
    # Sums and products of numbers of the file are as exact as double precision, but for some last bits.
    exact = 16 * np.spacing(np.abs(values).max())
    for step in 10.0 ** np.arange(6, -4, -1):
        if np.all(np.abs(values - step * np.rint(values / step)) < exact):
            return float(step)
    return 0.0


def _zero_warning(
    path: Path, xyz: np.ndarray, settings: PrecisionSettings = PrecisionSettings()
) -> tuple[str, ...]:
    """Return a sentence on points at 0, 0, 0, where a scanner stands but measures nothing."""
    lost = np.all(xyz == 0, axis=1)
    if lost.sum() < settings.fewest_points or lost.mean() < settings.least_lost_share or lost.all():
        return ()
    return (
        f"{lost.mean():.1%} of the points of {path} are at 0, 0, 0, where programs put what was not "
        "measured; remove them.",
    )


def height_warning(
    path: Path, z: np.ndarray, settings: PrecisionSettings = PrecisionSettings()
) -> tuple[str, ...]:
    """Return a sentence if a cloud is higher than a site; `z` is a sample, metres, shape (n,)."""
    low, high = np.percentile(z[np.isfinite(z)], [1, 99]) if np.isfinite(z).any() else (0, 0)
    if high - low <= settings.highest_m:
        return ()
    return (
        f"The points of {path} reach over {high - low:.0f} m in height; if their coordinates are "
        "millimetres, convert them to metres.",
    )


def coordinate_warnings(
    path: Path,
    xyz: np.ndarray,
    metres: tuple[float, float, float] = (1.0, 1.0, 1.0),
    unit_stated: bool = False,
) -> tuple[str, ...]:
    """Return all sentences on the coordinates of a cloud; see `step_warning` and `unit_warning`."""
    units = unit_warning(path, xyz, unit_stated) or height_warning(path, xyz[:, 2] * metres[2])
    # Of other units, other steps would be too coarse.
    steps = step_warning(path, xyz, metres) or (() if units else rounding_warning(path, xyz, metres))
    return (*steps, *units, *_zero_warning(path, xyz))


def _step(values: np.ndarray, settings: PrecisionSettings) -> float:
    """Return the step of single precision at most of `values`, 0 if they are finer."""
    values = values[np.isfinite(values)]
    if len(values) < settings.fewest_points:
        return 0.0
    with np.errstate(over="ignore"):
        nearest = values.astype(np.float32)
        steps = np.spacing(np.abs(nearest)).astype(np.float64)
    # Other numbers are within an eighth of a step of single precision once in four.
    single = np.abs(values - nearest) <= steps / 8
    # Half of the numbers of single precision are odd multiples of their step, and none of rounder numbers.
    odd = np.mod(nearest / steps, 2) == 1
    if single.mean() < settings.single_share or odd.mean() < settings.odd_share:
        return 0.0
    return float(np.median(steps))
