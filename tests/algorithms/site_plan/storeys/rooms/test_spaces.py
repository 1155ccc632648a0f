"""How large a space is."""

import pytest
from ichnograph.algorithms.site_plan.storeys.rooms.spaces import inner_width, is_room
from shapely.geometry import Point, Polygon, box


@pytest.mark.parametrize(
    "space, expected",
    [
        (box(0, 0, 4, 3), True),
        (box(0, 0, 1.2, 0.8), True),
        (box(0, 0, 0.9, 0.8), False),
        (box(0, 0, 9, 0.6), False),
        (Polygon(), False),
    ],
    ids=["a room", "a closet", "a niche", "a slit", "nothing"],
)
def test_a_room_is_large_and_wide_enough(space, expected):
    assert is_room(space) is expected


def test_the_inner_width_is_that_of_the_largest_circle():
    assert inner_width(box(0, 0, 5, 0.9)) == pytest.approx(0.9, abs=0.04)
    assert inner_width(Point(0, 0).buffer(0.6)) == pytest.approx(1.2, abs=0.04)


def test_wide_is_wide_enough():
    assert inner_width(box(0, 0, 9, 9)) == 2.0
