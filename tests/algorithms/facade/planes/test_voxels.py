"""Points in cubes: each surface counts by its area, in any order of the points."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.planes.settings import VoxelSettings
from ichnograph.algorithms.facade.planes.voxels import make_voxels, square_means
from ichnograph.tests.algorithms.facade.samples import upright


def test_a_densely_scanned_part_has_no_more_cubes_than_a_sparse_one():
    dense, sparse = upright(2, 2, step=0.01), upright(2, 2, step=0.04) + (2, 0, 0)
    centres = make_voxels(np.concatenate([dense, sparse]), 0.1).centres

    assert np.sum(centres[:, 0] < 2) == pytest.approx(np.sum(centres[:, 0] > 2), rel=0.1)


def test_a_centre_is_the_mean_of_the_points_of_its_cube():
    xyz = upright(1, 1)
    voxels = make_voxels(xyz, 0.2)

    for cube in (0, len(voxels.centres) - 1):
        np.testing.assert_allclose(voxels.centres[cube], xyz[voxels.of_point == cube].mean(axis=0))


def test_normals_are_those_of_the_wall():
    normals = make_voxels(upright(2, 2), 0.1).normals
    assert np.abs(normals @ (0, 1, 0)).min() > 0.99


def test_cubes_grow_until_there_are_not_too_many():
    voxels = make_voxels(upright(2, 2), 0.02, VoxelSettings(most_cubes=300))

    assert 100 < len(voxels.centres) <= 300
    assert voxels.size > 0.02


def test_the_order_of_the_points_changes_no_cube():
    xyz = upright(1, 1)
    order = np.random.default_rng(0).permutation(len(xyz))
    voxels, shuffled = make_voxels(xyz, 0.1), make_voxels(xyz[order], 0.1)

    np.testing.assert_array_equal(shuffled.of_point, voxels.of_point[order])
    np.testing.assert_allclose(shuffled.centres, voxels.centres)


def test_squares_have_the_means_of_their_points():
    points = np.array([(0.1, 0.1), (0.3, 0.1), (1.2, 0.4), (-0.5, 2.5)])
    means = square_means(points, 1.0)

    assert sorted(map(tuple, means.round(6))) == [(-0.5, 2.5), (0.2, 0.1), (1.2, 0.4)]
