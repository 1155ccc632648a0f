"""Surfaces as observations of two poses."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.similarity import moved_pose
from ichnograph.algorithms.registration.settings import Model
from ichnograph.algorithms.registration.surfaces.pairing import Placed, paired
from ichnograph.algorithms.registration.surfaces.settings import PairSettings
from ichnograph.algorithms.registration.surfaces.tie import free_directions
from ichnograph.tests.algorithms.registration.surfaces.rooms import frame, pose, room, surfaces_in

HERE, THERE = frame(20, (2.0, 2.0, 1.5)), frame(130, (4.0, 3.0, 1.7), (1.0, -2.0))


@pytest.fixture
def tie():
    one, other = (
        Placed(surfaces_in(matrix, room(), matrix[:3, 3], seed, 0.001), pose(matrix))
        for seed, matrix in enumerate((HERE, THERE))
    )
    return paired(one, other, (0, 1), 0.25, PairSettings())


@pytest.mark.parametrize("model", [Model.RIGID, Model.LEVELLED, Model.SIMILARITY])
def test_the_equations_are_the_derivatives_of_the_weighted_squares(tie, model):
    alone = replace(tie, common_std=1e-9)
    one, other = pose(HERE, (0.002, 0.001, -0.003)), pose(THERE)
    right = alone.equations(one, other, model).right

    def half_squares(step):
        poses = (moved_pose(pose, part, model) for pose, part in zip((one, other), np.split(step, 2)))
        return 0.5 * (alone.distances(*poses) ** 2 / alone.variances).sum()

    steps = 1e-6 * np.eye(2 * model.unknowns)
    numeric = [(half_squares(step) - half_squares(-step)) / 2e-6 for step in steps]
    np.testing.assert_allclose(-right, numeric, rtol=1e-3, atol=1e-3 * np.abs(right).max())


def test_scans_that_turn_together_are_not_held(tie):
    one, other = pose(HERE), pose(THERE)
    turn = np.array([0.3, -0.2, 0.9])
    together = np.r_[np.cross(turn, one.position), turn, np.cross(turn, other.position), turn]
    normal = tie.equations(one, other, Model.RIGID).normal

    alone = np.r_[together[:6], np.zeros(6)]
    assert together @ normal @ together < 1e-6 * (alone @ normal @ alone)


def test_the_patches_bring_the_second_scan_back(tie):
    shifted = pose(THERE, (0.004, -0.003, 0.002))
    share = tie.equations(pose(HERE), shifted, Model.RIGID)
    step = np.linalg.solve(share.normal[6:, 6:], share.right[6:])

    np.testing.assert_allclose(step[:3], (-0.004, 0.003, -0.002), atol=0.001)
    np.testing.assert_allclose(step[3:], 0.0, atol=0.0005)


def test_however_many_patches_leave_the_error_that_they_share(tie):
    many = replace(tie, variances=tie.variances / 1e6)
    normal = many.equations(pose(HERE), pose(THERE), Model.RIGID).normal[6:, 6:]
    least = np.sqrt(np.linalg.eigvalsh(np.linalg.inv(normal)[:3, :3]))

    assert least.min() > 0.99 * tie.common_std


def test_however_many_patches_leave_the_error_of_the_scale_that_they_share(tie):
    many = replace(tie, variances=tie.variances / 1e4)
    normal = many.equations(pose(HERE), pose(THERE), Model.SIMILARITY).normal[7:, 7:]
    arms = tie.centres[0] - tie.centres[0].mean(axis=0)
    radius = np.sqrt((arms**2).sum(axis=1).mean())

    assert np.sqrt(np.linalg.inv(normal)[-1, -1]) == pytest.approx(tie.common_std / radius, rel=0.05)


def test_a_corridor_leaves_its_axis_free_and_a_room_nothing():
    corridor = np.repeat([[0, 1.0, 0], [0, 0, 1.0]], 40, axis=0)
    (axis,) = free_directions(corridor, 0.02)

    np.testing.assert_allclose(np.abs(axis), [1, 0, 0], atol=1e-12)
    assert not len(free_directions(np.r_[corridor, [[1.0, 0, 0]] * 10], 0.02))
