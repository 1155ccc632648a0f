"""Rectangles and arches where the border allows, with deviations that hold; else as it was seen."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import ARCH, CIRCLE, FREE, RECTANGLE, TRAPEZIUM
from ichnograph.algorithms.facade.outlines.border import Border
from ichnograph.algorithms.facade.outlines.regular_outlines import make_outline
from shapely.geometry import Point, Polygon, box

GAP = 0.01


def border_of(shape, scatter=GAP / np.sqrt(12), seed=0):
    """Return the border of a shape as points `GAP` apart see it."""
    count = int(shape.exterior.length / GAP)
    along = np.linspace(0, shape.exterior.length, count, endpoint=False)
    crossings = np.array([shape.exterior.interpolate(station).coords[0] for station in along])
    crossings += np.random.default_rng(seed).normal(0, scatter, crossings.shape)
    return Border(Polygon(crossings).buffer(0), crossings, np.full(count, GAP), np.ones(count, bool))


def arched(width, height):
    return box(0, 0, width, height - width / 2).union(
        Point(width / 2, height - width / 2).buffer(width / 2, 64)
    )


def test_a_rectangle_is_found_within_its_deviations():
    outline = make_outline(border_of(box(0.2, 0.5, 1.3, 2.0)), True)

    assert outline.shape == RECTANGLE
    assert outline.polygon.bounds == pytest.approx((0.2, 0.5, 1.3, 2.0), abs=0.002)
    assert 0 < outline.edges.left < 0.002
    assert outline.rms == pytest.approx(GAP / np.sqrt(12), rel=0.2)


@pytest.mark.parametrize(("width", "height"), [(1.0, 2.2), (2.0, 2.9), (0.8, 1.0)])
def test_an_arched_door_is_found_with_its_crown(width, height):
    outline = make_outline(border_of(arched(width, height)), True)

    assert outline.shape == ARCH
    assert outline.polygon.bounds == pytest.approx((0, 0, width, height), abs=0.003)
    assert outline.polygon.area == pytest.approx(arched(width, height).area, rel=0.003)


def test_a_flat_arch_keeps_its_radius():
    full = Point(0.5, 0.6).buffer(1.0, 256)
    flat = full.intersection(box(0, -2, 1, 2)).intersection(box(0, 0, 1, 2))
    outline = make_outline(border_of(flat), True)

    assert outline.shape == ARCH
    assert outline.polygon.symmetric_difference(flat).area < 0.004


@pytest.mark.parametrize("shape", [
    Polygon([(0, 0), (2, 0), (1, 1.5)]), box(0, 0, 2, 2).difference(box(1, 1, 2, 2)),
], ids=["triangle", "angle"])  # fmt: skip
def test_other_shapes_remain_as_they_were_seen(shape):
    outline = make_outline(border_of(shape), True)

    assert outline.shape == FREE
    assert outline.polygon.symmetric_difference(shape).area < 0.02 * shape.area


def test_nothing_is_regular_if_not_asked_for():
    assert make_outline(border_of(box(0, 0, 1, 1)), False).shape == FREE


def test_a_branch_before_a_side_does_not_move_it():
    border = border_of(box(0, 0, 1, 1.5))
    hidden = (border.crossings[:, 0] > 0.95) & (np.abs(border.crossings[:, 1] - 0.7) < 0.1)
    border.crossings[hidden, 0] -= 0.08
    outline = make_outline(border, True)

    assert outline.shape == RECTANGLE
    assert outline.polygon.bounds[2] == pytest.approx(1.0, abs=0.002)


def test_a_round_window_is_a_circle():
    outline = make_outline(border_of(Point(0.4, 0.5).buffer(0.35, 64)), True)

    assert outline.shape == CIRCLE and outline.head is None
    assert outline.polygon.bounds == pytest.approx((0.05, 0.15, 0.75, 0.85), abs=0.003)
    assert 0 < outline.edges.left < 0.003


def test_a_sloped_head_makes_a_trapezium():
    outline = make_outline(border_of(Polygon([(0, 0), (1, 0), (1, 1.4), (0, 1.1)])), True)

    assert (outline.shape, outline.head) == (TRAPEZIUM, "sloped")
    assert outline.polygon.bounds[3] == pytest.approx(1.4, abs=0.005)


def test_an_edge_that_something_hides_is_where_the_region_ends_and_has_no_deviation():
    border = border_of(box(0, 0, 1, 1.5))
    hidden = border.crossings[:, 0] > 0.9
    border = replace(border, seen=~hidden)
    outline = make_outline(border, True, region=box(0, 0, 0.97, 1.5))

    assert outline.shape == RECTANGLE
    assert outline.polygon.bounds[2] == pytest.approx(0.97)
    assert np.isnan(outline.edges.right) and np.isfinite(outline.edges.left)


def test_a_jamb_shows_an_edge_better_than_the_wall_beside_it():
    border = border_of(box(0, 0, 1, 1.5))
    v = np.linspace(0, 1.5, 150)
    jamb = np.column_stack(
        [np.random.default_rng(0).normal(0.004, 0.001, 150), v, -0.1 * np.arange(150) / 150]
    )
    outline = make_outline(replace(border, jambs=jamb), True)

    assert outline.polygon.bounds[0] == pytest.approx(0.004, abs=0.0005)


def test_the_side_of_a_frame_deep_in_the_wall_is_not_its_jamb():
    border = border_of(box(0, 0, 1, 1.5))
    depths = np.linspace(-0.2, -0.12, 150)
    frame = np.column_stack([np.full(150, 0.006), np.linspace(0, 1.5, 150), depths])
    outline = make_outline(replace(border, jambs=frame), True)

    assert outline.polygon.bounds[0] == pytest.approx(0, abs=0.002)


def test_without_a_border_the_outline_is_the_region():
    nothing = Border(Polygon(), np.empty((0, 2)), np.empty(0), np.empty(0, bool))
    outline = make_outline(nothing, True, region=box(0, 0, 1, 2))

    assert outline.shape == FREE and outline.polygon.equals(box(0, 0, 1, 2))
    assert np.isnan(outline.edges.left)


def test_the_feet_of_jambs_do_not_measure_a_sill_that_was_not_seen():
    shape = Polygon([(0, 0), (1, 0), (1, 1.4), (0.8, 1.8), (0.9, 2.0), (0.2, 2.0), (0.3, 1.7), (0, 1.4)])
    whole = border_of(shape)
    above = whole.crossings[:, 1] > 2 * GAP
    feet = (whole.crossings[:, 1] <= 2 * GAP) & (np.abs(whole.crossings[:, 0] - 0.5) > 0.48)
    outline = make_outline(replace(whole, seen=above | feet), False)

    assert outline.shape == FREE
    assert np.isnan(outline.edges.bottom)
    assert outline.edges.left < 0.005
    assert np.isfinite(make_outline(whole, False).edges.bottom)


def beside_a_shadow():
    """Return the border of a window, 1 x 1.5 m, and of a shadow that hangs on to its lower right corner."""
    shadow = Polygon([(0.6, -0.4), (1.3, -0.3), (1.3, 0.5), (1.0, 0.6), (1.0, 0), (0.6, 0)])
    border = border_of(box(0, 0, 1, 1.5).union(shadow))
    beyond = (border.crossings[:, 0] > 1.02) | (border.crossings[:, 1] < -0.02)
    return replace(border, bare=beyond)


def test_the_shadow_of_a_tree_on_the_wall_beside_a_window_is_not_a_part_of_it():
    outline = make_outline(beside_a_shadow(), True)

    assert outline.shape == RECTANGLE
    assert outline.polygon.bounds == pytest.approx((0, 0, 1, 1.5), abs=0.003)


def test_what_shows_something_behind_the_wall_all_around_is_the_shape_of_the_hole():
    border = replace(beside_a_shadow(), bare=None)
    outline = make_outline(border, True)

    assert outline.shape == FREE
    assert outline.polygon.bounds[2] == pytest.approx(1.3, abs=0.02)


def test_the_border_of_a_shadow_measures_no_edge_of_a_free_shape():
    outline = make_outline(beside_a_shadow(), False)

    assert outline.shape == FREE
    assert np.isnan(outline.edges.right) and np.isnan(outline.edges.bottom)
    assert outline.edges.left < 0.005 and outline.edges.top < 0.005


@pytest.mark.parametrize("gap", [0.002, 0.005, 0.01, 0.02])
def test_a_window_below_a_lintel_that_sags_is_level_and_as_uncertain_as_its_height_changes(gap):
    window = Polygon([(0, 0), (1, 0), (1, 1.514), (0, 1.486)])
    border = border_of(window, scatter=0.002)
    outline = make_outline(replace(border, gaps=np.full(len(border.gaps), gap)), True)

    assert (outline.shape, outline.head) == (RECTANGLE, "flat")
    assert outline.polygon.bounds[3] == pytest.approx(1.5, abs=0.003)
    assert outline.edges.top == pytest.approx(0.028 / np.sqrt(12), rel=0.35)
