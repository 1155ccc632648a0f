"""The similarity A = m R B + T, and its best values for points whose partners are known."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..settings import Model


@dataclass(frozen=True)
class Pose:
    """A similarity about a centre, or a stack of them along the first axis of every array.

    The centre keeps products small, so that coordinates of millions of metres lose no digits.

    Attributes
    ----------
    rotation : ndarray, shape (..., 3, 3)
    scale : ndarray, shape (...)
    centre : ndarray, shape (..., 3)
        In the scan.
    position : ndarray, shape (..., 3)
        Of the centre in the control frame.
    """

    rotation: np.ndarray
    scale: np.ndarray
    centre: np.ndarray
    position: np.ndarray

    def rotated(self, points: np.ndarray) -> np.ndarray:
        """Return m R (b - centre), shape (..., n, 3), for points b of shape (..., n, 3)."""
        arms = (points - self.centre[..., None, :]) @ np.swapaxes(self.rotation, -1, -2)
        return arms * self.scale[..., None, None]

    def apply(self, points: np.ndarray) -> np.ndarray:
        """Return the points in the control frame, shape (..., n, 3)."""
        return self.rotated(points) + self.position[..., None, :]

    def matrix(self) -> np.ndarray:
        """Return the transformation as a matrix of shape (4, 4); for a single pose."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.scale * self.rotation
        matrix[:3, 3] = self.position - matrix[:3, :3] @ self.centre
        return matrix

    def __getitem__(self, index: Any) -> "Pose":
        return Pose(self.rotation[index], self.scale[index], self.centre[index], self.position[index])


def fit_pose(control: np.ndarray, targets: np.ndarray, model: Model) -> Pose:
    """Return the similarity with the least squares of A - m R B - T, in closed form.

    Horn's unit quaternion is the eigenvector of the largest signed eigenvalue, which is right for targets in
    one plane too; a levelled scan rotates by one angle.

    Parameters
    ----------
    control, targets : ndarray, shape (..., k, 3)
        Partners, row by row.
    model : Model

    References
    ----------
    Horn (1987): Closed-form solution of absolute orientation using unit quaternions.
    """
    position, centre = control.mean(axis=-2), targets.mean(axis=-2)
    a, b = control - position[..., None, :], targets - centre[..., None, :]
    products = np.swapaxes(b, -1, -2) @ a
    rotation = _about_vertical(products) if model.levelled else _by_quaternion(products)
    scale = np.ones(position.shape[:-1])
    if model.scaled:
        # Coincident targets have no scale; nothing is divided by zero.
        squares = np.maximum((b**2).sum(axis=(-2, -1)), np.finfo(float).tiny)
        scale = (a * (b @ np.swapaxes(rotation, -1, -2))).sum(axis=(-2, -1)) / squares
    return Pose(rotation, scale, centre, position)


def _about_vertical(products: np.ndarray) -> np.ndarray:
    angle = np.arctan2(products[..., 0, 1] - products[..., 1, 0], products[..., 0, 0] + products[..., 1, 1])
    rotation = np.zeros(products.shape)
    rotation[..., 0, 0] = rotation[..., 1, 1] = np.cos(angle)
    rotation[..., 1, 0] = np.sin(angle)
    rotation[..., 0, 1] = -rotation[..., 1, 0]
    rotation[..., 2, 2] = 1.0
    return rotation


def _by_quaternion(products: np.ndarray) -> np.ndarray:
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = np.moveaxis(products, (-2, -1), (0, 1))
    rows = [
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, -xx + yy - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, -xx - yy + zz],
    ]
    symmetric = np.moveaxis(np.array(rows), (0, 1), (-2, -1))
    _, vectors = np.linalg.eigh(symmetric)
    w, x, y, z = np.moveaxis(vectors[..., -1], -1, 0)
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def parameter_design(arms: np.ndarray, model: Model) -> np.ndarray:
    """Return the derivatives of transformed points by the parameters of a scan.

    Parameters
    ----------
    arms : ndarray, shape (n, 3)
        m R (b - centre).
    model : Model

    Returns
    -------
    ndarray, shape (n, 3, u)
        By the position (3), small rotations about x, y and z of the control frame (about z only
        if levelled), and the relative change of the scale.
    """
    count = len(arms)
    x, y, z = arms.T
    zero = np.zeros(count)
    about_x = np.column_stack([zero, -z, y])
    about_y = np.column_stack([z, zero, -x])
    about_z = np.column_stack([-y, x, zero])
    columns = [about_z] if model.levelled else [about_x, about_y, about_z]
    if model.scaled:
        columns.append(arms)
    shifts = np.broadcast_to(np.eye(3), (count, 3, 3))
    return np.concatenate([shifts, np.stack(columns, axis=-1)], axis=-1)


def moved_pose(pose: Pose, step: np.ndarray, model: Model) -> Pose:
    """Return the pose after a step of its parameters, as `parameter_design` orders them."""
    vector = np.array([0.0, 0.0, step[3]]) if model.levelled else step[3:6]
    scale = pose.scale * (1.0 + step[-1] if model.scaled else 1.0)
    return Pose(rotation_about(vector) @ pose.rotation, scale, pose.centre, pose.position + step[:3])


def rotation_about(vector: np.ndarray) -> np.ndarray:
    """Return the rotation about `vector` by its length in radians (Rodrigues)."""
    angle = np.linalg.norm(vector)
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * (cross @ cross)
