"""An outline runs along its faces, and meets corners where they cross."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.faces.face_outline import redraw
from ichnograph.algorithms.site_plan.faces.ring_faces import RingFaces, find_faces
from ichnograph.algorithms.site_plan.faces.settings import FaceOutlineSettings
from ichnograph.tests.algorithms.site_plan.faces.voxels import PIXEL, WALL, pixel_ring, voxels_of
from shapely.geometry import Point, Polygon

RING = find_faces(pixel_ring(WALL), voxels_of(WALL), PIXEL)


def test_four_faces_of_a_wall_meet_at_its_corners():
    corners, faces = redraw(RING, PIXEL)
    assert len(corners) == len(faces) == 4
    assert Polygon(corners).symmetric_difference(WALL).area < 0.005 * WALL.length


def test_faces_whose_ends_cross_are_dropped_the_shortest_first():
    # Without corners, the ends of the short faces reach past the long ones by their scatter.
    corners, faces = redraw(RING, PIXEL, FaceOutlineSettings(corner_gap_m=0.0))
    assert [round(face.length) for face in faces] == [5, 5]
    assert Polygon(corners).symmetric_difference(WALL).area < 0.005 * WALL.length


def test_without_faces_the_outline_of_pixels_is_freed_of_its_bias():
    bare = RingFaces(RING.stations, RING.step, ())
    corners, faces = redraw(bare, PIXEL)
    assert faces == []
    # Its corners are cut by the chords that give the directions.
    assert Polygon(corners).area == pytest.approx(WALL.area, rel=0.05)


def test_a_closed_round_face_is_drawn_as_a_circle_within_the_chord_tolerance():
    column = Point(5, 5).buffer(1.0, 64)
    corners, _ = redraw(find_faces(pixel_ring(column), voxels_of(column), PIXEL), PIXEL)
    radii = np.linalg.norm(corners - 5, axis=1)
    assert radii == pytest.approx(1.0, abs=0.005)
    middles = (corners + np.roll(corners, 1, axis=0)) / 2
    assert (radii.mean() - np.linalg.norm(middles - 5, axis=1)).max() < 0.0021
