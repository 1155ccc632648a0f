"""Scans of rooms without targets: furnished ones, empty ones, corridors, and chains of rooms alike."""

from collections.abc import Sequence

import numpy as np
from ichnograph.algorithms.registration.surfaces.patches import Surfaces, surfaces_of

from .surface_rooms import Face, box, furniture, in_frame, seen, tilted, wall_with_door

FURNISHED = [
    *box((0, 0, 0), (8, 5, 3)),
    *furniture((0, 0, 0), (8, 5, 3), 6, 3),
    *box((3, 0, 0), (3.6, 0.5, 3), omit=("-y", "-z", "+z")),
]
"""A room of 8 by 5 m with a pilaster and six pieces of furniture."""

OTHER = [*box((0, 0, 0), (5, 4, 2.7)), *furniture((0, 0, 0), (5, 4, 2.7), 4, 8)]
"""A room that nothing of the furnished one can be seen from."""

EMPTY = box((0, 0, 0), (8, 5, 3))

CORRIDOR = box((-60, 0, 0), (60, 2.2, 2.8), omit=("-x", "+x"))

STATIONS = (2.0, 2.0, 1.6), (6.0, 3.2, 1.6)
"""Of two scans of the furnished room, or of the empty one."""

ALONG = (0.0, 1.0, 1.6), (4.0, 1.2, 1.6)
"""Of two scans of the corridor."""


def stood(faces: list[Face], station: Sequence[float], number: int = 0, **chosen: float) -> np.ndarray:
    """Return the points of a scan in its own frame, which `matrix_of` takes to that of the faces."""
    place = np.asarray(station, float)
    points = seen(faces, place, seed=number, **chosen)
    return in_frame(points, place, matrix_of(station, number))


def matrix_of(station: Sequence[float], number: int = 0) -> np.ndarray:
    """Return the matrix of a scanner, from its frame to that of the room; each has another heading."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = tilted(50 + 80 * number), station
    return matrix


def surfaces_from(
    faces: list[Face], station: Sequence[float], number: int = 0, step_deg: float = 1.2, **chosen: float
) -> Surfaces:
    """Return the surfaces of a scan in its own frame."""
    points = stood(faces, station, number, step_deg=step_deg, **chosen)
    return surfaces_of([points]).seen_from(np.zeros(3))


def rooms_alike(
    count: int, seed: int, size: Sequence[float] = (7.0, 6.0, 3.0), pieces: int = 5
) -> tuple[list[Face], list[np.ndarray]]:
    """Return rooms of one size in a row, with doors between them, and two stations in each.

    Parameters
    ----------
    count : int
        Number of rooms.
    seed : int
    size : sequence of float
        Of a room (m).
    pieces : int
        Of furniture, in each room others.
    """
    random = np.random.default_rng(seed)
    size = np.asarray(size, float)
    lefts = random.uniform(1, size[1] - 2.2, count + 1)
    faces, stations = [], []
    for room in range(count):
        low, high = np.array([room * size[0] + 0.1, 0, 0]), np.array([(room + 1) * size[0] - 0.1, *size[1:]])
        faces += box(low, high, omit=("-x", "+x")) + furniture(low, high, pieces, 100 * seed + room)
        faces += wall_with_door(low[0], lefts[room], size) + wall_with_door(high[0], lefts[room + 1], size)
        left = lefts[room + 1]
        faces += box((high[0], left, 0), (high[0] + 0.2, left + 1.2, 2.1), omit=("-x", "+x", "-z"))
        inside = low[0] + 1.2 + random.uniform(0, 1), lefts[room] + random.uniform(0, 1.2), 1.6
        stations += [np.array(inside), np.array([high[0] - 0.4, left + 0.6, 1.6])]
    return faces, stations
