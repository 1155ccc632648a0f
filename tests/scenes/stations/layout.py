"""Stations with known targets, and with things that look like targets."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Callable, Union

import numpy as np

from .caster import BARRED, CROSSED, PRINTED, TILED, Ball, Panel, Rod, Scanner, Window, cast

Thing = Union[Panel, Ball, Rod]

Maker = Callable[[np.ndarray, np.ndarray, np.random.Generator], tuple[Thing, ...]]

CHECKERBOARD, SPHERE = "black and white", "sphere"

GAP = 0.003
"""Between the windows of a station, radians."""


@dataclass(frozen=True)
class Placed:
    """A true target.

    Attributes
    ----------
    kind : str
    centre : ndarray, shape (3,)
        Relative to the scanner.
    size, distance : float
        Metres.
    incidence : float
        Degrees; 0 of a sphere.
    """

    kind: str
    centre: np.ndarray
    size: float
    distance: float
    incidence: float


@dataclass(frozen=True)
class Station:
    """A scan and what is in it.

    Attributes
    ----------
    xyz : ndarray, shape (n, 3)
        Relative to the scanner.
    intensity : ndarray of uint16, shape (n,)
    targets : tuple of Placed
    """

    xyz: np.ndarray
    intensity: np.ndarray
    targets: tuple[Placed, ...]


def target_station(
    scanner: Scanner, places: Sequence[tuple[str, float, float, float]], seed: int, covered: float = 0.0
) -> Station:
    """Return a station that sees targets, each before a wall.

    Parameters
    ----------
    scanner : Scanner
    places : sequence of (str, float, float, float)
        Kind, size, distance and incidence (degrees) of each.
    seed : int
    covered : float
        Part of the width of each target that a post hides.
    """
    rng = np.random.default_rng(seed)
    windows, targets, azimuth = [], [], -np.pi
    level = rng.uniform(-0.4, 0.8)
    for kind, size, distance, incidence in places:
        # Side by side, so that the scan is no larger than what is in it.
        half = (0.9 * size + 0.03) / distance / np.cos(level)
        azimuth += half + GAP
        elevation = level + rng.uniform(-0.02, 0.02)
        make = _checkerboard if kind == CHECKERBOARD else _sphere
        window = make(azimuth, elevation, size, distance, incidence, rng)
        if covered:
            window = replace(window, things=(*window.things, _post(window, size, distance, covered)))
        windows.append(window)
        targets.append(Placed(kind, distance * _direction(azimuth, elevation), size, distance, incidence))
        azimuth += half
    return _scanned(scanner, windows, targets, rng)


def cluttered_station(scanner: Scanner, distances: Sequence[float], seed: int) -> Station:
    """Return a station without targets that sees one of each thing of `clutter` at every distance."""
    rng = np.random.default_rng(seed)
    makers = (poster, tiles, small_tiles, glazing, lamp, globe_on_wall, football, column, stripes, doorway)
    windows, azimuth = [], -np.pi
    for make in makers:
        for distance in distances:
            half = min(0.8 / distance, 0.12)
            azimuth += half + GAP
            windows.append(_window(azimuth, rng.uniform(-0.02, 0.02), distance, half, make, rng))
            azimuth += half
    return _scanned(scanner, windows, [], rng)


def poster(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a poster on a wall: blocks and letters of many tones."""
    grain = rng.uniform(0.01, 0.06)
    return (
        Panel(centre, axes, (0.45, 0.6), PRINTED, (0.05, 0.8), grain, rng.uniform(-0.1, 0.1)),
        _wall(centre, axes, 0.01),
    )


