"""A face is fitted to the voxels beside stations of a ring."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.faces.face import Face, fit_face
from ichnograph.algorithms.site_plan.faces.face_points import face_points
from ichnograph.algorithms.site_plan.faces.ridges import Ridges
from ichnograph.algorithms.site_plan.faces.settings import FaceExtentSettings, FaceSettings

STATIONS = np.arange(2.0, 6.0, 0.05)
RIDGE = np.column_stack([STATIONS, np.full(len(STATIONS), 3.0)])
RIDGES = Ridges(np.ones(len(RIDGE), bool), RIDGE, np.tile([1.0, 0.0], (len(RIDGE), 1)))
MEMBERS = np.arange(len(RIDGE))


def voxels(east, scatter=0.002, levels=40, count=8000, seed=0):
    """Return voxels about the line y = 3, from x to x."""
    random = np.random.default_rng(seed)
    xy = np.column_stack([random.uniform(*east, count), 3 + random.normal(0, scatter, count)])
    return face_points(xy, random.integers(0, levels, count), np.ones(count, np.int64))


def test_a_face_lies_on_its_voxels_and_ends_where_they_do():
    face = fit_face(MEMBERS, False, RIDGES, voxels((1.95, 6.05)))
    assert face.curve.at(np.array([face.start, face.stop])) == pytest.approx(
        np.array([[1.95, 3.0], [6.05, 3.0]]), abs=0.01
    )
    assert face.rms == pytest.approx(0.002, rel=0.2)
    assert face.seen == 1.0 and not face.hidden


def test_a_lintel_beyond_the_end_of_a_wall_does_not_lengthen_its_face():
    wall, lintel = voxels((2, 6)), voxels((6, 6.15), levels=4, count=100)
    both = face_points(
        np.concatenate([wall.xy, lintel.xy]),
        np.concatenate([wall.level, lintel.level]),
        np.concatenate([wall.count, lintel.count]),
    )
    face = fit_face(MEMBERS, False, RIDGES, both)
    assert face.curve.at(face.stop)[0] == pytest.approx(6.0, abs=0.03)


def test_a_bush_is_not_a_face():
    assert fit_face(MEMBERS, False, RIDGES, voxels((2, 6), scatter=0.08)) is None


def test_a_rough_face_is_one_unless_there_are_points_before_it():
    rough = voxels((2, 6), scatter=0.019)
    assert fit_face(MEMBERS, False, RIDGES, rough) is not None
    before = np.column_stack([np.random.default_rng(1).uniform(2, 6, 4000), np.full(4000, 2.93)])
    both = face_points(
        np.concatenate([rough.xy, before]),
        np.concatenate([rough.level, np.arange(4000) % 40]),
        np.ones(12_000, np.int64),
    )
    assert fit_face(MEMBERS, False, RIDGES, both) is None


def test_a_face_shorter_than_the_settings_allow_is_left_out():
    choosy = FaceSettings(extent=FaceExtentSettings(shortest_m=5.0))
    assert fit_face(MEMBERS, False, RIDGES, voxels((2, 6)), choosy) is None


def test_the_share_of_stations_with_a_ridge():
    face = Face(None, np.array([3, 4, 6, 12]), RIDGE[:4], 1.0, 3.5, 0.002)
    assert face.seen == pytest.approx(0.4)
    assert face.length == pytest.approx(2.5)
