"""A pose turns and shifts; what it does besides is said, and what moves no points is refused."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.poses import pose_doubt, pose_problem
from scipy.spatial.transform import Rotation

TURN = Rotation.from_euler("xyz", [10, 20, 30], degrees=True).as_matrix()
NEAR = np.array([412345.0, 5812345.0, 71.0])


def test_a_rotation_of_few_decimals_and_a_shift_are_fine():
    assert pose_problem(TURN.round(3), NEAR) == ""
    assert pose_doubt(TURN.round(3)) == ""


@pytest.mark.parametrize(
    ("linear", "shift", "problem"),
    [
        (np.zeros((3, 3)), NEAR, "is all zero"),
        (np.full((3, 3), np.nan), NEAR, "holds something that is not a number"),
        (TURN, NEAR * np.inf, "holds something that is not a number"),
        (TURN, NEAR * 1e9, "moves the points by"),
        (TURN @ np.diag([1, 1, -1]), NEAR, "mirrors the points"),
        (TURN @ np.diag([1, 1, 0]), NEAR, "presses or blows up"),
        (1e-90 * TURN, NEAR, "presses or blows up"),
        (1e90 * TURN, NEAR, "presses or blows up"),
    ],
)
def test_what_moves_no_points_is_a_problem(linear, shift, problem):
    assert pose_problem(linear, shift).startswith(problem)


@pytest.mark.parametrize(
    ("linear", "doubt"),
    [(0.3048 * TURN, "scales the points by 0.3048"), (TURN @ np.diag([1, 1, 2]), "distorts")],
)
def test_scale_and_skew_are_doubtful(linear, doubt):
    assert pose_problem(linear, NEAR) == ""
    assert pose_doubt(linear).startswith(doubt)