def tiles(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a surface of black and white tiles of 20 cm."""
    return (Panel(centre, axes, (1.2, 1.2), TILED, (0.1, 0.7), 0.2, rng.uniform(0, 1.5)),)


def small_tiles(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a surface of black and white tiles of 6 cm."""
    return (Panel(centre, axes, (0.8, 0.8), TILED, (0.1, 0.7), 0.06, rng.uniform(0, 1.5)),)


def glazing(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a window with a cross of glazing bars, before a room."""
    return (
        Panel(centre, axes, (0.5, 0.6), BARRED, (0.7, 0.7), 0.05),
        _wall(centre, axes, rng.uniform(1.5, 4.0), 0.3),
    )


def lamp(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a hanging globe of a diameter that no target has."""
    radius = rng.choice([0.0575, 0.0875, 0.125, 0.15])
    return (Ball(centre, radius, 0.8), Rod(centre + [0, 0, 0.6], 0.01, 0.6), _wall(centre, axes, 1.2))


def globe_on_wall(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return half a globe of the diameter of a target on a wall."""
    return (Ball(centre, rng.choice([0.0725, 0.1]), 0.8), _wall(centre, axes, 0.0))


def football(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a ball on the floor."""
    floor = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    return (
        Ball(centre, 0.11, 0.7),
        Panel(centre - [0, 0, 0.11], floor, (1.5, 1.5)),
        _wall(centre, axes, 1.5),
    )


def column(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return an upright pipe of the diameter of a target."""
    return (Rod(centre + [0, 0, 1.0], rng.choice([0.05, 0.0725]), 2.0, 0.6), _wall(centre, axes, 0.8))


def stripes(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return a striped board: edges, but none that cross."""
    bars = [
        Panel(centre + offset * axes[0], axes, (0.02, 0.3), 0, (0.1, 0.1))
        for offset in np.arange(-3, 4) * 0.08
    ]
    return (*bars, _wall(centre, axes, 0.01, 0.8))


def doorway(centre: np.ndarray, axes: np.ndarray, rng: np.random.Generator) -> tuple[Thing, ...]:
    """Return four large fields of two tones that meet: paint and panelling of a wall."""
    return (Panel(centre, axes, (1.5, 1.5), CROSSED, (0.2, 0.7), turn=rng.uniform(-0.1, 0.1)),)


def _scanned(
    scanner: Scanner, windows: Sequence[Window], targets: Sequence[Placed], rng: np.random.Generator
) -> Station:
    parts = [cast(scanner, window, rng) for window in windows]
    xyz = np.concatenate([part[0] for part in parts])
    return Station(xyz, np.concatenate([part[1] for part in parts]), tuple(targets))


def _direction(azimuth: float, elevation: float) -> np.ndarray:
    level = np.cos(elevation)
    return np.array([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(elevation)])


def _facing(direction: np.ndarray, incidence: float, lean: float) -> np.ndarray:
    """Return the axes of a panel whose normal is off the ray by `incidence` radians, towards `lean`."""
    right = np.array([-direction[1], direction[0], 0.0])
    right /= np.linalg.norm(right)
    up = np.cross(direction, right)
    aside = np.cos(lean) * right + np.sin(lean) * up
    normal = np.cos(incidence) * direction + np.sin(incidence) * aside
    first = np.cross([0.0, 0.0, 1.0], normal)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(normal, first)])


def _wall(centre: np.ndarray, axes: np.ndarray, behind: float, tone: float = 0.5) -> Panel:
    return Panel(centre + behind * np.cross(*axes), axes, (2.5, 2.5), tones=(tone, tone))


def _window(
    azimuth: float, elevation: float, distance: float, angle: float, make: Maker, rng: np.random.Generator
) -> Window:
    direction = _direction(azimuth, elevation)
    axes = _facing(direction, np.radians(rng.uniform(0, 45)), rng.uniform(0, 2 * np.pi))
    return Window(
        azimuth, elevation, (angle / np.cos(elevation), angle), make(distance * direction, axes, rng)
    )


def _checkerboard(
    azimuth: float, elevation: float, size: float, distance: float, incidence: float, rng: np.random.Generator
) -> Window:
    direction = _direction(azimuth, elevation)
    axes = _facing(direction, np.radians(incidence), rng.uniform(0, 2 * np.pi))
    centre = distance * direction
    disc = bool(rng.random() < 0.4)
    half = size / 2
    board = Panel(
        centre, axes, (half, half), CROSSED, (rng.uniform(0.04, 0.15), rng.uniform(0.6, 0.85)),
        turn=rng.uniform(0, np.pi) if disc else 0.0, disc=disc,
    )  # fmt: skip
    behind = rng.choice([0.002, 0.05, 0.5])
    angle = (0.9 * size + 0.03) / distance
    things = (board, _wall(centre, axes, behind, rng.uniform(0.3, 0.8)))
    return Window(azimuth, elevation, (angle / np.cos(elevation), angle), things)


def _sphere(
    azimuth: float, elevation: float, size: float, distance: float, incidence: float, rng: np.random.Generator
) -> Window:
    direction = _direction(azimuth, elevation)
    axes = _facing(direction, np.radians(incidence), rng.uniform(0, 2 * np.pi))
    centre = distance * direction
    angle = (0.9 * size + 0.03) / distance
    things = (
        Ball(centre, size / 2, 0.75),
        Rod(centre - [0, 0, 0.45 * size], 0.012, 0.5),
        _wall(centre, axes, rng.uniform(0.6 * size + 0.02, 2.0)),
    )
    return Window(azimuth, elevation, (angle / np.cos(elevation), angle), things)


def _post(window: Window, size: float, distance: float, covered: float) -> Rod:
    """Return a post before the right part of a target."""
    direction = _direction(window.azimuth, window.elevation)
    right = np.array([direction[1], -direction[0], 0.0]) / np.hypot(*direction[:2])
    width = 0.06
    middle = (0.9 * distance) * direction + 0.9 * (0.5 - covered) * size * right + 0.5 * width * right
    return Rod(middle + [0, 0, 0.6], width / 2, 1.2)
