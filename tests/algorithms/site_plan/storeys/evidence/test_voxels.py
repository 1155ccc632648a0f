"""Points as voxels with normals."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.evidence.voxels import PART, make_voxels
from ichnograph.tests.algorithms.site_plan.storeys.scans import flat, room, scanned, upright


def test_a_voxel_holds_the_mean_of_its_points():
    points = np.array([[0.001, 0.001, 0.001], [0.011, 0.013, 0.015], [5.0, 5.0, 5.0]])
    found = make_voxels([points]).xyz
    assert found[0] == pytest.approx([0.006, 0.007, 0.008], abs=1e-6)
    assert len(found) == 2


def test_normals_of_a_floor_are_upright_and_of_a_wall_level():
    voxels = make_voxels([np.concatenate([flat(0, 0, 2, 2, 0.0), upright((5, 0), (5, 2))])])
    floor = voxels.xyz[:, 0] < 3
    assert np.abs(voxels.normal[floor, 2]).min() > 0.99
    assert np.abs(voxels.normal[~floor, 0]).min() > 0.99


def test_spacing_and_noise_are_measured():
    sparse = make_voxels([scanned(room(0, 0, 4, 3, spacing=0.06), noise=0.0)])
    assert sparse.spacing_m == pytest.approx(0.06, rel=0.15)
    noisy = make_voxels([scanned(room(0, 0, 4, 3, spacing=0.02), noise=0.005)])
    assert noisy.noise_m == pytest.approx(0.005, rel=0.25)


def test_what_fills_space_has_no_normal():
    bush = np.random.default_rng(0).uniform(0, 1, (20000, 3))
    voxels = make_voxels([bush])
    inner = np.all((voxels.xyz > 0.2) & (voxels.xyz < 0.8), axis=1)
    assert voxels.normal[inner].any(axis=1).mean() < 0.05


@pytest.mark.parametrize("spacing", [0.05, 0.1])
def test_both_faces_of_a_partition_have_normals_though_points_are_as_far_apart(spacing):
    faces = [upright((0, y), (4, y), spacing=spacing) for y in (0.0, 0.1)]
    rooms = [flat(0, y, 4, y + 3, 0.0, spacing) for y in (-3.0, 0.1)]
    voxels = make_voxels([scanned(*faces, *rooms)])
    on_faces = (voxels.xyz[:, 2] > 0.3) & (voxels.xyz[:, 2] < 2.3)
    assert (np.abs(voxels.normal[on_faces, 1]) > 0.97).mean() > 0.95


def test_a_wall_far_from_the_scanner_has_normals_though_few_points_are_around_each():
    near, far = upright((0, 0), (2, 0), spacing=0.02), upright((8, 0), (12, 0), spacing=0.08)
    voxels = make_voxels([scanned(near, far, flat(0, 0, 2, 0.5, 0.0, 0.02))])
    inside = (voxels.xyz[:, 0] > 8.3) & (voxels.xyz[:, 0] < 11.7)
    inside &= (voxels.xyz[:, 2] > 0.3) & (voxels.xyz[:, 2] < 2.0)
    assert (np.abs(voxels.normal[inside, 1]) > 0.97).mean() > 0.9


def test_reflections_far_away_are_left_out():
    points = np.concatenate([scanned(room(0, 0, 4, 3)), [[900.0, 0.0, 0.0], [0.0, -700.0, 3.0]]])
    assert np.abs(make_voxels([points]).xyz).max() < 5


def test_nothing_gives_nothing():
    assert len(make_voxels([]).xyz) == 0
    assert len(make_voxels([np.zeros((0, 3)), np.zeros((1, 3))]).xyz) == 1


def test_any_division_into_chunks_in_any_order_gives_exactly_the_same_voxels():
    points = scanned(room(0, 0, 2, 2))
    whole = make_voxels([points])
    shuffled = np.random.default_rng(1).permutation(points)
    for chunks in (np.array_split(points, 40), np.array_split(shuffled, 40), [points[:0], points]):
        parts = make_voxels(chunks)
        np.testing.assert_array_equal(parts.xyz, whole.xyz)
        np.testing.assert_array_equal(parts.normal, whole.normal)


def test_voxels_beyond_the_first_part_have_their_own_normals():
    # Threads find the normals in parts.
    voxels = make_voxels([room(0, 0, 5, 4, spacing=0.02)])
    assert len(voxels.xyz) > 2 * PART
    x, y, z = voxels.xyz.T
    inside = (x > 0.3) & (x < 4.7) & (y > 0.3) & (y < 3.7)
    assert np.abs(voxels.normal[inside, 2]).min() > 0.999
    west = (x < 0.01) & (y > 0.3) & (y < 3.7) & (z > 0.3) & (z < 2.3)
    assert np.abs(voxels.normal[west, 0]).min() > 0.999
