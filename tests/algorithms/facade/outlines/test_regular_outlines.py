"""Rectangles and arches where the border allows, with deviations that hold; else as it was seen."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import ARCH, FREE, RECTANGLE
from ichnograph.algorithms.facade.outlines.border import Border
from ichnograph.algorithms.facade.outlines.regular_outlines import edge_deviation, make_outline
from shapely.geometry import Point, Polygon, box

GAP = 0.01


def border_of(shape, scatter=GAP / np.sqrt(12), seed=0):
    """Return the border of a shape as points `GAP` apart see it."""
    count = int(shape.exterior.length / GAP)
    along = np.linspace(0, shape.exterior.length, count, endpoint=False)
    crossings = np.array([shape.exterior.interpolate(station).coords[0] for station in along])
    crossings += np.random.default_rng(seed).normal(0, scatter, crossings.shape)
    return Border(Polygon(crossings).buffer(0), crossings, np.full(count, GAP))


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
    Point(0, 0).buffer(0.7), Polygon([(0, 0), (2, 0), (1, 1.5)]), box(0, 0, 2, 2).difference(box(1, 1, 2, 2)),
], ids=["circle", "triangle", "angle"])  # fmt: skip
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


def test_deviations_agree_with_the_errors_of_random_borders():
    errors, said = [], []
    for seed in range(60):
        outline = make_outline(border_of(box(0, 0, 0.6, 0.6), seed=seed), True)
        errors.append(outline.polygon.bounds[0])
        said.append(outline.edges.left)
    assert np.std(errors) == pytest.approx(np.mean(said), rel=0.5)


def test_an_edge_along_a_line_of_the_scan_may_lie_anywhere_in_the_gap():
    crossings = np.column_stack([np.zeros(100), np.linspace(0, 1, 100)])
    assert edge_deviation(np.zeros(100), crossings, np.full(100, GAP)) == pytest.approx(
        GAP / np.sqrt(12), rel=0.1
    )


def test_an_edge_that_was_not_seen_has_no_deviation():
    assert np.isnan(edge_deviation(np.empty(0), np.empty((0, 2)), np.empty(0)))
