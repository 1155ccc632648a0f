"""Rooms, and the parapets below windows."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.evidence.footprint import Footprint
from ichnograph.algorithms.site_plan.storeys.rooms.room_cells import find_rooms
from ichnograph.tests.algorithms.site_plan.storeys.drawn import (
    COARSE,
    STOREY,
    along,
    divided,
    footprint_of,
    sides,
    with_floor,
)
from ichnograph.tests.algorithms.site_plan.storeys.rooms.test_openings import (
    EVERYWHERE,
    NONE,
    room_with_window,
    two_rooms,
)
from shapely.geometry import box


def found_in(faces, footprint):
    return find_rooms(divided(faces, footprint), NONE, EVERYWHERE, footprint, STOREY, along(*faces))


def test_a_room_knows_its_outline_its_floor_and_its_ceiling():
    footprint = footprint_of((0, 0, 4, 3), floor=0.02, ceiling=2.58)
    (room,), parapets = found_in(sides(0, 0, 4, 3), footprint)
    assert room.outline.symmetric_difference(box(0, 0, 4, 3)).area < 1e-6
    assert (room.z_floor, room.z_ceiling) == pytest.approx((0.02, 2.58))
    assert room.seen == pytest.approx(1.0, abs=0.01)
    assert parapets == []


def test_what_was_not_seen_is_null():
    (room,), _ = found_in(sides(0, 0, 4, 3), footprint_of((0, 0, 4, 3), floor=np.nan))
    assert room.z_floor is None
    assert room.z_ceiling == pytest.approx(2.6)


def test_seen_is_the_share_of_what_is_known():
    whole = footprint_of((0, 0, 4, 3))
    weight = whole.weight.copy()
    (row0, row1), (column0, column1) = COARSE.places(np.array([(1, 1), (3, 2)]) + 1e-6)
    weight[row0:row1, column0:column1] = 0
    (room,), _ = found_in(sides(0, 0, 4, 3), Footprint(COARSE, weight, whole.floor, whole.ceiling))
    assert room.seen == pytest.approx(10 / 12, abs=0.02)


def test_the_largest_room_comes_first_and_a_door_is_none():
    rooms, parapets = found_in(*two_rooms())
    assert [room.outline.area for room in rooms] == pytest.approx([12, 3.88 * 3], abs=0.02)
    assert parapets == []


def test_a_narrow_place_without_a_lintel_is_a_door():
    rooms, _ = found_in(*two_rooms(lintel=26))
    assert [round(room.outline.area) for room in rooms] == [12, 12]


def test_below_a_window_stands_a_parapet():
    faces, footprint = room_with_window()
    niche = (1, -0.24, 2.2, 0)
    (room,), (parapet,) = found_in(faces, with_floor(footprint, niche, 0.9))
    assert parapet.symmetric_difference(box(*niche)).area < 0.02
    assert room.outline.area == pytest.approx(12, abs=0.02)


def test_a_niche_down_to_the_floor_has_no_parapet():
    _, parapets = found_in(*room_with_window())
    assert parapets == []


def test_shelves_at_many_heights_are_no_sill():
    faces, footprint = room_with_window()
    for number in range(6):
        strip = (1 + 0.2 * number, -0.24, 1.2 + 0.2 * number, 0)
        footprint = with_floor(footprint, strip, 0.6 + 0.15 * number)
    _, parapets = found_in(faces, footprint)
    assert parapets == []


def test_a_closet_is_a_room_and_a_shaft_is_none():
    faces = [*sides(0, 0, 4, 3), *sides(5, 0, 6.2, 1), *sides(5, 2, 5.6, 2.6)]
    rooms, _ = found_in(faces, footprint_of((0, 0, 4, 3), (5, 0, 6.2, 1), (5, 2, 5.6, 2.6)))
    assert [room.outline.area for room in rooms] == pytest.approx([12, 1.2], abs=0.01)


def test_where_nothing_was_seen_there_is_no_room():
    assert found_in(sides(0, 0, 4, 3), footprint_of()) == ([], [])
