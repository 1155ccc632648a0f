"""Walls behind the faces that bound rooms."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.walls.wall_bodies import behind, between, wall_bodies
from shapely.geometry import Polygon, box
from shapely.ops import unary_union


def faces_of(rooms):
    """Return the borders of rooms as faces, the solid to the left; shape (n, 4)."""
    found = []
    for room in rooms:
        corners = np.asarray(Polygon(room.exterior).exterior.coords)
        corners = corners if not room.exterior.is_ccw else corners[::-1]
        found.append(np.hstack([corners[:-1], corners[1:]]))
    return np.concatenate(found)


def bodies_between(*rooms):
    solid = box(-2, -2, 12, 12).difference(unary_union(rooms))
    return wall_bodies(faces_of(rooms), solid)


def test_a_wall_of_two_faces_fills_what_is_between_them():
    (body,) = bodies_between(box(0, 0, 4, 3), box(4.2, 0, 8, 3))
    assert body.contains(box(4.01, 0.01, 4.19, 2.99))


def test_a_deep_solid_gives_a_strip_along_each_face():
    bodies = bodies_between(box(0, 0, 4, 3), box(6, 0, 8, 3))
    assert len(bodies) == 2
    assert not any(body.intersects(box(4.1, 0, 5.9, 3)) for body in bodies)


def test_bodies_share_no_area_with_rooms_or_each_other():
    rooms = box(0, 0, 4, 3), box(4.2, 0, 8, 3), box(0, 3.1, 8, 6)
    bodies = bodies_between(*rooms)
    assert unary_union(bodies).intersection(unary_union(rooms)).area < 1e-3
    assert sum(body.area for body in bodies) == pytest.approx(unary_union(bodies).area, abs=1e-9)


def test_the_cross_of_four_rooms_is_filled():
    rooms = [box(x, y, x + 3, y + 3) for x in (0, 3.2) for y in (0, 3.2)]
    (body,) = bodies_between(*rooms)
    assert body.contains(box(3.01, 3.01, 3.19, 3.19))


def test_a_closet_between_walls_is_not_filled():
    around = [box(0, 0, 4, 3), box(4.1, 0, 5, 1.2), box(0, 3.1, 5, 6), box(5.1, 0, 8, 6), box(0, -3, 8, -0.1)]
    rooms = [*around, box(4.1, 1.3, 5, 3)]
    assert unary_union(bodies_between(*rooms)).intersection(unary_union(rooms)).area < 0.01
    assert not any(body.contains(box(4.2, 0.2, 4.9, 1.1)) for body in bodies_between(*rooms))


def test_a_column_in_a_room_is_a_body_of_its_own():
    column = box(1.8, 1.3, 2.2, 1.7)
    rim = np.asarray(column.exterior.coords)
    rim = rim if column.exterior.is_ccw else rim[::-1]
    faces = np.vstack([faces_of([box(0, 0, 4, 3)]), np.hstack([rim[:-1], rim[1:]])])
    solid = box(-2, -2, 12, 12).difference(box(0, 0, 4, 3).difference(column))
    found = [body for body in wall_bodies(faces, solid) if body.intersects(column)]
    assert [body.symmetric_difference(column).area for body in found] == pytest.approx([0], abs=1e-3)


def test_behind_is_to_the_left_and_meets_in_corners():
    outer = behind(np.array([[0, 0, 2, 0], [2, 0, 2, -2]], float), 0.1)
    assert outer.contains(box(0.01, 0.01, 1.99, 0.09))
    assert outer.contains(box(2.01, -1.9, 2.09, 0.09))
    assert not outer.intersects(box(0, -1, 1.9, -0.01))


def test_between_needs_faces_that_turn_their_backs_to_each_other():
    facing = np.array([[0, 0, 2, 0], [2, 0.3, 0, 0.3]], float)
    assert between(facing, 0.6).area == pytest.approx(0.6, abs=1e-6)
    assert between(facing, 0.1).area == 0
    assert between(facing[:, [2, 3, 0, 1]], 0.6).area == 0


def test_without_faces_there_are_no_walls():
    assert wall_bodies(np.zeros((0, 4)), box(0, 0, 1, 1)) == []
