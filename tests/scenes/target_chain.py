"""A corridor of rooms, each scan seeing two of them; only the first room is surveyed."""

from dataclasses import dataclass

import numpy as np
from ichnograph.algorithms.registration.lists.point_list import PointList
from scipy.spatial.transform import Rotation

ROOM = np.array([10.0, 8.0, 3.5])
CORNER = np.array([500_000.0, 5_700_000.0, 120.0])


@dataclass(frozen=True)
class TargetChain:
    """Scans that are connected to each other only, and the truth.

    Attributes
    ----------
    control : PointList
        Of the first room.
    scans : tuple of PointList
        Each in its own frame.
    matrices : dict of str to ndarray, shape (4, 4)
        From the frames of the scans to the control frame.
    places : dict of str to dict of str to ndarray, shape (3,)
        True positions of the targets of each scan, by their names.
    """

    control: PointList
    scans: tuple[PointList, ...]
    matrices: dict
    places: dict


def target_chain(
    length: int, seed: int, targets: int = 5, noise: float = 0.003, control_noise: float = 0.0
) -> TargetChain:
    """Return a chain of `length` scans with the same number of `targets` in every room.

    Parameters
    ----------
    length, seed, targets : int
    noise, control_noise : float
        Standard deviations of the coordinates of targets and of surveyed points (m).
    """
    random = np.random.default_rng(seed)
    rooms = [
        random.random((targets, 3)) * ROOM + [number * ROOM[0], 0, 0] + CORNER for number in range(length + 1)
    ]
    names = tuple(f"P{number}" for number in range(1, targets + 1))
    control = PointList("control", names, rooms[0] + random.normal(0, control_noise, rooms[0].shape))
    scans, matrices, places = [], {}, {}
    for number in range(length):
        name = f"scan{number + 1:02d}"
        seen = np.concatenate(rooms[number : number + 2])
        matrix = np.eye(4)
        heading = random.uniform(0, 360)
        matrix[:3, :3] = Rotation.from_euler(
            "XYZ", [*random.normal(0, 1, 2), heading], degrees=True
        ).as_matrix()
        matrix[:3, 3] = seen.mean(axis=0) + random.normal(0, 1, 3)
        xyz = (seen - matrix[:3, 3]) @ matrix[:3, :3] + random.normal(0, noise, seen.shape)
        labels = tuple(f"T{row}" for row in range(1, len(seen) + 1))
        scans.append(PointList(name, labels, xyz))
        matrices[name], places[name] = matrix, dict(zip(labels, seen))
    return TargetChain(control, tuple(scans), matrices, places)
