"""The sums of a plan."""

from dataclasses import replace

import pytest
from ichnograph.tests.algorithms.site_plan.house import plan_of_house
from shapely.geometry import box


def plan_of(*walls):
    """Return the plan of a house with other walls: pairs of outline and coverage."""
    plan = plan_of_house()
    made = [
        replace(plan.walls[0], outline=outline, coverage=coverage, length=3.0) for outline, coverage in walls
    ]
    return replace(plan, walls=tuple(made))


def test_area_and_length_are_those_of_all_walls():
    plan = plan_of((box(0, 0, 4, 0.5), 1.0), (box(9, 0, 12, 1), 1.0))
    assert plan.area == pytest.approx(2.0 + 3.0)
    assert plan.length == pytest.approx(6.0)


def test_coverage_is_weighted_by_the_length_of_the_outlines():
    # Outlines of 8 and 24 m.
    plan = plan_of((box(0, 0, 2, 2), 1.0), (box(9, 0, 15, 6), 0.5))
    assert plan.coverage == pytest.approx((8 * 1.0 + 24 * 0.5) / 32)


def test_a_wall_whose_faces_are_unknown_is_not_covered():
    assert plan_of((box(0, 0, 2, 2), 1.0), (box(9, 0, 11, 2), None)).coverage == pytest.approx(0.5)


def test_axes_and_rooms_that_were_not_looked_for_have_no_extent():
    plan = replace(plan_of_house(), axes=None, rooms=None)
    assert (plan.axes_length, plan.room_area) == (0.0, 0.0)


def test_the_extent_of_axes_and_rooms_is_that_of_all():
    plan = plan_of_house()
    assert plan.axes_length == pytest.approx(sum(axis.line.length for axis in plan.axes))
    assert plan.room_area == pytest.approx(sum(room.outline.area for room in plan.rooms))
