"""The points near walls are gathered from the sorted cloud, thinned to voxels."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.site_plan.density.density_image import sort_and_image
from ichnograph.algorithms.site_plan.faces.face_points import gather_face_points
from ichnograph.algorithms.site_plan.faces.settings import FacePointSettings
from ichnograph.tests.processing_provider.room import CORNER, room_points, write_las


def gathered(paths, walls_of=lambda image: image.occupied >= 0.4):
    with sort_and_image(open_cloud(paths)) as (image, points):
        near = gather_face_points(points, image, walls_of(image))
    origin = np.array([image.transform.c, image.transform.f - 0.1 * image.density.shape[0]])
    return near, near.xy + origin


def test_the_same_voxels_in_any_order_and_cut_into_files(tmp_path):
    points = np.random.default_rng(0).permutation(room_points())
    write_las(tmp_path / "whole.las", room_points())
    write_las(tmp_path / "one.las", points[:7000])
    write_las(tmp_path / "other.las", points[7000:])
    whole, _ = gathered([tmp_path / "whole.las"])
    cut, _ = gathered([tmp_path / "one.las", tmp_path / "other.las"])
    for name in ("xy", "level", "count", "square"):
        np.testing.assert_array_equal(getattr(whole, name), getattr(cut, name))


def test_only_points_near_walls_and_within_the_heights_are_gathered(tmp_path):
    write_las(tmp_path / "room.las", room_points())
    near, xy = gathered([tmp_path / "room.las"])
    from_walls = np.abs(xy - CORNER[:2] - (4, 3)) - (3, 2)
    assert np.abs(from_walls).min(axis=1).max() < 0.5
    up = room_points()[:, 2] - CORNER[2]
    assert near.count.sum() == np.count_nonzero((up >= 0.3) & (up < 2.3))
    assert near.level.min() == 0 and near.level.max() == FacePointSettings().levels - 1


def test_a_voxel_is_the_mean_of_its_points(tmp_path):
    post = np.array([[1.001, 1.002, 1.0], [1.003, 1.008, 1.01], [1.3, 1.0, 1.0]])
    floor = np.array([[x, y, 0.0] for x in np.arange(0, 4, 0.1) for y in np.arange(0, 4, 0.1)])
    write_las(tmp_path / "post.las", np.concatenate([post, floor]) + CORNER)
    near, xy = gathered([tmp_path / "post.las"], lambda image: image.occupied > 0)
    assert sorted(near.count) == [1, 2]
    assert xy[near.count == 2][0] - CORNER[:2] == pytest.approx((1.002, 1.005), abs=1e-5)


def test_of_a_horizontal_slice_all_heights_are_taken(tmp_path):
    points = room_points()
    up = points[:, 2] - CORNER[2]
    write_las(tmp_path / "slice.las", points[(up > 1.0) & (up < 1.2)])
    near, _ = gathered([tmp_path / "slice.las"], lambda image: image.density > 0)
    assert near.count.sum() == np.count_nonzero((up > 1.0) & (up < 1.2))
    assert len(np.unique(near.level)) > 3
    assert near.flat


def test_what_is_near_a_place_is_found_by_squares(tmp_path):
    write_las(tmp_path / "room.las", room_points())
    near, _ = gathered([tmp_path / "room.las"])
    place = near.xy[:1]
    rows = near.near(place)
    distance = np.hypot(*(near.xy - place).T)
    assert set(np.flatnonzero(distance < 0.25)) <= set(rows)
    assert distance[rows].max() < 0.75
