"""Surfaces made by hand: the plane cells of rooms, as scans have them."""

import numpy as np
from ichnograph.algorithms.registration.adjustment.similarity import Pose
from ichnograph.algorithms.registration.surfaces.patches import Surfaces
from ichnograph.tests.scenes.surface_rooms import box, tilted

EDGE = 0.4
ROOM = np.array([6.0, 5.0, 3.0])


def cells_on(faces, seed=0, error=0.0):
    """Return centres and normals of cells on faces; each metre of a face has an error of its own (m)."""
    random = np.random.default_rng(seed)
    centres, normals = [], []
    for face in faces:
        sides = np.linalg.norm(face.first), np.linalg.norm(face.second)
        grid = np.meshgrid(*(np.arange(EDGE / 2, side, EDGE) / side for side in sides))
        u, v = (np.clip(axis.ravel() + random.uniform(-0.02, 0.02, axis.size), 0, 1) for axis in grid)
        normal = np.cross(face.first, face.second)
        normal /= np.linalg.norm(normal)
        tiles = np.floor(u * sides[0]).astype(int) + 100 * np.floor(v * sides[1]).astype(int)
        _, tile = np.unique(tiles, return_inverse=True)
        off = random.normal(0, error, tile.max() + 1)[tile]
        centres.append(
            face.corner + u[:, None] * face.first + v[:, None] * face.second + off[:, None] * normal
        )
        normals.append(np.broadcast_to(normal, centres[-1].shape))
    return np.concatenate(centres), np.concatenate(normals)


def surfaces_in(matrix, faces, station=None, seed=0, error=0.0):
    """Return the cells of faces in the frame of a scan that `matrix` takes to the control frame."""
    centres, normals = cells_on(faces, seed, error)
    own = (centres - matrix[:3, 3]) @ matrix[:3, :3]
    found = Surfaces(
        np.full(len(own), EDGE),
        own,
        normals @ matrix[:3, :3],
        np.full(len(own), 1e-8),
        np.zeros(len(own), bool),
    )
    if station is None:
        return found
    return found.seen_from((np.asarray(station, float) - matrix[:3, 3]) @ matrix[:3, :3])


def frame(heading=0.0, station=(0.0, 0.0, 0.0), tilt=(0.0, 0.0)):
    """Return the matrix of a scan."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = tilted(heading, tilt), station
    return matrix


def pose(matrix, shift=(0.0, 0.0, 0.0)):
    """Return a matrix as a pose, moved by a shift."""
    return Pose(matrix[:3, :3], np.array(1.0), np.zeros(3), matrix[:3, 3] + shift)


def room(low=(0.0, 0.0, 0.0), size=ROOM, omit=()):
    """Return the faces of a room."""
    return box(low, np.asarray(low) + size, omit)
