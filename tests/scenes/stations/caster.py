"""A laser scanner: every beam is a bundle of rays that meet panels, balls and rods."""

from dataclasses import dataclass

import numpy as np
from numba import njit

PLAIN, CROSSED, TILED, PRINTED, BARRED = range(5)
"""What is on a panel: one tone, two edges that cross, tiles, a poster, a window with glazing bars."""

RAYS = 13
"""Of a beam; each stands for as much light."""

GOLDEN_ANGLE, GOLDEN_PART = np.pi * (3 - 5**0.5), (5**0.5 - 1) / 2
"""By which the rays of a beam are spread around it and across it."""


@dataclass(frozen=True)
class Panel:
    """A plane rectangle or disc with a picture.

    Attributes
    ----------
    centre : ndarray, shape (3,)
    axes : ndarray, shape (2, 3)
        Directions of its width and height, of length 1, at right angles.
    half : tuple of 2 float
        Half of width and height; of a disc, twice the radius.
    picture : int
    tones : tuple of 2 float
        Reflectance of dark and bright.
    cell : float
        Side of the tiles, grain of a poster, or width of the bars, metres.
    turn : float
        Of the picture on the panel, radians.
    disc : bool
    """

    centre: np.ndarray
    axes: np.ndarray
    half: tuple[float, float]
    picture: int = PLAIN
    tones: tuple[float, float] = (0.5, 0.5)
    cell: float = 0.1
    turn: float = 0.0
    disc: bool = False


@dataclass(frozen=True)
class Ball:
    """A sphere."""

    centre: np.ndarray
    radius: float
    tone: float = 0.8


@dataclass(frozen=True)
class Rod:
    """An upright cylinder from `centre` downwards."""

    centre: np.ndarray
    radius: float
    length: float
    tone: float = 0.3


@dataclass(frozen=True)
class Scanner:
    """What a scanner measures.

    Attributes
    ----------
    step : float
        Angle between neighbouring beams, radians.
    noise : float
        Standard deviation of a range on white, metres; on black it is three times as large.
    crosstalk : float
        How much farther than white black is measured, metres.
    beam : tuple of 2 float
        Radius of the beam at the scanner, metres, and its growth per metre.
    jitter : float
        Standard deviation of a direction, radians.
    common : tuple of 2 float
        Standard deviations of what all points of a window have in common: range, metres, and direction,
        radians. However many points there are, they do not average it out.
    grain : float
        Standard deviation of an intensity, as a part of it.
    """

    step: float = 0.0006
    noise: float = 0.0015
    crosstalk: float = 0.001
    beam: tuple[float, float] = (0.0017, 0.00015)
    jitter: float = 0.00001
    common: tuple[float, float] = (0.00005, 0.000007)
    grain: float = 0.03


@dataclass(frozen=True)
class Window:
    """A part of what a scanner sees, with the things in it.

    Attributes
    ----------
    azimuth, elevation : float
        Of its middle, radians.
    half : tuple of 2 float
        Half of its width and height, radians.
    things : tuple
    """

    azimuth: float
    elevation: float
    half: tuple[float, float]
    things: tuple


