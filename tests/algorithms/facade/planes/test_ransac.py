"""The plane with most points is found among others, and fitted to its own points only."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.planes.ransac import best_plane, refit
from ichnograph.tests.algorithms.facade.samples import upright

DISTANCE = 0.05


def facing_south(count):
    return np.tile((0.0, -1.0, 0.0), (count, 1))


def test_of_two_planes_the_one_with_more_points_is_found():
    large, small = upright(3, 2, step=0.1), upright(1, 1, w=0.5, step=0.1)
    xyz = np.concatenate([large, small])
    normal, anchor = best_plane(xyz, facing_south(len(xyz)), DISTANCE, 0)

    assert abs(normal @ (0, 1, 0)) > 0.999
    assert (anchor @ normal) * normal[1] == pytest.approx(0, abs=0.02)


def test_points_that_face_another_way_do_not_vote():
    large, small = upright(3, 2, step=0.1), upright(1, 1, w=0.5, step=0.1)
    normals = np.concatenate([np.tile((0.0, 0.0, 1.0), (len(large), 1)), facing_south(len(small))])
    normal, anchor = best_plane(np.concatenate([large, small]), normals, DISTANCE, 0)

    assert abs(normal @ (0, 1, 0)) > 0.999
    assert anchor[1] == pytest.approx(-0.5, abs=0.01)


def test_two_points_have_no_plane():
    assert best_plane(np.zeros((2, 3)), facing_south(2), DISTANCE, 0) is None


def test_the_same_seed_gives_the_same_plane():
    xyz = upright(3, 2, step=0.1, noise=0.01)
    first, second = (best_plane(xyz, facing_south(len(xyz)), DISTANCE, 7) for _ in range(2))
    np.testing.assert_array_equal(first, second)


def test_a_fit_ends_on_the_plane_from_an_approximate_one():
    xyz = upright(3, 2, noise=0.002)
    approximate = np.array([0.0, -np.cos(0.01), np.sin(0.01)])
    normal, anchor = refit(xyz, approximate, xyz[0], 0.04)

    assert normal @ (0, -1, 0) > np.cos(1e-4)
    assert anchor[1] == pytest.approx(0, abs=1e-4)


def test_points_beyond_three_standard_deviations_do_not_pull_the_plane():
    wall, poster = upright(3, 2, noise=0.001), upright(0.5, 0.5, w=0.015, noise=0.001)
    xyz = np.concatenate([wall, poster + (0, 0, 1.5)])
    normal, anchor = refit(xyz, np.array([0.0, -1.0, 0.0]), np.zeros(3), 0.02)

    assert normal @ (0, -1, 0) > np.cos(1e-4)
    assert anchor[1] == pytest.approx(0, abs=1e-4)
    assert abs(xyz.mean(axis=0)[1]) > 3e-4


def test_the_side_of_the_normal_is_kept():
    for side in (-1.0, 1.0):
        normal, _ = refit(upright(2, 2), np.array([0.0, side, 0.0]), np.zeros(3), 0.02)
        assert normal[1] == pytest.approx(side)


def test_fewer_than_three_points_leave_the_plane_as_it_is():
    normal, anchor = np.array([0.0, 1.0, 0.0]), np.array([1.0, 2.0, 3.0])
    found = refit(np.full((2, 3), 2.0), normal, anchor, 0.02)
    np.testing.assert_array_equal(found, (normal, anchor))
