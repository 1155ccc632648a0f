"""Thresholds of the density image, derived from the image where the user gives none.

A wall stands out from the horizontal surfaces beside it. Their density is known from the image itself: it is
the usual density of the pixels in which nothing rises above the ground.
"""

from dataclasses import dataclass
from enum import Enum
from typing import Optional

import numpy as np
from skimage.filters import threshold_otsu

from ...errors import InputError


class Rule(Enum):
    """How the lowest threshold is derived, and from what."""

    QUARTILE = "the lower quartile of the density, as nothing is known to be flat"
    SURFACES = "the usual density of the pixels that show horizontal surfaces only"
    OTSU = "Otsu's threshold of the logarithm of the density"
    PARTED = "the density that best separates horizontal surfaces from the rest"


@dataclass(frozen=True)
class Thresholds:
    """The iterated thresholds.

    Attributes
    ----------
    values : tuple of float
        Increasing, in standard deviations of the density image.
    deviation : float
        That standard deviation, in points per pixel, over the pixels that hold density.
    rule : Rule or None
        How the lowest was derived; None if it was given.
    """

    values: tuple[float, ...]
    deviation: float
    rule: Optional[Rule]


def choose_thresholds(
    density: np.ndarray,
    flat: np.ndarray,
    tall: np.ndarray,
    lowest: Optional[float],
    highest: Optional[float],
    steps: int,
) -> Thresholds:
    """Space thresholds evenly from the lowest to the highest.

    Parameters
    ----------
    density : ndarray of float, shape (rows, columns)
        Density image; nan where no point contributes.
    flat : ndarray of bool, shape (rows, columns)
        Pixels known to show horizontal surfaces only.
    tall : ndarray of bool, shape (rows, columns)
        Pixels that may be wall. Where flat pixels are among them, density alone has to separate them.
    lowest, highest : float or None
        In standard deviations of the density image. None derives the lowest as `surface_level` does,
        the highest as the median density of the tall pixels above the lowest.
    steps : int
        Number of thresholds.

    Raises
    ------
    InputError
        If `highest` is given and below a given `lowest`.
    """
    if lowest is not None and highest is not None and highest < lowest:
        raise InputError(
            f"THRESHOLD_MAX {highest:g} is below THRESHOLD {lowest:g}; raise it, or leave it empty."
        )
    held = np.isfinite(density)
    deviation = float(np.std(density[held])) or float(density[held].max())
    rule = surface_rule(flat[held], tall[held]) if lowest is None else None
    if lowest is None:
        lowest = surface_level(density[held], flat[held], tall[held]) / deviation
    if highest is None:
        above = density[held & tall & (density > lowest * deviation)]
        highest = float(np.median(above)) / deviation if len(above) else lowest
    values = np.linspace(lowest, max(highest, lowest), steps)
    return Thresholds(tuple(values.tolist()), deviation, rule)


def surface_rule(flat: np.ndarray, tall: np.ndarray) -> Rule:
    """Return the rule for the pixels that hold density; the arrays are those of `choose_thresholds`."""
    if not flat.any():
        return Rule.QUARTILE
    if not (flat & tall).any():
        return Rule.SURFACES
    return Rule.OTSU if flat.all() else Rule.PARTED


def surface_level(density: np.ndarray, flat: np.ndarray, tall: np.ndarray) -> float:
    """Return the density above which a pixel shows more than horizontal surfaces.

    If flat pixels are kept out of the tall ones by their heights, it is their usual density. If
    they are not, it is the density that best separates the flat pixels from the others. If nothing is
    known to be flat, or all may be, it is the lower quartile, or Otsu's threshold of the logarithm.

    Parameters
    ----------
    density : ndarray of float, shape (n,)
        Points per pixel, of the pixels that hold density.
    flat, tall : ndarray of bool, shape (n,)
        As in `choose_thresholds`.
    """
    rule = surface_rule(flat, tall)
    if rule is Rule.QUARTILE:
        return float(np.percentile(density, 25))
    if rule is Rule.SURFACES:
        return float(np.median(density[flat]))
    if rule is Rule.OTSU:
        return float(np.exp(threshold_otsu(np.log(density[density > 0]))))
    levels = np.percentile(density, np.arange(1, 100))
    passed = 1 - np.searchsorted(np.sort(density[flat]), levels) / flat.sum()
    found = 1 - np.searchsorted(np.sort(density[~flat]), levels) / (~flat).sum()
    return float(levels[np.argmax(found - passed)])
