"""Surveyed control points on a building, and the targets picked in one scan of it, with the truth."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from ichnograph.algorithms.registration.lists.point_list import PointList
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

SIZE = np.array([30.0, 20.0, 9.0])
"""Of the building: three storeys, with two partitions and a grid of pillars."""

STOREY = 3.0
PILLAR = 0.4
CLEARANCE = 0.10
"""Least distance between two positions of a scene (m)."""

CORNER = np.array([500_000.0, 5_700_000.0, 120.0])
"""South-west of the building, on its floor, in a national grid."""


@dataclass(frozen=True)
class TargetScene:
    """A control list, a scan's targets, and the truth.

    Attributes
    ----------
    control, targets : PointList
        In a national grid, and in the scanner's own frame.
    truth : dict of str to str or None
        The control point of every target; None without one.
    matrix : ndarray, shape (4, 4)
        From the scanner's frame to the grid.
    """

    control: PointList
    targets: PointList
    truth: dict[str, Optional[str]]
    matrix: np.ndarray


def target_scene(
    control: int,
    picked: int,
    common: int,
    noise: float = 0.002,
    seed: int = 0,
    tilt: Optional[float] = None,
    scale: float = 1.0,
) -> TargetScene:
    """Return a scene.

    Parameters
    ----------
    control, picked, common : int
        Numbers of control points, of targets picked in the scan, and of those that are control points. The
        other targets are elsewhere on the same building.
    noise : float
        Standard deviation of a target's coordinate (m).
    seed : int
        Of the positions, the pose and the noise.
    tilt : float or None
        Standard deviation of the tilt about the level axes (degrees); None for any rotation.
    scale : float
        Metres of the grid in a unit of the scanner's frame.
    """
    random = np.random.default_rng(seed)
    places = _places(control + picked - common, random) + CORNER
    seen = random.permutation(np.r_[random.permutation(control)[:common], control : len(places)])
    matrix = _pose(random, tilt, scale)
    noisy = places[seen] + random.normal(0, noise, (picked, 3))
    scanned = np.linalg.solve(matrix[:3, :3], (noisy - matrix[:3, 3]).T).T
    names = tuple(f"P{number}" for number in 101 + np.arange(control))
    labels = tuple(f"T{number}" for number in 1 + np.arange(picked))
    return TargetScene(
        PointList("control", names, places[:control]),
        PointList("scan", labels, scanned),
        {label: names[place] if place < control else None for label, place in zip(labels, seen)},
        matrix,
    )


def _places(count: int, random: np.random.Generator) -> np.ndarray:
    """Return positions on the building: seven of ten on walls, the others on pillars and floors."""
    surfaces, weights = _building()
    # More than needed, because those too close to another are dropped.
    chosen = surfaces[random.choice(len(surfaces), 2 * count + 50, p=weights)]
    share = random.random((2, len(chosen), 1))
    points = chosen[:, 0] + share[0] * chosen[:, 1] + share[1] * chosen[:, 2]
    crowding = cKDTree(points).query_pairs(CLEARANCE, output_type="ndarray")
    return np.delete(points, crowding.max(axis=1), axis=0)[:count]


def _building() -> tuple[np.ndarray, np.ndarray]:
    """Return rectangles, shape (n, 3, 3), as a corner and two edges, and the probability of each."""
    length, depth, height = SIZE
    east, north, up = np.diag(SIZE)
    walls = [(0 * east, east, up), (north, east, up), (0 * east, north, up), (east, north, up)]
    walls += [(0.4 * east, north, up), (0.6 * north, east, up)]
    floors = [(level * up / height, east, north) for level in np.arange(0, height, STOREY)]
    feet = [(x, y, 0) for x in np.arange(5, length, 5) for y in np.arange(4, depth, 4)]
    faces = [(0, 0, PILLAR, 0), (0, PILLAR, PILLAR, 0), (0, 0, 0, PILLAR), (PILLAR, 0, 0, PILLAR)]
    pillars = [
        (np.add(foot, (dx, dy, 0)), np.array([width, breadth, 0]), up)
        for foot in feet
        for dx, dy, width, breadth in faces
    ]
    kinds = ((walls, 0.7), (pillars, 0.2), (floors, 0.1))
    weights = [np.full(len(kind), share / len(kind)) for kind, share in kinds]
    return np.array(walls + pillars + floors, dtype=float), np.concatenate(weights)


def _pose(random: np.random.Generator, tilt: Optional[float], scale: float) -> np.ndarray:
    """Return the pose of a scanner in the building, with any heading."""
    if tilt is None:
        rotation = Rotation.random(random_state=random.integers(2**32))
    else:
        level = random.normal(0, tilt, 2)
        rotation = Rotation.from_euler("xyz", [*level, random.uniform(0, 360)], degrees=True)
    matrix = np.eye(4)
    matrix[:3, :3] = scale * rotation.as_matrix()
    matrix[:3, 3] = CORNER + random.random(3) * SIZE
    return matrix
