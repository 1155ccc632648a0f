"""Narrow places of a space."""

import pytest
from ichnograph.algorithms.site_plan.storeys.rooms.necks import cut_at_necks
from shapely.geometry import box
from shapely.ops import unary_union


def test_two_spaces_meet_at_a_narrow_place():
    space = unary_union([box(0, 0, 4, 3), box(4, 1, 4.1, 1.9), box(4.1, 0, 8, 3)])
    areas = sorted(part.area for part in cut_at_necks(space))
    assert areas == pytest.approx([11.7, 12], abs=0.1)


def test_a_wide_passage_is_no_door():
    space = unary_union([box(0, 0, 4, 3), box(4, 0.5, 4.1, 2.4), box(4.1, 0, 8, 3)])
    assert len(cut_at_necks(space)) == 1


def test_a_corridor_as_narrow_as_a_door_is_whole():
    assert len(cut_at_necks(box(0, 0, 9, 1.0))) == 1


def test_between_columns_is_no_door():
    space = box(0, 0, 6, 6).difference(unary_union([box(2, 2.8, 2.4, 3.2), box(3.3, 2.8, 3.7, 3.2)]))
    assert len(cut_at_necks(space)) == 1
