"""The parameters of a transformation as surveyors know them: shifts, angles in degrees, and the scale."""

import numpy as np

from ..settings import Model
from .settings import LayoutSettings
from .similarity import Pose, parameter_design

SHIFTS = ("shift_x", "shift_y", "shift_z")
ROTATIONS = ("rotation_x", "rotation_y", "rotation_z")


def parameters(
    pose: Pose, model: Model, settings: LayoutSettings = LayoutSettings()
) -> tuple[list[tuple[str, float]], np.ndarray]:
    """Return names and values of the parameters about the origin of the scan, and their derivatives.

    The rotation is R = Rx Ry Rz. The derivatives are by the unknowns of the adjustment, shape (u, u).

    Parameters
    ----------
    pose : Pose
        From the scan to the control frame.
    model : Model
    settings : LayoutSettings
    """
    matrix = pose.matrix()
    values = list(zip(SHIFTS, matrix[:3, 3].tolist()))
    derivatives = np.zeros((model.unknowns, model.unknowns))
    derivatives[:3] = parameter_design(pose.rotated(np.zeros((1, 3))), model)[0]
    if model.levelled:
        heading = np.degrees(np.arctan2(pose.rotation[1, 0], pose.rotation[0, 0]))
        values.append((ROTATIONS[2], float(heading)))
        derivatives[3, 3] = np.degrees(1.0)
    else:
        angles, by_rotations = rotation_angles(pose.rotation, settings)
        values += zip(ROTATIONS, np.degrees(angles).tolist())
        derivatives[3:6, 3:6] = np.degrees(by_rotations)
    if model.scaled:
        values.append(("scale", float(pose.scale)))
        derivatives[-1, -1] = pose.scale
    return values, derivatives


def rotation_angles(
    rotation: np.ndarray, settings: LayoutSettings = LayoutSettings()
) -> tuple[np.ndarray, np.ndarray]:
    """Return the angles of R = Rx Ry Rz in radians, and their derivatives by rotations about x, y and z.

    Parameters
    ----------
    rotation : ndarray, shape (3, 3)
    settings : LayoutSettings
    """
    y = np.arcsin(np.clip(rotation[0, 2], -1.0, 1.0))
    if np.cos(y) < settings.least_cosine:
        # Only the sum or difference of the others is known; z gets all of it.
        z = np.arctan2(rotation[1, 0], rotation[1, 1])
        return np.array([0.0, y, z]), np.full((3, 3), np.nan)
    x = np.arctan2(-rotation[1, 2], rotation[2, 2])
    z = np.arctan2(-rotation[0, 1], rotation[0, 0])
    about_y = np.array([0.0, np.cos(x), np.sin(x)])
    about_z = np.array([np.sin(y), -np.sin(x) * np.cos(y), np.cos(x) * np.cos(y)])
    axes = np.column_stack([[1.0, 0.0, 0.0], about_y, about_z])
    return np.array([x, y, z]), np.linalg.inv(axes)
