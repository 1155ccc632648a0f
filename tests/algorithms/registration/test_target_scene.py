"""The scenes that tests and benchmarks of the registration rely on."""

import numpy as np
import pytest
from ichnograph.tests.scenes.targets import CLEARANCE, CORNER, SIZE, target_scene
from scipy.spatial.distance import pdist


def moved(scene):
    return scene.targets.xyz @ scene.matrix[:3, :3].T + scene.matrix[:3, 3]


@pytest.mark.parametrize("common", [0, 4, 8])
def test_common_targets_are_control_points_and_the_others_are_not(common):
    scene = target_scene(60, 12, common, noise=0.0)
    gaps = np.linalg.norm(moved(scene)[:, None] - scene.control.xyz, axis=2)
    nearest = [scene.control.names[row] for row in gaps.argmin(axis=1)]

    assert len(scene.control.names) == len(scene.control.xyz) == 60
    assert tuple(scene.truth) == scene.targets.names
    assert sum(point is not None for point in scene.truth.values()) == common
    for point, name, gap in zip(scene.truth.values(), nearest, gaps.min(axis=1)):
        assert (gap < 1e-6 and name == point) or (gap > CLEARANCE - 1e-6 and point is None)


def test_places_lie_on_the_building_apart_from_each_other():
    scene = target_scene(200, 20, 0, noise=0.0)
    local = np.concatenate([scene.control.xyz, moved(scene)]) - CORNER

    assert local.min() > -1e-6
    assert (local < SIZE + 1e-6).all()
    assert pdist(local).min() > CLEARANCE - 1e-6


def test_targets_scatter_by_the_noise_and_the_scanner_frame_is_near_its_origin():
    scene = target_scene(400, 400, 400, noise=0.002)
    places = dict(zip(scene.control.names, scene.control.xyz))
    errors = moved(scene) - [places[name] for name in scene.truth.values()]

    assert errors.std(axis=0) == pytest.approx([0.002] * 3, rel=0.15)
    assert np.abs(scene.targets.xyz).max() < 40


@pytest.mark.parametrize(("tilt", "scale"), [(0.0, 1.0), (0.0, 1.5), (None, 0.3048)])
def test_the_pose_is_a_similarity_level_if_asked_for(tilt, scale):
    matrix = target_scene(10, 5, 5, tilt=tilt, scale=scale).matrix

    assert matrix[:3, :3] @ matrix[:3, :3].T == pytest.approx(scale**2 * np.eye(3), abs=1e-12)
    assert np.linalg.det(matrix[:3, :3]) == pytest.approx(scale**3)
    if tilt == 0.0:
        assert matrix[2, :3] == pytest.approx([0, 0, scale])


def test_a_seed_gives_the_same_scene_again_and_another_gives_another():
    first, again, other = (target_scene(20, 8, 5, seed=seed) for seed in (1, 1, 2))

    assert np.array_equal(first.targets.xyz, again.targets.xyz)
    assert first.truth == again.truth
    assert not np.array_equal(first.targets.xyz, other.targets.xyz)
