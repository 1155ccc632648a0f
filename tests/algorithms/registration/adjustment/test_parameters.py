"""The parameters of a transformation, and their derivatives."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.parameters import parameters, rotation_angles
from ichnograph.algorithms.registration.adjustment.similarity import Pose, moved_pose, rotation_about
from ichnograph.algorithms.registration.settings import Model
from scipy.spatial.transform import Rotation

ANGLES = np.array([4.0, -7.0, 130.0])
ROTATION = Rotation.from_euler("XYZ", ANGLES, degrees=True).as_matrix()


def pose(rotation=ROTATION, scale=1.0002):
    return Pose(rotation, np.array(scale), np.array([3.0, -2.0, 1.0]), np.array([40.0, 50.0, 6.0]))


@pytest.mark.parametrize("model", Model)
def test_names_and_values(model):
    rotation = Rotation.from_euler("z", 130, degrees=True).as_matrix() if model.levelled else ROTATION
    given = pose(rotation, 1.0002 if model.scaled else 1.0)
    values, derivatives = parameters(given, model)
    named = dict(values)

    assert len(values) == model.unknowns and derivatives.shape == (model.unknowns,) * 2
    assert [named[f"shift_{axis}"] for axis in "xyz"] == pytest.approx(given.matrix()[:3, 3])
    assert named["rotation_z"] == pytest.approx(130.0)
    if not model.levelled:
        assert [named["rotation_x"], named["rotation_y"]] == pytest.approx(ANGLES[:2])
    if model.scaled:
        assert named["scale"] == 1.0002


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY])
def test_the_derivatives_are_those_by_the_unknowns_of_the_adjustment(model):
    given = pose(scale=1.0002 if model.scaled else 1.0)
    _, derivatives = parameters(given, model)
    for unknown in range(model.unknowns):
        step = 1e-6 * np.eye(model.unknowns)[unknown]
        one, other = (dict(parameters(moved_pose(given, sign * step, model), model)[0]) for sign in (1, -1))
        numeric = [(one[name] - other[name]) / 2e-6 for name in one]
        assert derivatives[:, unknown] == pytest.approx(numeric, abs=1e-5)


def test_where_y_is_a_right_angle_the_other_two_are_one():
    upright = Rotation.from_euler("XYZ", [20, 90, 15], degrees=True).as_matrix()
    angles, derivatives = rotation_angles(upright)
    rebuilt = np.linalg.multi_dot([rotation_about(angle * axis) for angle, axis in zip(angles, np.eye(3))])

    assert rebuilt == pytest.approx(upright, abs=1e-7)
    assert angles[0] == 0.0
    assert np.isnan(derivatives).all()
