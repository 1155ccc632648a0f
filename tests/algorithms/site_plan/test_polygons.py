"""Outlines stay polygons where their rings cross."""

import pytest
from ichnograph.algorithms.site_plan.polygons import polygon_of

ORIGIN = (412_000.0, 5_812_000.0)


def test_a_hole_within_its_ring_is_a_hole_in_world_coordinates():
    polygon = polygon_of(([(0, 0), (4, 0), (4, 3), (0, 3)], [(1, 1), (3, 1), (3, 2), (1, 2)]), ORIGIN)
    assert polygon.bounds == (412_000, 5_812_000, 412_004, 5_812_003)
    assert polygon.area == pytest.approx(10)


def test_the_faces_of_a_thin_wall_that_cross_leave_it_whole():
    outer = [(0, 0), (6, 0), (6, 4), (0, 4)]
    inner = [(0.01, 0.01), (0.01, 4.02), (5.99, 3.98), (5.99, 0.01)]
    polygon = polygon_of((outer, inner), (0, 0))
    assert polygon.geom_type == "Polygon" and len(polygon.interiors) == 1
    assert polygon.exterior.length == pytest.approx(20, abs=0.1)


def test_a_ring_that_crosses_itself_loses_the_loop():
    polygon = polygon_of(([(0, 0), (4, 0), (4, 3), (3.9, 3.1), (4.0, 3.1), (3.9, 3), (0, 3)],), (0, 0))
    assert polygon.is_valid and polygon.geom_type == "Polygon"
    assert polygon.area == pytest.approx(12, abs=0.1)


def test_of_nothing_there_is_no_polygon():
    assert polygon_of(([(0, 0), (1, 1)],), (0, 0)) is None
