"""Covariances of targets in the frame of the control points."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.similarity import Pose
from ichnograph.algorithms.registration.adjustment.target_covariances import in_control_frame

QUARTER = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def turned(scale=1.0):
    return Pose(QUARTER, np.array(scale), np.zeros(3), np.array([50.0, 60.0, 7.0]))


def test_a_covariance_turns_with_the_scan():
    (found,) = in_control_frame(np.diag([1.0, 4.0, 9.0])[None], 1, turned(), 0.5)

    assert found == pytest.approx(np.diag([4.0, 1.0, 9.0]))


def test_a_covariance_is_of_the_units_of_the_scan():
    (found,) = in_control_frame(np.eye(3)[None], 1, turned(scale=0.001), 0.5)

    assert found == pytest.approx(np.eye(3) * 1e-6)


def test_a_target_without_a_covariance_has_the_common_standard_deviation_in_the_control_frame():
    found = in_control_frame(np.stack([np.eye(3), np.full((3, 3), np.nan)]), 2, turned(scale=2.0), 0.5)

    assert found == pytest.approx(np.stack([np.eye(3) * 4, np.eye(3) * 0.25]))
    assert in_control_frame(None, 1, turned(), 0.5) == pytest.approx(np.eye(3)[None] * 0.25)
