"""Outlines without what says nothing."""

import pytest
from ichnograph.algorithms.site_plan.storeys.division.outlines import parts_of, sound, tidy, united
from shapely.geometry import GeometryCollection, LineString, MultiPolygon, Point, Polygon, box
from shapely.ops import polygonize, unary_union


def test_tiny_edges_and_idle_corners_go():
    drawn = Polygon([(0, 0), (1, 0.0004), (2, 0), (2, 0.5), (2.001, 0.502), (2, 1), (0, 1)])
    assert len(tidy(drawn).exterior.coords) == 5
    assert tidy(drawn).symmetric_difference(box(0, 0, 2, 1)).area < 0.002


def test_the_corners_of_holes_are_tidied_too():
    hole = [(1, 1), (1.5, 1.0003), (2, 1), (2, 2), (1, 2)]
    found = tidy(Polygon(box(0, 0, 3, 3).exterior.coords, [hole]))
    assert len(found.interiors[0].coords) == 5


def test_true_corners_remain_however_small_the_outline():
    sliver = box(0, 0, 3, 0.02)
    assert tidy(sliver).equals(sliver)


def test_a_triangle_is_never_reduced():
    tiny = Polygon([(0, 0), (0.002, 0), (0, 0.002)])
    assert tidy(tiny).area == pytest.approx(tiny.area)


def test_parts_are_those_that_are_not_empty():
    assert parts_of(Polygon()) == []
    assert parts_of(Point(1, 1)) == [Point(1, 1)]
    assert len(parts_of(MultiPolygon([box(0, 0, 1, 1), box(2, 0, 3, 1)]))) == 2


def test_a_union_keeps_areas_only():
    mixed = GeometryCollection([box(0, 0, 1, 1), LineString([(0, 0), (5, 5)]), Point(9, 9)])
    assert united([mixed, box(1, 0, 2, 1)]).area == pytest.approx(2)
    assert united([LineString([(0, 0), (1, 1)])]).is_empty
    assert united([]).is_empty


def test_an_outline_that_crosses_itself_keeps_its_largest_part():
    bow = Polygon([(0, 0), (4, 2), (4, 0), (0, 1)])
    assert sound(bow).is_valid
    assert sound(bow).area == pytest.approx(max(part.area for part in polygonize(unary_union(bow.boundary))))
    square = box(0, 0, 1, 1)
    assert sound(square) is square
