"""Where a range image may show the centre of a black and white target."""

from dataclasses import dataclass
from itertools import chain

import numpy as np
from scipy.spatial import cKDTree

from ...kernels import kernel
from ...parallel import in_order
from ..range_image.range_image import RangeImage
from .settings import CandidateSettings

DIRECTIONS = 16
"""Around a pixel, in which intensities are sampled."""

RINGS = np.array([0.45, 0.7, 1.0])
"""Radii at which they are sampled, in units of the largest."""


@dataclass(frozen=True)
class Candidate:
    """A pixel around which the intensities change as around the centre of a target.

    Attributes
    ----------
    xyz : ndarray, shape (3,)
        Relative to the scanner.
    radius : float
        Of the circle that was looked at, metres.
    response : float
        Part of the variance on the circle that two opposite bright and two dark sectors explain.
    """

    xyz: np.ndarray
    radius: float
    response: float


def checkerboard_candidates(image: RangeImage, settings: CandidateSettings) -> list[Candidate]:
    """Return the best pixel of every neighbourhood, best ones first.

    At each pixel and for each radius, the intensities are sampled around it. Around the centre of a target
    their second harmonic is large, and larger than all that differs between opposite directions (a
    circular corner detector after Bennett and Lasenby 2014, ChESS).
    """

    def of_radius(radius: float) -> list[Candidate]:
        limits = [settings.least_pixels, settings.least_contrast, settings.least_response, settings.most_odd]
        geometry = np.array([image.step, image.step_of_azimuth, image.floor])
        grids = image.ranges, image.brightness
        response = _responses(*grids, geometry, image.period, radius, RINGS, np.array(limits))
        return _peaks(image, response, radius)

    found = list(chain.from_iterable(in_order(of_radius, settings.radii_m)))
    found.sort(key=lambda item: -item.response)
    return found


@kernel
def _responses(
    ranges: np.ndarray,
    brightness: np.ndarray,
    geometry: np.ndarray,
    period: int,
    radius: float,
    rings: np.ndarray,
    limits: np.ndarray,
) -> np.ndarray:
    """Return the response of each pixel, 0 where a limit is missed."""
    step, across, floor = geometry
    least_pixels, least_contrast, least_response, most_odd = limits
    rows, columns = ranges.shape
    result = np.zeros((rows, columns), np.float32)
    count = DIRECTIONS
    cosines = np.cos(2 * np.pi * np.arange(count) / count)
    sines = np.sin(2 * np.pi * np.arange(count) / count)
    values = np.zeros(count)
    for row in range(rows):
        level = max(np.cos(floor + (row + 0.5) * step), 0.05)
        for column in range(columns):
            distance = ranges[row, column]
            if distance <= 0:
                continue
            tall = radius / (distance * step)
            wide = radius / (distance * across * level)
            if tall < least_pixels or row < tall or row >= rows - tall or wide > period / 8:
                continue
            # On large circles neighbouring pixels answer alike.
            stride = max(1, int(tall / 5))
            if stride > 1 and (row % stride or column % stride):
                continue
            complete = True
            total = 0.0
            for number in range(count):
                # Every second one first: on an even surface these say enough.
                direction = 2 * number % count + 2 * number // count
                amount, samples = 0.0, 0
                for ring in rings:
                    r = int(np.floor(row + ring * tall * sines[direction] + 0.5))
                    c = int(np.floor(column + ring * wide * cosines[direction] + 0.5)) % period
                    if 0 <= r < rows and c < columns and ranges[r, c] > 0:
                        amount += brightness[r, c]
                        samples += 1
                if samples == 0:
                    complete = False
                    break
                values[direction] = amount / samples
                total += values[direction]
                if 2 * (number + 1) == count:
                    upright = values[0] + values[8] - values[4] - values[12]
                    aslant = values[2] + values[10] - values[6] - values[14]
                    if max(abs(upright), abs(aslant)) < least_contrast * total / 8:
                        complete = False
                        break
            if not complete:
                continue
            mean = total / count
            real, imaginary, variance, odd = 0.0, 0.0, 0.0, 0.0
            for direction in range(count):
                away = values[direction] - mean
                variance += away * away
                real += away * cosines[2 * direction % count]
                imaginary += away * sines[2 * direction % count]
            for direction in range(count // 2):
                difference = values[direction] - values[direction + count // 2]
                odd += difference * difference / 2
            power = 2 * (real * real + imaginary * imaginary) / count
            if variance <= 0 or power < least_response * variance or odd > most_odd * variance:
                continue
            if np.sqrt(2 * power / count) < least_contrast * mean:
                continue
            result[row, column] = power / variance
    return result


def best_of_neighbours(places: np.ndarray, radius: float) -> list[int]:
    """Return the rows that no earlier row returned lies within `radius` of; earlier rows are better.

    Parameters
    ----------
    places : ndarray, shape (n, 3)
    radius : float
    """
    tree = cKDTree(places) if len(places) else None
    free = np.ones(len(places), bool)
    chosen = []
    for row in range(len(places)):
        if tree is not None and free[row]:
            chosen.append(row)
            free[tree.query_ball_point(places[row], radius)] = False
    return chosen


def _peaks(image: RangeImage, response: np.ndarray, radius: float) -> list[Candidate]:
    """Return the candidates of one radius: pixels with the best response within half of it."""
    rows, columns = np.nonzero(response)
    values = response[rows, columns]
    order = np.argsort(-values, kind="stable")
    rows, columns, values = rows[order], columns[order], values[order]
    distance = image.ranges[rows, columns].astype(np.float64)
    azimuth = image.cut + (columns + 0.5) * image.step_of_azimuth
    elevation = image.floor + (rows + 0.5) * image.step
    level = distance * np.cos(elevation)
    places = np.column_stack([level * np.cos(azimuth), level * np.sin(azimuth), distance * np.sin(elevation)])
    return [Candidate(places[n], radius, float(values[n])) for n in best_of_neighbours(places, radius / 2)]
