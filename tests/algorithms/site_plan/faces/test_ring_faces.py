"""The faces along a ring, in its order."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.curves import Arc, Line
from ichnograph.algorithms.site_plan.faces.ring_faces import find_faces
from ichnograph.algorithms.site_plan.faces.settings import FaceSettings, RingSettings
from ichnograph.tests.algorithms.site_plan.faces.voxels import PIXEL, WALL, pixel_ring, voxels_of
from shapely.geometry import Point, box


def test_a_wall_has_two_long_faces_and_two_ends():
    ring = find_faces(pixel_ring(WALL), voxels_of(WALL), PIXEL)
    assert sorted(round(face.length, 1) for face in ring.faces) == [0.3, 0.3, 5.0, 5.0]
    assert all(isinstance(face.curve, Line) for face in ring.faces)
    assert not ring.closed


def test_the_wall_is_to_the_left_of_its_faces():
    ring = find_faces(pixel_ring(WALL), voxels_of(WALL), PIXEL)
    middle = np.array([4.5, 2.15])
    assert all(face.curve.offset(middle) > 0.1 for face in ring.faces)


def test_faces_follow_each_other_along_the_ring():
    ring = find_faces(pixel_ring(WALL), voxels_of(WALL), PIXEL)
    members = np.concatenate([face.members for face in ring.faces])
    assert (np.diff(members) > 0).all()


def test_a_round_column_is_a_single_closed_face():
    column = Point(5, 5).buffer(1.0, 64)
    ring = find_faces(pixel_ring(column), voxels_of(column), PIXEL)
    (face,) = ring.faces
    assert ring.closed
    assert isinstance(face.curve, Arc)
    assert face.curve.radius == pytest.approx(1.0, abs=0.003)
    assert face.curve.sense == 1


@pytest.mark.parametrize(("gap_m", "faces"), [(0.4, 1), (0.1, 2)])
def test_a_face_continues_behind_what_hides_less_than_the_gap(gap_m, faces):
    voxels = voxels_of(WALL)
    seen = np.abs(voxels.xy[:, 0] - 4.5) > 0.15
    shown = type(voxels)(
        *(getattr(voxels, name)[seen] for name in ("xy", "level", "count", "square")),
        voxels.columns,
        voxels.levels,
    )
    settings = FaceSettings(rings=RingSettings(gap_m=gap_m))
    ring = find_faces(pixel_ring(WALL), shown, PIXEL, settings)
    south = [face for face in ring.faces if face.curve.heading(face.ridge[0])[0] > 0.9]
    assert len(south) == faces


def test_where_nothing_was_seen_there_are_no_faces():
    ring = find_faces(pixel_ring(WALL), voxels_of(box(20, 20, 22, 20.3)), PIXEL)
    assert ring.faces == ()
