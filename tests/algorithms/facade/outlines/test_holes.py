"""Openings, recesses and shadows, classified by the points seen behind a gap in the wall."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import OPENING, RECESS
from ichnograph.algorithms.facade.outlines.holes import classify, find_gaps, within
from ichnograph.tests.algorithms.facade.samples import at, lattice
from shapely.geometry import MultiPolygon, Polygon, box

SPACING = 0.01
HOLE = box(1, 1, 2, 2.5)


def jamb(depth=0.2):
    """Points of the left jamb, which the hole's polygon just holds."""
    v, w = np.meshgrid(np.arange(1, 2.5, 0.01), np.arange(-depth, -0.06, 0.02))
    return np.column_stack([np.full(v.size, 1.001), v.ravel(), w.ravel()])


def kind_of(*seen):
    return classify(HOLE, np.concatenate(seen), SPACING).kind


def test_a_hole_with_a_surface_close_behind_is_a_recess_of_its_depth():
    hole = classify(HOLE, at(lattice(0.5, 0.5, 2.5, 3, 0.01), -0.15), SPACING)
    assert hole.kind == RECESS
    assert hole.depth == pytest.approx(-0.15)


def test_a_pane_that_lets_most_of_the_beams_through_is_a_recess():
    pane = lattice(1, 1, 2, 2.5, 0.01)
    pane = pane[np.random.default_rng(0).random(len(pane)) < 0.3]
    assert kind_of(at(pane, -0.12), at(lattice(0, 0, 3, 3, 0.02), -3.0)) == RECESS


def test_a_hole_with_jambs_and_a_room_behind_is_an_opening():
    assert kind_of(jamb(), at(lattice(1, 1, 2, 2.5, 0.03), -3.0)) == OPENING


def test_jambs_alone_show_an_opening():
    assert kind_of(jamb()) == OPENING


def test_a_gap_behind_which_nothing_was_seen_is_not_a_window():
    assert kind_of(np.empty((0, 3))) is None


def test_a_room_that_was_seen_through_a_window_beside_it_does_not_make_a_shadow_a_window():
    assert kind_of(at(lattice(0, 0, 3, 3, 0.02), -3.0)) is None


def test_holes_of_the_wall_are_gaps_and_small_ones_are_not():
    wall = box(0, 0, 4, 3).difference(HOLE).difference(box(3, 1, 3.1, 1.1))
    (gap,) = find_gaps(MultiPolygon([wall]), 0.04)
    assert gap.equals(HOLE)


def test_a_gate_is_a_gap_in_the_foot():
    wall = box(0, 0, 4, 3).difference(box(1, 0, 2, 2))
    (gap,) = find_gaps(MultiPolygon([wall]), 0.04)
    assert gap.intersection(box(1, 0, 2, 2)).area == pytest.approx(2.0, rel=0.01)


def test_a_gable_and_a_notch_in_the_side_are_not_gates():
    gable = Polygon([(0, 0), (4, 0), (4, 2), (2, 3.5), (0, 2)]).difference(box(3.5, 0.8, 4, 1.5))
    assert find_gaps(MultiPolygon([gable]), 0.04) == []


def test_points_within_a_polygon_are_not_in_its_holes():
    polygon = box(0, 0, 3, 3).difference(box(1, 1, 2, 2))
    points = np.array([(0.5, 0.5), (1.5, 1.5), (2.5, 1.5), (3.5, 1.5)])
    np.testing.assert_array_equal(within(polygon, points), [True, False, True, False])
