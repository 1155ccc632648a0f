"""Rooms are cut where the line of a wall continues over or under open space."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.rooms.openings import cut_at_openings
from ichnograph.tests.algorithms.site_plan.storeys.drawn import Face, along, divided, footprint_of, sides
from shapely.geometry import box

NONE = np.empty((0, 4))
"""No screens."""

EVERYWHERE = box(-9, -9, 19, 19)
"""A roof."""


def two_rooms(wide=0.9, lintel=21, leaf=0, back=True):
    """Return the faces of two rooms with a partition of 12 cm, and the footprint.

    An opening is so wide, has a lintel from that level up, and is filled by a leaf up to another one.
    """
    low, high = 1.5 - wide / 2, 1.5 + wide / 2
    faces = [*sides(0, 0, 4, 3)[:1], *sides(0, 0, 4, 3)[2:], *sides(4.12, 0, 8, 3)[:3]]
    for x in (4, 4.12):
        faces += [Face((x, 0), (x, low)), Face((x, high), (x, 3)), Face((x, low), (x, high), lintel, 26)]
    faces += [Face((4, y), (4.12, y), 0, lintel) for y in (low, high)]
    if leaf:
        faces.append(Face((4, low), (4, high), 0, leaf))
    east = (4.12, 0, 8, 3) if back else (4.12, low, 4.7, high)
    return faces, footprint_of((0, 0, 4, 3), (4, low, 4.12, high), east)


def parts_of(faces, footprint):
    found = cut_at_openings(divided(faces, footprint), NONE, EVERYWHERE, along(*faces))
    return sorted(found.outlines, key=lambda part: -part.area), found


def large(parts):
    return [round(part.area, 1) for part in parts if part.area > 1]


def test_a_door_with_a_lintel_parts_two_rooms_and_is_a_part_of_its_own():
    parts, found = parts_of(*two_rooms())
    assert large(parts) == [12.0, 11.6]
    assert parts[2].symmetric_difference(box(4, 1.05, 4.12, 1.95)).area < 0.01
    assert not any(found.over_sill)


def test_without_a_lintel_the_space_is_one():
    parts, _ = parts_of(*two_rooms(lintel=26))
    assert large(parts) == [pytest.approx(23.7, abs=0.1)]


def test_what_is_wider_than_a_door_is_open():
    parts, _ = parts_of(*two_rooms(wide=2.7))
    assert large(parts) == [pytest.approx(24.0, abs=0.1)]


def test_a_closed_leaf_parts_two_rooms():
    parts, _ = parts_of(*two_rooms(leaf=21))
    # The opening before the leaf belongs to one of them.
    assert sorted(large(parts)) == pytest.approx([11.6, 12.0], abs=0.12)
    assert sum(large(parts)) == pytest.approx(23.7, abs=0.1)


def room_with_window(sill=9, head=22):
    """Return a room with the niche of a window, 24 cm deep, over a sill."""
    south = [Face((0, 0), (1, 0)), Face((2.2, 0), (4, 0)), Face((1, 0), (2.2, 0), 0, sill)]
    south += [Face((1, 0), (2.2, 0), head, 26), Face((1, -0.24), (2.2, -0.24), sill, head)]
    south += [Face((x, -0.24), (x, 0), sill, head) for x in (1, 2.2)]
    return [*south, *sides(0, 0, 4, 3)[1:]], footprint_of((0, 0, 4, 3), (1, -0.24, 2.2, 0))


def test_a_niche_over_a_sill_and_below_a_head_is_cut_off():
    parts, found = parts_of(*room_with_window())
    assert [part.area for part in parts] == pytest.approx([12, 0.288], abs=0.005)
    # The sill parts the room from the niche: both lie beside it.
    assert list(found.over_sill) == [True, True]


def test_a_window_down_to_the_floor_has_no_sill():
    parts, found = parts_of(*room_with_window(sill=0))
    assert len(parts) == 2
    assert not any(found.over_sill)


def test_a_room_without_openings_is_one_part():
    faces = sides(0, 0, 4, 3)
    parts, found = parts_of(faces, footprint_of((0, 0, 4, 3)))
    assert [part.area for part in parts] == pytest.approx([12])
    assert list(found.over_sill) == [False]


def test_a_cupboard_before_a_wall_cuts_nothing_off():
    front = [
        Face((1, 0.6), (2.5, 0.6), 0, 20),
        Face((1, 0), (1, 0.6), 0, 20),
        Face((2.5, 0), (2.5, 0.6), 0, 20),
    ]
    parts, _ = parts_of([*sides(0, 0, 4, 3), *front], footprint_of((0, 0, 4, 3)))
    assert [part.area for part in parts] == pytest.approx([12])


@pytest.mark.parametrize("wide, count", [(1.0, 2), (3.4, 1)], ids=["a door", "an open end"])
def test_a_screen_parts_a_room_if_the_rest_of_its_line_is_a_door(wide, count):
    screen, lintel = Face((2, wide), (2, 5)), Face((2, 0), (2, wide), 21)
    faces = [*sides(0, 0, 4, 5), screen, lintel]
    division = divided(faces, footprint_of((0, 0, 4, 5)))
    # It is measured to a hand before the wall.
    found = cut_at_openings(division, np.array([[2, wide, 2, 4.86]]), EVERYWHERE, along(*faces))
    assert len(found.outlines) == count
    assert sum(part.area for part in found.outlines) == pytest.approx(20)


@pytest.mark.parametrize("roof, area", [(box(0, 0, 4, 4.3), 16), (EVERYWHERE, 25)], ids=["a yard", "a hall"])
def test_a_wide_gate_parts_a_room_only_from_what_lies_under_no_roof(roof, area):
    # The gate has no lintel; the foot of its leaf was seen.
    front = [Face((0, 4), (0.5, 4)), Face((3.5, 4), (4, 4)), Face((0.5, 4), (3.5, 4), 0, 4)]
    jambs = [Face((x, 4), (x, 4.3)) for x in (0.5, 3.5)]
    faces = [*sides(0, 0, 4, 4)[:2], *sides(0, 0, 4, 4)[3:], *front, *jambs]
    division = divided(faces, footprint_of((0, 0, 4, 4), (0.5, 4, 3.5, 7)))
    found = cut_at_openings(division, NONE, roof, along(*faces))
    assert max(part.area for part in found.outlines) == pytest.approx(area, abs=0.2)


def test_where_no_room_is_there_are_no_parts():
    parts, found = parts_of(sides(0, 0, 4, 3), footprint_of())
    assert parts == list(found.over_sill) == []
