"""What a user should look at, because it is much."""

from dataclasses import replace

import numpy as np
from ichnograph.algorithms.site_plan.storeys.doubts import doubts
from ichnograph.algorithms.site_plan.storeys.evidence.levels import Storey
from ichnograph.algorithms.site_plan.storeys.evidence.sheets import Sheet
from ichnograph.algorithms.site_plan.storeys.rooms.room_cells import Room
from ichnograph.algorithms.site_plan.storeys.storey_plan import StoreyPlan
from ichnograph.algorithms.site_plan.storeys.walls.left_out import CLOSE, HANGS, LOW, LeftOut
from shapely.geometry import LineString, box

HOUSE = box(0, 0, 4, 3)
LINE = LineString([(1, 1), (3, 1)])


def plan_of(*left_out, limits=()):
    """Return a room with 36 m2 of upright surface around it."""
    sheet = Sheet(np.array([0.0, 0.0]), np.array([14.4, 0.0]), 25.0, 0.002)
    rooms = (Room(HOUSE, 0.0, 2.6, 1.0),)
    return StoreyPlan((), rooms, tuple(limits), left_out, (sheet,), HOUSE, Storey(0.0, 2.6), 0.02, 0.002)


def test_a_little_furniture_and_a_short_limit_are_no_doubt():
    assert doubts(plan_of(LeftOut(LINE, CLOSE, 3.0), limits=[LineString([(0, 0), (1, 0)])])) == ()


def test_much_that_is_as_high_as_walls_is_a_warning():
    (found,) = doubts(plan_of(LeftOut(LINE, CLOSE, 9.0)))
    assert "9 m² of 36 m²" in found
    assert "LEFT_OUT" in found


def test_what_is_low_or_hangs_is_surely_no_wall():
    assert doubts(plan_of(LeftOut(LINE, LOW, 20.0), LeftOut(LINE, HANGS, 10.0))) == ()


def test_rooms_that_end_without_a_wall_are_a_warning():
    open_side = LineString([(0, 0), (4, 0), (4, 3)])
    (found,) = doubts(plan_of(limits=[open_side]))
    assert "7 m of 14 m" in found


def test_an_empty_plan_raises_no_doubt():
    assert doubts(replace(plan_of(), rooms=(), sheets=())) == ()
