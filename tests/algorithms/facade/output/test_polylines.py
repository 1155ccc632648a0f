"""Outlines as lines and arcs."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.facade.output.polylines import polyline
from ichnograph.tests.scenes.facades.streets.openings import circle, pointed, round_arch, segmental
from shapely.geometry import Point, Polygon

SPACING = 0.01


def arcs(outline):
    return polyline(outline.exterior, SPACING)


def length(vertices):
    """Return the length of a polyline of lines and arcs."""
    total = 0.0
    for (x, y, bulge), (to_x, to_y, _) in zip(vertices, np.roll(vertices, -1, axis=0)):
        chord = np.hypot(to_x - x, to_y - y)
        angle = 4 * np.arctan(abs(bulge))
        total += chord if angle < 1e-9 else chord * angle / (2 * np.sin(angle / 2))
    return total


def test_a_rectangle_has_four_lines_even_if_its_ring_has_more_vertices():
    vertices = arcs(Polygon([(0, 0), (0.5, 0), (1, 0), (1, 2), (0.3, 2), (0, 2)]))
    assert len(vertices) == 4 and not vertices[:, 2].any()


def test_a_round_arch_has_three_lines_and_half_a_circle():
    vertices = arcs(round_arch(0, 0, 1.0, 2.0))
    assert len(vertices) == 4
    assert sorted(np.abs(vertices[:, 2])) == pytest.approx([0, 0, 0, 1], abs=1e-3)


def test_a_segmental_arch_has_one_arc_of_its_rise():
    vertices = arcs(segmental(0, 0, 1.2, 2.0, 0.15))
    (bulge,) = vertices[vertices[:, 2] != 0, 2]
    assert abs(bulge) == pytest.approx(0.15 / 0.6, abs=1e-3)


def test_a_pointed_arch_has_two_arcs_that_meet_at_its_point():
    vertices = arcs(pointed(0, 0, 1.0, 2.5))
    assert len(vertices) == 5 and np.count_nonzero(vertices[:, 2]) == 2
    assert vertices[:, 1].max() == pytest.approx(2.5, abs=1e-3)


def test_a_circle_has_two_arcs():
    vertices = arcs(circle(0, 0, 0.6))
    assert len(vertices) == 2 and np.abs(vertices[:, 2]) == pytest.approx(1, abs=1e-3)


def test_arcs_turn_as_their_rings_do():
    outline = round_arch(0, 0, 1.0, 2.0)
    forward = polyline(outline.exterior, SPACING)
    back = polyline(Polygon(list(outline.exterior.coords)[::-1]).exterior, SPACING)
    assert forward[:, 2].sum() == pytest.approx(-back[:, 2].sum())
    assert forward[:, 2].sum() * (1 if outline.exterior.is_ccw else -1) > 0


def test_an_octagon_has_no_arcs():
    vertices = arcs(Point(0, 0).buffer(0.6, 2))
    assert len(vertices) == 8 and not vertices[:, 2].any()


def test_a_broken_edge_is_simplified_within_the_spacing():
    u = np.arange(0, 3, 0.01)
    rough = 1 + 0.02 * np.random.default_rng(0).uniform(-0.2, 0.2, len(u))
    ring = Polygon([(0, 0), (3, 0), *zip(u[::-1], rough[::-1])]).exterior
    vertices = polyline(ring, SPACING)
    assert len(vertices) < 20
    assert Polygon(vertices[:, :2]).boundary.buffer(SPACING + 1e-6).covers(ring)


@settings(deadline=None, max_examples=50)
@given(st.floats(0.4, 3), st.floats(0.3, 2), st.floats(0.05, 0.49), st.floats(0, 6.3))
def test_lines_and_arcs_are_as_long_as_the_outline(width, height, share, turn):
    outline = segmental(0, 0, width, height + share * width, share * width)
    cos, sin = np.cos(turn), np.sin(turn)
    ring = Polygon(np.array(outline.exterior.coords) @ np.array([[cos, sin], [-sin, cos]])).exterior
    vertices = polyline(ring, SPACING)
    assert len(vertices) <= 5
    assert length(vertices) == pytest.approx(ring.length, rel=3e-3)
