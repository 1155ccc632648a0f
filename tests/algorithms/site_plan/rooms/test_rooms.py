"""Rooms between walls, and where they end at doors."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.site_plan.rooms.rooms import find_rooms
from ichnograph.algorithms.site_plan.rooms.settings import RoomSettings
from ichnograph.tests.scenes import SCENES
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, Point, Polygon, box
from shapely.ops import unary_union

THICKNESS = 0.3


def house(*doors, width=6.0, depth=4.0, inner=()):
    """Return the walls around a clear room of `width` by `depth`, with more walls inside, less the doors."""
    clear = box(0, 0, width, depth)
    walls = unary_union([clear.buffer(THICKNESS, join_style=2).difference(clear), *inner])
    walls = walls.difference(unary_union(doors)) if doors else walls
    return list(getattr(walls, "geoms", [walls]))


def partition(x, depth=4.0, thickness=THICKNESS):
    return box(x - thickness / 2, 0, x + thickness / 2, depth)


def door(x, width, wall_thickness=THICKNESS):
    """Return the hole for a door through the south wall of a house, its left jamb at `x`."""
    return box(x, -wall_thickness - 0.1, x + width, 0)


def test_a_closed_room_reaches_from_face_to_face():
    (room,) = find_rooms(house())
    assert room.area == pytest.approx(24.0, rel=1e-6)
    assert room.perimeter == pytest.approx(20.0, rel=1e-6)
    assert (room.room_id, room.openings) == (1, 0)


@pytest.mark.parametrize("width", [0.5, 0.9, 1.25])
def test_a_room_ends_at_the_face_of_the_wall_with_the_door(width):
    (room,) = find_rooms(house(door(2.0, width)))
    assert room.area == pytest.approx(24.0, rel=1e-4)
    assert room.outline.symmetric_difference(box(0, 0, 6, 4)).area < 0.01
    assert room.openings == 1


def test_a_gap_wider_than_a_door_opens_the_room():
    walls = house(door(2.0, 1.6))
    assert find_rooms(walls) == ()
    (room,) = find_rooms(walls, RoomSettings(door_width_m=1.7))
    assert room.area == pytest.approx(24.0, rel=1e-4)


def test_a_door_in_the_corner_of_a_room_is_closed_along_the_face():
    (room,) = find_rooms(house(door(0.0, 0.9)))
    assert room.area == pytest.approx(24.0, rel=1e-4)


@pytest.mark.parametrize("left", [0.0, 0.1, 1.5, 3.1])
def test_rooms_joined_by_a_door_are_two_and_the_door_belongs_to_neither(left):
    hole = box(2.0, left, 3.0, left + 0.9)
    east, west = find_rooms(house(inner=[partition(2.5).difference(hole)]))
    assert (east.area, west.area) == pytest.approx((3.35 * 4, 2.35 * 4), rel=1e-4)
    assert (east.openings, west.openings) == (1, 1)


def test_two_doors_between_two_rooms_are_two_openings_of_each():
    holes = unary_union([box(2, 0.5, 3, 1.4), box(2, 2.5, 3, 3.4)])
    rooms = find_rooms(house(door(0.5, 0.9), inner=[partition(2.5).difference(holes)]))
    assert [room.openings for room in rooms] == [2, 3]


def test_a_narrow_corridor_is_not_cut_at_its_doors():
    corridor = [box(0, 4.3 - 0.15, 9, 4.3), box(0, 5.5, 9, 5.65)]
    holes = unary_union([box(x, y, x + 0.8, y + 0.6) for x in (1, 4, 7) for y in (4, 5.3)])
    rooms = find_rooms(house(width=9, depth=9.8, inner=[unary_union(corridor).difference(holes)]))
    assert [room.area for room in rooms] == pytest.approx([9 * 4.15, 9 * 4.15, 9 * 1.2], rel=1e-3)


def test_a_closet_narrower_than_a_door_is_a_room():
    closet = unary_union([box(1.0, 0, 1.1, 4), box(0, 1.5, 1.1, 1.6)]).difference(box(0.9, 0.4, 1.2, 1.1))
    rooms = find_rooms(house(inner=[closet]))
    assert [room.area for room in rooms] == pytest.approx([4.9 * 4, 1.0 * 2.4, 1.0 * 1.5], rel=1e-3)


def test_the_outside_is_no_room_but_a_courtyard_is():
    wing = box(-3, -3, 9, 7).difference(box(-2.7, -2.7, 8.7, 6.7))
    rooms = find_rooms([*house(), wing])
    around = 11.4 * 9.4 - 6.6 * 4.6
    assert [room.area for room in rooms] == pytest.approx([around, 24.0], rel=1e-5)


def test_the_core_of_a_thick_wall_is_no_room():
    shells = [box(0, 0, 6, 4).buffer(t, join_style=2) for t in (0.0, 0.05, 0.7, 0.75)]
    inner, outer = shells[1].difference(shells[0]), shells[3].difference(shells[2])
    assert [room.area for room in find_rooms([inner, outer])] == pytest.approx([24.0], rel=1e-5)


def test_free_columns_are_holes_in_the_floor():
    columns = [box(2, 2, 2.4, 2.4), Point(4, 2).buffer(0.2)]
    (room,) = find_rooms([*house(), *columns])
    assert len(room.outline.interiors) == 2
    assert room.area == pytest.approx(24.0 - sum(column.area for column in columns), rel=1e-5)
    assert room.perimeter == pytest.approx(20.0 + sum(column.length for column in columns), rel=1e-5)


def test_faces_seen_from_one_side_only_bound_a_room():
    strips = [box(0, -0.02, 6, 0), box(0.05, 4, 6, 4.02), box(-0.02, 0.1, 0, 4), box(6, 0, 6.02, 3.9)]
    (room,) = find_rooms(strips)
    assert room.area == pytest.approx(24.0, rel=1e-3)


def test_a_broken_corner_is_closed_from_end_to_end():
    (room,) = find_rooms(house(box(-0.5, -0.5, 0.6, 0.6)))
    assert room.area == pytest.approx(24.0 - 0.6 * 0.6 / 2, rel=2e-3)


@pytest.mark.parametrize("corners", [64, 2000])
def test_a_round_room_keeps_its_curve(corners):
    tower = Point(0, 0).buffer(3.5, corners).difference(Point(0, 0).buffer(3.0, corners))
    (room,) = find_rooms([tower.difference(box(2, -0.45, 4, 0.45))])
    assert room.area == pytest.approx(np.pi * 9, rel=2e-3)
    assert room.openings == 1


def test_open_walls_and_no_walls_bound_no_room():
    assert find_rooms([]) == ()
    assert find_rooms([LineString([(0, 0), (5, 0), (5, 5)]).buffer(0.15)]) == ()


@settings(max_examples=20, deadline=None)
@given(
    angle=st.integers(0, 359),
    east=st.floats(0, 1e6),
    north=st.floats(0, 6e6),
    left_cm=st.integers(0, 290),
    width_cm=st.integers(60, 110),
)
def test_rooms_stay_the_same_wherever_a_site_lies_and_however_it_is_turned(
    angle, east, north, left_cm, width_cm
):
    hole = box(2.0, left_cm / 100, 3.0, (left_cm + width_cm) / 100)
    walls = house(door(0.6, 1.0), inner=[partition(2.5).difference(hole)])
    moved = [translate(rotate(wall, angle, origin=(0, 0)), east, north) for wall in walls]
    rooms = find_rooms(moved)
    assert [room.area for room in rooms] == pytest.approx([3.35 * 4, 2.35 * 4], rel=5e-4)
    assert [room.openings for room in rooms] == [1, 2]


@pytest.mark.parametrize("name", ["interior", "rooms"])
def test_true_walls_give_the_true_areas(name):
    scene = SCENES[name](1).moved(12.0, (412_345.67, 5_812_345.71, 71.3))
    filled = [prism.footprint for prism in scene.prisms if prism.material in ("wall", "lintel")]
    solid = unary_union([footprint.buffer(1e-6, join_style=2) for footprint in filled])
    true = sorted((Polygon(ring).area for ring in solid.interiors), reverse=True)
    assert [room.area for room in find_rooms(scene.truth.geoms)] == pytest.approx(true, rel=1e-3)
