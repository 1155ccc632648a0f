"""A scan as in the field: each station in its own frame, with its targets, and control points."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from .scene import Pose, Scan, Scene

APART = 1.5
"""Least distance between targets (m)."""

NEAR = 0.10
"""A station sees a target if one of its points is this close (m)."""

CONTROL_SHARE = 0.6
"""Share of the targets that are surveyed; the others only connect stations."""


@dataclass(frozen=True)
class Survey:
    """Targets on a scene.

    Attributes
    ----------
    control : dict of str to ndarray, shape (3,)
        Surveyed points, by their names, in the world.
    frames : tuple of Pose
        From the frame of each station to the world.
    picked : tuple of ndarray, shape (k, 3)
        The targets of each station in its own frame, in random order.
    """

    control: dict
    frames: tuple[Pose, ...]
    picked: tuple[np.ndarray, ...]


def survey(scene: Scene, scan: Scan, targets: int = 80, noise: float = 0.002, seed: int = 0) -> Survey:
    """Place targets where the scan has points above the ground, and pick them in every station.

    Parameters
    ----------
    scene : Scene
    scan : Scan
        Of the scene.
    targets : int
    noise : float
        Standard deviation of a picked coordinate (m).
    seed : int
    """
    random = np.random.default_rng(seed)
    height = scan.points[:, 2] - np.median(scene.stations[:, 2])
    places = _apart(scan.points[random.permutation(np.flatnonzero(height > -0.5))[:5000]], targets)
    surveyed = random.permutation(len(places))[: round(CONTROL_SHARE * len(places))]
    frames, picked = [], []
    for number, station in enumerate(scene.stations):
        frame = Pose(random.uniform(0, 360), tuple(station))
        own = cKDTree(scan.points[scan.station == number])
        seen = places[random.permutation(np.flatnonzero(own.query(places)[0] <= NEAR))]
        frames.append(frame)
        picked.append(in_frame(frame, seen) + random.normal(0, noise, seen.shape))
    control = {f"P{number + 1}": places[number] for number in np.sort(surveyed)}
    return Survey(control, tuple(frames), tuple(picked))


def in_frame(frame: Pose, points: np.ndarray) -> np.ndarray:
    """Return points of the world, shape (n, 3), in a frame."""
    return (points - frame.shift) @ frame.rotation


def _apart(points: np.ndarray, count: int) -> np.ndarray:
    """Return the first points that keep the least distance from each other."""
    kept: list = []
    for point in points:
        if all(np.linalg.norm(point - other) >= APART for other in kept):
            kept.append(point)
        if len(kept) == count:
            break
    return np.array(kept)
