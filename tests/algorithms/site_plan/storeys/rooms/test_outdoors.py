"""Where rooms run out of a building."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.linked_parts import label_linked
from ichnograph.algorithms.site_plan.storeys.rooms.outdoors import are_outdoors, leaves_roof
from ichnograph.tests.algorithms.site_plan.storeys.drawn import Face, divided, footprint_of, sides
from shapely.geometry import Polygon, box

ROOF = box(0, 0, 4, 3)


def test_a_roof_ends_along_a_facade_and_not_along_a_partition():
    facade, partition, fence = [0, 3, 4, 3], [2, 0, 2, 3], [0, 9, 4, 9]
    assert leaves_roof(np.array([facade, partition, fence], float), ROOF).tolist() == [True, False, False]


def test_both_faces_of_an_outer_wall_lie_where_the_roof_ends():
    inner, outer = [0, 3, 4, 3], [4, 3.4, 0, 3.4]
    assert leaves_roof(np.array([inner, outer]), box(0, 0, 4, 3.4)).all()


def test_without_a_roof_none_ends():
    assert not leaves_roof(np.array([[0.0, 3.0, 4.0, 3.0]]), Polygon()).any()


@pytest.mark.parametrize(
    "around, roof, outdoors",
    [
        ([Face((0, 0), (4, 0))], Polygon(), True),
        (sides(0, 0, 4, 3), Polygon(), False),
        ([Face((0, 0), (4, 0))], ROOF, False),
    ],
    ids=["a terrace before a facade", "a yard, or a stair hall", "a room that ends with the scan"],
)
def test_outdoors_is_neither_under_a_roof_nor_between_walls(around, roof, outdoors):
    division = divided(around, footprint_of((0, 0, 4, 3)))
    pairs = division.arrangement.sides
    linked = pairs[division.is_room[pairs].all(axis=1)]
    part = label_linked(*linked.T, len(division.is_room))
    chosen = np.unique(part[division.is_room])
    assert are_outdoors(division, part, chosen, roof).tolist() == [outdoors]
