"""Where a range image may show a sphere."""

from dataclasses import dataclass
from itertools import chain

import numpy as np

from ...kernels import kernel
from ...parallel import in_order
from ..range_image.range_image import RangeImage
from .settings import CandidateSettings

DIRECTIONS = 16
"""Around a pixel, in which ranges are sampled."""


@dataclass(frozen=True)
class Candidate:
    """A pixel around which the ranges grow as around the nearest point of a sphere.

    Attributes
    ----------
    xyz : ndarray, shape (3,)
        The nearest point, relative to the scanner.
    radius : float
        Metres.
    misfit : float
        Root mean square of what the depths differ from those of a sphere, in units of the radius.
    """

    xyz: np.ndarray
    radius: float
    misfit: float


def sphere_candidates(
    image: RangeImage, diameters: tuple[float, ...], settings: CandidateSettings
) -> list[Candidate]:
    """Return the pixels whose surroundings are deep as those of a sphere, best ones first.

    Parameters
    ----------
    image : RangeImage
    diameters : tuple of float
        Metres.
    settings : CandidateSettings
    """

    def of_diameter(diameter: float) -> list[Candidate]:
        tolerance = settings.tolerance * diameter / 2 + settings.noise_m
        limits = [settings.least_pixels, tolerance, settings.least_agreement, settings.least_free]
        geometry = np.array([image.step, image.step_of_azimuth, image.floor])
        rings = np.array(settings.rings)
        misfits = _misfits(image.ranges, geometry, image.period, diameter / 2, rings, np.array(limits))
        return [
            Candidate(
                image.direction(row, column) * float(image.ranges[row, column]),
                diameter / 2,
                float(misfits[row, column]) / diameter * 2,
            )
            for row, column in zip(*np.nonzero(misfits))
        ]

    found = list(chain.from_iterable(in_order(of_diameter, diameters)))
    found.sort(key=lambda item: item.misfit)
    return found


@kernel
def _misfits(
    ranges: np.ndarray,
    geometry: np.ndarray,
    period: int,
    radius: float,
    rings: np.ndarray,
    limits: np.ndarray,
) -> np.ndarray:
    """Return the misfit of each pixel in metres, 0 where a limit is missed."""
    step, across, floor = geometry
    least_pixels, tolerance, least_agreement, least_free = limits
    rows, columns = ranges.shape
    result = np.zeros((rows, columns), np.float32)
    cosines = np.cos(2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)
    sines = np.sin(2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)
    # Opposite directions one after the other: on a plane the first pair already fails.
    turns = np.arange(DIRECTIONS) // 2 * 5 % (DIRECTIONS // 2) + np.arange(DIRECTIONS) % 2 * (DIRECTIONS // 2)
    depths = radius * (1 - np.sqrt(1 - rings[:2] ** 2))
    most_wrong = DIRECTIONS - int(np.ceil(least_agreement * DIRECTIONS))
    for row in range(rows):
        level = max(np.cos(floor + (row + 0.5) * step), 0.05)
        for column in range(columns):
            distance = ranges[row, column]
            if distance <= 0:
                continue
            tall = radius / (distance * step)
            wide = radius / (distance * across * level)
            if tall < least_pixels or wide > period / 8:
                continue
            stride = max(1, int(tall / 6))
            if stride > 1 and (row % stride or column % stride):
                continue
            wrong, free, used, squares = 0, 0, 0, 0.0
            for turn in turns:
                good = True
                for ring in range(3):
                    r = int(np.floor(row + rings[ring] * tall * sines[turn] + 0.5))
                    c = int(np.floor(column + rings[ring] * wide * cosines[turn] + 0.5)) % period
                    known = 0 <= r < rows and c < columns and ranges[r, c] > 0
                    if ring == 2:
                        free += not known or abs(ranges[r, c] - distance - radius) > radius
                    elif not known:
                        good = False
                    else:
                        away = ranges[r, c] - distance - depths[ring]
                        if abs(away) > tolerance:
                            good = False
                        else:
                            used += 1
                            squares += away * away
                wrong += not good
                if wrong > most_wrong:
                    break
            if wrong <= most_wrong and free >= least_free * DIRECTIONS:
                result[row, column] = np.sqrt(squares / used) + 1e-6
    return result
