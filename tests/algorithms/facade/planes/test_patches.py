"""Planes with their extent: connected, one after the other, the largest first."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.planes.patches import extract, make_patch
from ichnograph.algorithms.facade.planes.settings import PlaneSettings
from ichnograph.algorithms.facade.planes.voxels import make_voxels
from ichnograph.tests.algorithms.facade.samples import upright

DISTANCE = 0.05
SOUTH = np.array([0.0, -1.0, 0.0])


def patches_of(*parts, settings=PlaneSettings()):
    return extract(make_voxels(np.concatenate(parts), DISTANCE), DISTANCE, settings)


def test_planes_come_by_their_area():
    found = patches_of(upright(1, 1, w=0.5), upright(3, 2))
    assert [round(patch.area, 1) for patch in found] == pytest.approx([6, 1], rel=0.15)


def test_no_more_planes_are_taken_than_asked_for_and_no_smaller_ones():
    parts = upright(3, 2), upright(1, 1, w=0.5)

    assert len(patches_of(*parts, settings=PlaneSettings(most_planes=1))) == 1
    assert len(patches_of(*parts, settings=PlaneSettings(smallest_m2=2.0))) == 1


def test_a_door_does_not_divide_a_wall_but_a_street_between_two_houses_does():
    door = patches_of(upright(2, 2), upright(2, 2) + (2.8, 0, 0))
    street = patches_of(upright(2, 2), upright(2, 2) + (6, 0, 0))

    assert len(door) == 1
    assert len(street) == 2


def test_a_patch_covers_what_is_in_front_of_it_and_nothing_far_beside_it():
    patch = make_patch(SOUTH, np.zeros(3), upright(2, 2), 0.25, 4.0)
    covered = patch.covers(np.array([(1, 5, 1), (1, -5, 1), (4, 0, 1), (1, 0, 4)], float))

    np.testing.assert_array_equal(covered, [True, True, False, False])


def test_heights_are_signed_distances():
    patch = make_patch(SOUTH, np.zeros(3), upright(2, 2), 0.25, 4.0)
    np.testing.assert_allclose(patch.heights(np.array([(7, -2, 3), (0, 0.5, 0)])), (2, -0.5))


def test_a_flipped_patch_has_the_same_extent_and_the_other_normal():
    patch = make_patch(SOUTH, np.zeros(3), upright(2, 1), 0.25, 2.0)
    flipped = patch.flipped()
    xyz = np.random.default_rng(0).uniform(-3, 5, (500, 3))

    np.testing.assert_array_equal(flipped.normal, -patch.normal)
    np.testing.assert_array_equal(flipped.covers(xyz), patch.covers(xyz))


def test_axes_are_level_and_upwards_along_the_plane():
    level, up = make_patch(SOUTH, np.zeros(3), upright(2, 1), 0.25, 2.0).axes
    np.testing.assert_allclose(np.abs(level), (1, 0, 0), atol=1e-12)
    np.testing.assert_allclose(np.abs(up), (0, 0, 1), atol=1e-12)
