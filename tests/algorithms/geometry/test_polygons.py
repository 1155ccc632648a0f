"""Outlines stay polygons where their rings cross."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.polygons import box_sides, faces_of, polygons_between
from shapely.affinity import rotate
from shapely.geometry import Point, box

ORIGIN = (412_000.0, 5_812_000.0)
AROUND = box(-10, -10, 10, 10)


def test_a_hole_within_its_ring_is_a_hole_in_world_coordinates():
    rings = [(0, 0), (4, 0), (4, 3), (0, 3)], [(1, 1), (3, 1), (3, 2), (1, 2)]
    (polygon,) = polygons_between(rings, ORIGIN, Point(ORIGIN).buffer(10))
    assert polygon.bounds == (412_000, 5_812_000, 412_004, 5_812_003)
    assert polygon.area == pytest.approx(10)


def test_the_faces_of_a_thin_wall_that_cross_leave_it_whole():
    outer = [(0, 0), (6, 0), (6, 4), (0, 4)]
    inner = [(0.01, 0.01), (0.01, 4.02), (5.99, 3.98), (5.99, 0.01)]
    (polygon,) = polygons_between((outer, inner), (0, 0), AROUND)
    assert polygon.geom_type == "Polygon" and len(polygon.interiors) == 1
    assert polygon.exterior.length == pytest.approx(20, abs=0.1)


def test_a_ring_that_crosses_itself_loses_the_loop():
    ring = [(0, 0), (4, 0), (4, 3), (3.9, 3.1), (4.0, 3.1), (3.9, 3), (0, 3)]
    (polygon,) = polygons_between((ring,), (0, 0), AROUND)
    assert polygon.is_valid and polygon.geom_type == "Polygon"
    assert polygon.area == pytest.approx(12, abs=0.1)


def test_segments_that_meet_at_their_ends_enclose_faces():
    corners = np.array([(0, 0), (2, 0), (2, 1), (0, 1)], float)
    around = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
    loose = np.array([[(2, 1), (5, 5)]], float)
    faces = faces_of(np.concatenate([around, around[:3] + 10, loose, corners[None, [0, 2]]]))
    assert sorted(face.area for face in faces) == [1, 1]


def test_of_no_segments_there_are_no_faces():
    assert faces_of(np.empty((0, 2, 2))) == []


def test_of_nothing_there_is_no_polygon():
    assert polygons_between(([(0, 0), (1, 1)],), (0, 0), AROUND) == []


def test_what_lies_outside_is_cut_off_and_parts_far_apart_stay_two():
    ring = [(0, 0), (4, 0), (4, 0.3), (0, 0.3)]
    seen = box(0, 0, 1.5, 1).union(box(2.5, 0, 4, 1)).union(box(1.9, 0, 1.95, 0.05))
    first, second = polygons_between((ring,), (0, 0), seen)
    assert first.area == second.area == pytest.approx(0.45)


def test_parts_near_each_other_are_bridged():
    ring = [(0, 0), (4, 0), (4, 0.3), (0, 0.3)]
    (polygon,) = polygons_between((ring,), (0, 0), box(0, 0, 2, 1).union(box(2.1, 0, 4, 1)))
    assert polygon.area == pytest.approx(1.2, abs=0.03)


def test_the_sides_of_a_box_do_not_depend_on_its_rotation():
    assert box_sides(rotate(box(0, 0, 4, 1), 33)) == pytest.approx((1, 4))
