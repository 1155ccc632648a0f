"""How far the pattern of a target reaches."""

from dataclasses import dataclass

import numpy as np

from .pattern import Pattern
from .settings import ExtentSettings


@dataclass(frozen=True)
class Extent:
    """The reach of the four quadrants.

    Attributes
    ----------
    reach : ndarray, shape (4,)
        How far the points of each quadrant have its colour, metres from the centre; infinite if farther than
        was looked. Quadrants 0 and 2 are white.
    ring : float
        How exactly a width is known, metres.
    """

    reach: np.ndarray
    ring: float

    @property
    def size(self) -> float:
        """Width of the pattern, metres.

        A colour that is like the background does not end, so that the colour that ends first counts.
        """
        colours = np.stack([self.reach[0::2], self.reach[1::2]])
        return 2.0 * float(np.min(np.median(colours, axis=1)))

    @property
    def evenness(self) -> float:
        """Ratio of the two quadrants of the colour that ends, the shorter to the longer."""
        colours = np.stack([self.reach[0::2], self.reach[1::2]])
        ending = colours[int(np.argmin(np.median(colours, axis=1)))]
        return float(ending.min() / ending.max()) if np.isfinite(ending.max()) else 0.0


def extent_of(
    pattern: Pattern, places: np.ndarray, intensities: np.ndarray, spacing: float, settings: ExtentSettings
) -> Extent:
    """Return how far each quadrant reaches.

    Beside its two edges each quadrant is divided into sectors, and these into rings: there squares and discs
    reach as far. A sector ends with the first ring whose
    intensity is nearer to the other colour or far from both, or before two rings without points.

    Parameters
    ----------
    pattern : Pattern
    places : ndarray, shape (n, 2)
        Points on the plane, metres.
    intensities : ndarray, shape (n,)
    spacing : float
        Of the points on the plane, metres.
    settings : ExtentSettings
    """
    away = places - pattern.centre
    distance = np.hypot(*away.T)
    quadrant, within = _quadrants(pattern, away)
    tone = (intensities - pattern.middle) / abs(pattern.half)
    wanted = np.where(quadrant % 2 == 0, 1.0, -1.0)
    agrees = np.abs(tone - wanted) < settings.tone
    width = max(settings.ring_m, 1.5 * spacing)
    rings = int(settings.largest_m / 2 / width) + 1
    start = int(np.ceil(2.0 * pattern.blur / width)) + 1
    count = int(np.clip(0.04 / spacing / settings.sector_points, 1, settings.sectors))
    flank = settings.margin + (settings.flank - settings.margin) * np.arange(count + 1) / count
    sectors = [*zip(flank, flank[1:]), *zip(1 - flank[1:], 1 - flank)]
    reach = np.zeros(4)
    for number in range(4):
        ends = []
        for low, high in sectors:
            here = (quadrant == number) & (within >= low) & (within < high)
            ends.append(_end(distance[here], agrees[here], width, start, rings, settings.share))
        reach[number] = np.quantile(ends, 0.5, method="lower")
    return Extent(reach, width)


@dataclass(frozen=True)
class Quadrants:
    """What was seen in the four quadrants.

    Attributes
    ----------
    counts : ndarray of int, shape (4,)
        Numbers of points.
    agreement : ndarray, shape (4,)
        Share of the points off the edges that are nearer to the colour of their quadrant.
    unevenness : float
        Largest difference of tone between quadrants of one colour, in units of half the contrast.
    """

    counts: np.ndarray
    agreement: np.ndarray
    unevenness: float


def quadrants(pattern: Pattern, places: np.ndarray, intensities: np.ndarray) -> Quadrants:
    """Return what was seen in the four quadrants; points on the blurred edges have no colour."""
    quadrant, _ = _quadrants(pattern, places - pattern.centre)
    counts = np.bincount(quadrant, minlength=4)
    clear = np.min(np.abs(pattern.distances(places)), axis=1) > pattern.blur
    wanted = np.where(quadrant % 2 == 0, 1.0, -1.0)
    tone = (intensities - pattern.middle) / abs(pattern.half)
    of_colour = np.maximum(np.bincount(quadrant[clear], minlength=4), 1)
    right = np.bincount(quadrant[clear], (tone * wanted)[clear] > 0, minlength=4)
    tones = np.bincount(quadrant[clear], tone[clear], minlength=4) / of_colour
    unevenness = float(max(abs(tones[0] - tones[2]), abs(tones[1] - tones[3])))
    return Quadrants(counts, right / of_colour, unevenness)


def tiled(
    pattern: Pattern, reach: float, places: np.ndarray, intensities: np.ndarray, settings: ExtentSettings
) -> float:
    """Return the correlation of the intensities beside a pattern with its continuation by tiles.

    Parameters
    ----------
    pattern : Pattern
    reach : float
        Of the quadrants, metres. The tiles may be larger, where one of them is cut.
    places : ndarray, shape (n, 2)
    intensities : ndarray, shape (n,)
    settings : ExtentSettings
    """
    return max(
        _continued(pattern, reach * scale, places, intensities, settings) for scale in settings.tile_scales
    )


def _continued(
    pattern: Pattern, cell: float, places: np.ndarray, intensities: np.ndarray, settings: ExtentSettings
) -> float:
    steps = pattern.distances(places) / cell
    beside = np.max(np.abs(steps), axis=1)
    ring = (beside > 1.1) & (beside < 1.8)
    tiles = np.where(np.sum(np.floor(steps[ring]), axis=1) % 2 == 0, 1.0, -1.0) * np.sign(pattern.half)
    tone = np.clip((intensities[ring] - pattern.middle) / abs(pattern.half), -1.5, 1.5)
    # A wall of one tone has only noise, whose correlation means nothing.
    if np.count_nonzero(ring) < settings.fewest_beside or np.ptp(tiles) == 0 or np.std(tone) < 0.1:
        return 0.0
    return float(np.corrcoef(tiles, tone)[0, 1])


def _quadrants(pattern: Pattern, away: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the quadrant of each place, white ones even, and where it is within it, from 0 to 1."""
    first, second = pattern.angles
    gap = second - first
    azimuth = np.mod(np.arctan2(away[:, 1], away[:, 0]) - first, 2 * np.pi)
    ends = np.array([0.0, gap, np.pi, np.pi + gap, 2 * np.pi])
    quadrant = np.clip(np.searchsorted(ends, azimuth, side="right") - 1, 0, 3)
    within = (azimuth - ends[quadrant]) / np.diff(ends)[quadrant]
    # Between the edges the distances from them have unequal signs, where a positive half is black.
    return (quadrant + (pattern.half > 0)) % 4, within


def _end(
    distance: np.ndarray, agrees: np.ndarray, width: float, start: int, rings: int, share: float
) -> float:
    """Return the inner radius of the first ring that does not agree, the blurred ones aside; or infinity."""
    ring = np.minimum((distance / width).astype(np.int64), rings)
    counts = np.bincount(ring, minlength=rings + 1)[:rings]
    good = np.bincount(ring, agrees, minlength=rings + 1)[:rings]
    bad = (good <= share * counts) & (counts > 0)
    # Single rings may have no point; two in a row are beyond the surface.
    empty = counts == 0
    bad[:-1] |= empty[:-1] & empty[1:]
    ends = np.flatnonzero(bad[start:])
    return float((ends[0] + start) * width) if len(ends) else np.inf