def cast(scanner: Scanner, window: Window, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return the points of a window relative to the scanner, shape (n, 3), and their intensities, uint16."""
    azimuth = _lattice(window.azimuth, window.half[0], scanner.step)
    elevation = _lattice(window.elevation, window.half[1], scanner.step)
    grid = np.stack(np.meshgrid(azimuth, elevation, indexing="ij"), axis=-1).reshape(-1, 2)
    true = grid + rng.normal(0.0, scanner.jitter, grid.shape) / [np.cos(window.elevation), 1.0]
    true += rng.normal(0.0, scanner.common[1], 2) / [np.cos(window.elevation), 1.0]
    ranges, power = _cast(
        _rays(true), *_arrays(window.things), np.array(scanner.beam), rng.uniform(0, 1, (len(grid), 2))
    )
    met = ranges > 0
    ranges, power, rays = ranges[met], power[met], _rays(grid[met])
    ranges += rng.normal(0.0, scanner.common[0])
    tone = np.clip(power / 0.5, 0.0, 1.0)
    ranges = (
        ranges + scanner.crosstalk * (1 - tone) + rng.normal(0, scanner.noise, len(ranges)) * (3 - 2 * tone)
    )
    shade = 30000 * power * (1 + rng.normal(0, scanner.grain, len(power))) + rng.normal(0, 60, len(power))
    return rays * ranges[:, None], np.clip(shade + 300, 0, 65535).astype(np.uint16)


def _lattice(middle: float, half: float, step: float) -> np.ndarray:
    """Return the angles of the scanner's own lattice that lie in a window."""
    return np.arange(np.ceil((middle - half) / step), np.floor((middle + half) / step) + 1) * step


def _rays(angles: np.ndarray) -> np.ndarray:
    azimuth, elevation = angles.T
    level = np.cos(elevation)
    return np.column_stack([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(elevation)])


def _arrays(things: tuple) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    panels = [thing for thing in things if isinstance(thing, Panel)]
    balls = [thing for thing in things if isinstance(thing, Ball)]
    rods = [thing for thing in things if isinstance(thing, Rod)]
    rows = [
        [*p.centre, *p.axes[0], *p.axes[1], *np.cross(*p.axes), *p.half]
        + [p.picture, *p.tones, p.cell, np.cos(p.turn), np.sin(p.turn), float(p.disc)]
        for p in panels
    ]
    return (
        np.array(rows, float).reshape(-1, 21),
        np.array([[*b.centre, b.radius, b.tone] for b in balls], float).reshape(-1, 5),
        np.array([[*r.centre, r.radius, r.length, r.tone] for r in rods], float).reshape(-1, 6),
    )


@njit(nogil=True, cache=True)
def _hash(i: int, j: int) -> float:
    value = np.sin(i * 127.1 + j * 311.7) * 43758.5453
    return value - np.floor(value)


@njit(nogil=True, cache=True)
def _tone(panel: np.ndarray, u: float, v: float) -> float:
    """Return the reflectance of a panel, -1 where rays pass."""
    picture, dark, bright, cell = int(panel[14]), panel[15], panel[16], panel[17]
    x = u * panel[18] + v * panel[19]
    y = v * panel[18] - u * panel[19]
    if picture == PLAIN:
        return bright
    if picture == CROSSED:
        return bright if x * y > 0 else dark
    if picture == TILED:
        return bright if (np.floor(x / cell) + np.floor(y / cell)) % 2 == 0 else dark
    if picture == PRINTED:
        coarse = _hash(int(np.floor(x / (4 * cell))), int(np.floor(y / (3 * cell))))
        fine = _hash(int(np.floor((x + 0.3 * y) / cell)), int(np.floor(y / cell)))
        return dark + (bright - dark) * min(max(0.7 * coarse + 0.5 * fine - 0.1, 0.0), 1.0)
    inside = abs(abs(x) - panel[12]) > cell and abs(abs(y) - panel[13]) > cell
    return -1.0 if inside and abs(x) > cell / 2 and abs(y) > cell / 2 else bright


@njit(nogil=True, cache=True)
def _first(ray: np.ndarray, panels: np.ndarray, balls: np.ndarray, rods: np.ndarray) -> tuple:
    """Return the range of what a ray meets first, 0 for nothing, and the light that returns."""
    best, light = 1e9, 0.0
    for panel in panels:
        slope = ray[0] * panel[9] + ray[1] * panel[10] + ray[2] * panel[11]
        if abs(slope) < 1e-6:
            continue
        t = (panel[0] * panel[9] + panel[1] * panel[10] + panel[2] * panel[11]) / slope
        if t <= 0 or t >= best:
            continue
        x, y, z = t * ray[0] - panel[0], t * ray[1] - panel[1], t * ray[2] - panel[2]
        u = x * panel[3] + y * panel[4] + z * panel[5]
        v = x * panel[6] + y * panel[7] + z * panel[8]
        if panel[20] > 0:
            outside = u * u + v * v > panel[12] * panel[12]
        else:
            outside = abs(u) > panel[12] or abs(v) > panel[13]
        if outside:
            continue
        tone = _tone(panel, u, v)
        if tone >= 0:
            best, light = t, tone * abs(slope) ** 0.5
    for ball in balls:
        along = ray[0] * ball[0] + ray[1] * ball[1] + ray[2] * ball[2]
        inside = along * along - ball[0] ** 2 - ball[1] ** 2 - ball[2] ** 2 + ball[3] ** 2
        if inside > 0 and 0 < along - np.sqrt(inside) < best:
            best, light = along - np.sqrt(inside), ball[4] * (np.sqrt(inside) / ball[3]) ** 0.5
    for rod in rods:
        flat = ray[0] ** 2 + ray[1] ** 2
        along = (ray[0] * rod[0] + ray[1] * rod[1]) / flat
        inside = along * along - (rod[0] ** 2 + rod[1] ** 2 - rod[3] ** 2) / flat
        if inside > 0:
            t = along - np.sqrt(inside)
            if 0 < t < best and rod[2] - rod[4] < t * ray[2] < rod[2]:
                best, light = t, rod[5]
    return (best, light) if best < 1e9 else (0.0, 0.0)


@njit(nogil=True, cache=True)
def _cast(
    rays: np.ndarray,
    panels: np.ndarray,
    balls: np.ndarray,
    rods: np.ndarray,
    beam: np.ndarray,
    chance: np.ndarray,
) -> tuple:
    """Return the range of each beam, the mean of its rays by their light, and the light that returns.

    The rays are spread at random, from 0 to 1 twice for each beam, so that the mean of many beams is a
    Gaussian one without the steps that a few fixed rays have.
    """
    ranges, power = np.zeros(len(rays)), np.zeros(len(rays))
    ray = np.zeros(3)
    turn = np.cos(GOLDEN_ANGLE), np.sin(GOLDEN_ANGLE)
    for number in range(len(rays)):
        middle = rays[number]
        level = np.sqrt(middle[0] ** 2 + middle[1] ** 2)
        across = (-middle[1] / level, middle[0] / level, 0.0)
        up = (-middle[2] * across[1], middle[2] * across[0], level)
        reach, _ = _first(middle, panels, balls, rods)
        width = (beam[0] / reach if reach > 0 else 0.0) + beam[1]
        cosine, sine = np.cos(2 * np.pi * chance[number, 1]), np.sin(2 * np.pi * chance[number, 1])
        total, weighted = 0.0, 0.0
        for part in range(RAYS):
            inner = (part + (chance[number, 0] + part * GOLDEN_PART) % 1.0) / RAYS
            away = width * np.sqrt(-0.5 * np.log(1.0 - inner))
            x, y = away * cosine, away * sine
            cosine, sine = cosine * turn[0] - sine * turn[1], sine * turn[0] + cosine * turn[1]
            for axis in range(3):
                ray[axis] = middle[axis] + x * across[axis] + y * up[axis]
            ray /= np.sqrt(ray[0] ** 2 + ray[1] ** 2 + ray[2] ** 2)
            t, light = _first(ray, panels, balls, rods)
            if t > 0:
                total += light
                weighted += light * t
        if total > 0.01 * RAYS:
            ranges[number] = weighted / total
            power[number] = total / RAYS
    return ranges, power
