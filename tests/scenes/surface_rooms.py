"""Rooms as clouds from stations: rectangles that rays meet, in a fraction of a second for each scan."""

from dataclasses import dataclass

import numpy as np
from ichnograph.algorithms.registration.surfaces.patches import surfaces_of
from numba import njit
from scipy.spatial.transform import Rotation

from .target_chain import CORNER, ROOM


@dataclass(frozen=True)
class Face:
    """A rectangle: a corner and two sides at right angles (m)."""

    corner: np.ndarray
    first: np.ndarray
    second: np.ndarray


def box(low, high, omit=()):
    """Return the faces of a box, without those named in `omit`, as -x or +z."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    faces = []
    for axis in range(3):
        first, second = (np.eye(3)[other] * (high - low) for other in range(3) if other != axis)
        for sign, corner in (("-", low), ("+", low + np.eye(3)[axis] * (high - low))):
            if f"{sign}{'xyz'[axis]}" not in omit:
                faces.append(Face(corner, first, second))
    return faces


def furniture(low, high, count, seed):
    """Return the faces of `count` boxes of random size on the floor and at the walls of a room."""
    random = np.random.default_rng(seed)
    low, high = np.asarray(low, float), np.asarray(high, float)
    faces = []
    for _ in range(count):
        size = random.uniform([0.4, 0.4, 0.4], [1.8, 0.8, 2.1])
        corner = low + random.random(3) * (high - low - size) * [1, 1, 0]
        faces += box(corner, corner + size)
    return faces


def seen(faces, station, step_deg=0.6, noise=0.002, seed=0, reach=60.0):
    """Return the points that a scanner at `station` has of faces, about itself, in the axes of the faces.

    Parameters
    ----------
    faces : list of Face
    station : array_like, shape (3,)
    step_deg : float
        Between rays.
    noise : float
        Standard deviation of a range (m).
    seed : int
    reach : float
        Longest range (m).
    """
    random = np.random.default_rng(seed)
    azimuth, height = np.meshgrid(
        np.radians(np.arange(0, 360, step_deg)), np.radians(np.arange(-65 + step_deg / 3, 89, step_deg))
    )
    rays = np.column_stack(
        [
            (np.cos(height) * np.cos(azimuth)).ravel(),
            (np.cos(height) * np.sin(azimuth)).ravel(),
            np.sin(height).ravel(),
        ]
    )
    corners, firsts, seconds = (
        np.array([getattr(face, side) for face in faces], float) for side in ("corner", "first", "second")
    )
    ranges = _ranges(rays, corners - np.asarray(station, float), firsts, seconds)
    kept = ranges < reach
    return rays[kept] * (ranges[kept] + random.normal(0, noise, kept.sum()))[:, None]


@njit(cache=True)
def _ranges(rays, corners, firsts, seconds):
    """Return the distance at which each ray meets the first rectangle, infinite if none."""
    ranges = np.full(len(rays), np.inf)
    for number in range(len(corners)):
        corner, first, second = corners[number], firsts[number], seconds[number]
        normal = np.array(
            [
                first[1] * second[2] - first[2] * second[1],
                first[2] * second[0] - first[0] * second[2],
                first[0] * second[1] - first[1] * second[0],
            ]
        )
        offset = corner[0] * normal[0] + corner[1] * normal[1] + corner[2] * normal[2]
        width, height = (first**2).sum(), (second**2).sum()
        for i in range(len(rays)):
            x, y, z = rays[i]
            slope = x * normal[0] + y * normal[1] + z * normal[2]
            if slope * offset <= 0 or offset / slope >= ranges[i]:
                continue
            distance = offset / slope
            a, b, c = x * distance - corner[0], y * distance - corner[1], z * distance - corner[2]
            u = (a * first[0] + b * first[1] + c * first[2]) / width
            v = (a * second[0] + b * second[1] + c * second[2]) / height
            if 0 <= u <= 1 and 0 <= v <= 1:
                ranges[i] = distance
    return ranges


def in_frame(points, station, matrix):
    """Return points about a station in the frame of a scan that `matrix` takes to the control frame."""
    return (points + station - matrix[:3, 3]) @ matrix[:3, :3]


def room_chain(length, room, seed):
    """Return rooms in a row, with pilasters and furniture, and the doors between them.

    Parameters
    ----------
    length : int
        Number of doors between two rooms.
    room : array_like, shape (3,)
        Size of a room (m).
    seed : int

    Returns
    -------
    rooms : list of list of Face
        Each with the walls on its sides.
    doors : list of ndarray, shape (3,)
        Where a scanner stands in the door from room to room.
    """
    random = np.random.default_rng(seed)
    lefts = random.uniform(2.0, room[1] - 3.2, length + 2)
    rooms = []
    for number in range(length + 1):
        low = np.array([number * room[0] + 0.1, 0.0, 0.0])
        high = np.array([(number + 1) * room[0] - 0.1, room[1], room[2]])
        faces = box(low, high, omit=("-x", "+x"))
        faces += furniture(low + [1.5, 0.0, 0.0], high - [1.5, 0.0, 0.0], 4, seed * 100 + number)
        for along in random.uniform(low[0] + 1, high[0] - 2, 2):
            faces += box([along, 0.0, 0.0], [along + 0.5, 0.3, room[2]], omit=("-y", "-z", "+z"))
        faces += wall_with_door(low[0], lefts[number], room) + wall_with_door(
            high[0], lefts[number + 1], room
        )
        rooms.append(faces)
    return rooms, [np.array([(n + 1) * room[0], lefts[n + 1] + 0.6, 1.7]) for n in range(length)]


def wall_with_door(x, left, room):
    """Return the faces of a wall across the rooms, beside a door of 1.2 by 2.1 m and above it."""
    up = np.array([0.0, 0.0, room[2]])
    return [
        Face(np.array([x, 0.0, 0.0]), np.array([0.0, left, 0.0]), up),
        Face(np.array([x, left + 1.2, 0.0]), np.array([0.0, room[1] - left - 1.2, 0.0]), up),
        Face(np.array([x, left, 2.1]), np.array([0.0, 1.2, 0.0]), up - [0.0, 0.0, 2.1]),
    ]


def chain_surfaces(chain, seed, step_deg):
    """Return the surfaces that the scans of a chain see from the doors between its rooms, by their names."""
    rooms, doors = room_chain(len(chain.scans), ROOM, seed)
    found = {}
    for number, (scan, door) in enumerate(zip(chain.scans, doors)):
        faces = [face for each in rooms[max(number - 1, 0) : number + 3] for face in each]
        points = seen(faces, door, step_deg, seed=1000 * seed + number)
        matrix = chain.matrices[scan.name]
        station = in_frame(np.zeros((1, 3)), CORNER + door, matrix)[0]
        found[scan.name] = surfaces_of([in_frame(points, CORNER + door, matrix)]).seen_from(station)
    return found


def tilted(heading, tilt=(0.0, 0.0)):
    """Return a rotation by angles in degrees."""
    return Rotation.from_euler("XYZ", [*tilt, heading], degrees=True).as_matrix()
