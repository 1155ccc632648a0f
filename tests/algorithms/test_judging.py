"""The judge of plans of simulated scenes: the truth is faultless, and known faults are what it says."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.judging import (
    closed_spaces,
    phantom_length,
    room_errors,
    seen_share,
    thickness_errors,
)
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, MultiPolygon, box
from shapely.ops import unary_union

ROOM = MultiPolygon([box(0, 0, 8, 6).difference(box(0.3, 0.3, 7.7, 5.7)).difference(box(4, -1, 5, 1))])
"""A room with a door."""


@pytest.mark.parametrize("name", sorted(SCENES))
def test_the_true_walls_of_every_scene_are_faultless(name):
    truth = SCENES[name](2).truth
    errors = thickness_errors(truth, truth, truth.boundary)
    assert len(errors) > 50
    assert np.abs(errors).max() < 1e-6
    rooms = room_errors(truth, truth, truth.boundary)
    assert max(rooms, default=0.0) == 0.0
    assert phantom_length(truth, truth) == 0.0


@pytest.mark.parametrize(("name", "rooms"), [("interior", 6), ("rooms", 5), ("yard", 1), ("terraces", 2)])
def test_rooms_are_what_walls_and_doors_enclose(name, rooms):
    truth = SCENES[name](0).truth
    assert len(room_errors(truth, truth, truth.boundary)) >= rooms


@settings(max_examples=15, deadline=None)
@given(st.integers(-20, 30), st.integers(0, 359), st.tuples(*[st.integers(-(10**6), 10**6)] * 2))
def test_a_wall_that_is_too_thick_is_too_thick_by_as_much(millimetres, angle, shift):
    truth = translate(rotate(ROOM, angle), *shift)
    walls = truth.buffer(millimetres / 2000, join_style=2)
    errors = thickness_errors(walls, truth, truth.boundary)
    assert np.median(errors) == pytest.approx(millimetres / 1000, abs=1e-5)
    (room,) = room_errors(walls, truth, truth.boundary)
    off = millimetres / 1000
    assert room == pytest.approx(abs((7.4 - off) * (5.4 - off) / (7.4 * 5.4) - 1), abs=5e-4)


def test_a_wall_seen_from_one_side_has_no_thickness_to_judge():
    inner = box(0.2, 0.2, 7.8, 5.8)
    assert len(thickness_errors(ROOM, ROOM, ROOM.boundary.intersection(inner))) == 0


def test_a_room_that_was_not_seen_all_around_is_not_asked_for():
    seen = ROOM.boundary.difference(box(7, 0, 9, 6))
    assert room_errors(ROOM, ROOM, seen) == []


def test_a_room_whose_wall_is_missing_is_lost():
    walls = ROOM.difference(box(7, 1, 9, 5))
    assert room_errors(walls, ROOM, ROOM.boundary) == [1.0]


def test_a_door_is_bridged_for_the_room_but_a_gate_is_not():
    (room,) = closed_spaces(ROOM, 1.3)
    # Its corners are rounded, and the circle that rounds them reaches into the door.
    assert room.area == pytest.approx(7.4 * 5.4, rel=0.02)
    assert closed_spaces(ROOM.difference(box(3, -1, 6, 1)), 1.3) == []


def test_a_phantom_is_as_long_as_its_longest_side_but_for_what_is_close():
    cupboard = rotate(box(2, 2, 3.5, 2.5), 30)
    thick = box(-0.15, 0, 0.1, 6)
    assert phantom_length(unary_union([ROOM, cupboard, thick]), ROOM) == pytest.approx(1.5)
    bush = LineString([(7, 2), (7.4, 2)]).buffer(0.3)
    assert 0.3 < phantom_length(ROOM.union(bush), ROOM) < 0.9


@pytest.mark.parametrize("east, share", [(4.0, 1.0), (2.0, 0.5), (0.0, 0.0)])
def test_a_room_is_seen_as_far_as_points_lie_in_it_at_any_height(east, share):
    x, y = np.meshgrid(np.arange(0.05, 4.0, 0.1), np.arange(0.05, 3.0, 0.1))
    points = np.column_stack([x.ravel(), y.ravel(), (7 * x.ravel()) % 2.5])
    assert seen_share(box(0, 0, 4, 3), points[points[:, 0] < east]) == pytest.approx(share, abs=0.05)
