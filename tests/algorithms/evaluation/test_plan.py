"""Agreement of a plan with its reference."""

import pytest
from ichnograph.algorithms.evaluation.plan import compare_plan
from shapely.affinity import translate
from shapely.geometry import MultiPolygon, Polygon, box

WALL = box(0, 0, 10, 0.5)


def test_a_perfect_plan():
    agreement = compare_plan(WALL, WALL, 0.05, WALL.boundary)
    assert (agreement.completeness, agreement.correctness, agreement.iou) == pytest.approx((1, 1, 1))
    assert agreement.p95_offset == pytest.approx(0, abs=1e-9)


def test_a_shift_shows_as_offset():
    agreement = compare_plan(translate(WALL, 0, 0.03), WALL, 0.05, WALL.boundary)
    assert agreement.completeness == pytest.approx(1.0)
    assert agreement.median_offset == pytest.approx(0.03, abs=0.002)
    assert agreement.iou == pytest.approx(0.47 / 0.53, abs=1e-6)


def test_half_of_the_wall_is_half_complete_and_correct():
    agreement = compare_plan(box(0, 0, 5, 0.5), WALL, 0.05, WALL.boundary)
    assert agreement.completeness == pytest.approx(0.5, abs=0.03)
    assert agreement.correctness == pytest.approx(10.5 / 11, abs=0.02)


def test_an_invented_wall_costs_correctness_only():
    plan = MultiPolygon([WALL, box(0, 5, 10, 5.5)])
    agreement = compare_plan(plan, WALL, 0.05, WALL.boundary)
    assert agreement.completeness == pytest.approx(1.0)
    assert agreement.correctness == pytest.approx(0.5, abs=0.01)


def test_a_part_that_was_never_seen_is_not_asked_for():
    half = box(0, 0, 5, 0.5)
    seen = WALL.boundary.intersection(box(-1, -1, 4.9, 2))
    assert compare_plan(half, WALL, 0.05, seen).completeness == pytest.approx(1.0)


def test_an_empty_plan_finds_nothing():
    agreement = compare_plan(Polygon(), WALL, 0.05, WALL.boundary)
    assert (agreement.completeness, agreement.correctness, agreement.iou) == (0, 0, 0)
