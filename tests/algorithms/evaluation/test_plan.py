"""Agreement of a plan with its reference."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.evaluation.plan import compare_plan
from shapely.affinity import rotate, scale, translate
from shapely.geometry import MultiPolygon, Point, Polygon, box

WALL = box(0, 0, 10, 0.5)
ROOM = box(0, 0, 8, 6).difference(box(0.4, 0.3, 7.5, 5.6)).difference(box(3, -1, 4, 1))
TOWER = Point(0, 0).buffer(3, 64).difference(Point(0, 0).buffer(2.4, 64))

shapes = st.sampled_from([WALL, ROOM, TOWER])
angles = st.integers(0, 359)
shifts = st.tuples(*[st.integers(-(10**6), 10**6)] * 2)
settled = settings(max_examples=20, deadline=None)


def numbers(agreement):
    return (
        agreement.completeness,
        agreement.correctness,
        agreement.iou,
        agreement.median_offset,
        agreement.p95_offset,
    )


@settled
@given(shapes, angles, shifts)
def test_a_plan_agrees_with_itself_wherever_it_lies(outline, angle, shift):
    moved = translate(rotate(outline, angle), *shift)
    assert numbers(compare_plan(moved, moved, 0.05)) == pytest.approx((1, 1, 1, 0, 0), abs=1e-6)


@settled
@given(shapes, angles, shifts, st.integers(1, 45))
def test_turning_and_shifting_both_changes_nothing(outline, angle, shift, millimetres):
    plan = translate(outline, millimetres / 1000, 0.02)
    moved = [translate(rotate(part, angle, (0, 0)), *shift) for part in (plan, outline)]
    here, there = compare_plan(plan, outline, 0.05), compare_plan(*moved, 0.05)
    # A piece whose offset is the tolerance may fall on either side of it.
    assert numbers(there) == pytest.approx(numbers(here), abs=0.01)


@settled
@given(shapes, st.integers(0, 40), angles)
def test_what_is_wider_all_around_is_off_by_as_much(outline, millimetres, angle):
    reference = rotate(outline, angle)
    # Corners are farther apart than faces, by the square root of two.
    agreement = compare_plan(reference.buffer(millimetres / 1000, join_style=2), reference, 0.06)
    assert agreement.median_offset == pytest.approx(millimetres / 1000, abs=1e-4)
    assert (agreement.completeness, agreement.correctness) == pytest.approx((1, 1))


@settled
@given(shapes, st.integers(2, 9))
def test_in_other_units_all_is_as_many_times_larger(outline, factor):
    plan = translate(outline, 0.02, 0.03)
    one = compare_plan(plan, outline, 0.05)
    large = [scale(part, factor, factor, origin=(0, 0)) for part in (plan, outline)]
    other = compare_plan(*large, 0.05 * factor)
    assert numbers(other)[:3] == pytest.approx(numbers(one)[:3], abs=0.02)
    assert other.median_offset == pytest.approx(factor * one.median_offset, abs=0.002 * factor)


def test_a_shift_along_the_normal_shows_as_offset():
    agreement = compare_plan(translate(WALL, 0, 0.03), WALL, 0.05)
    assert agreement.completeness == pytest.approx(1.0)
    assert agreement.median_offset == pytest.approx(0.03, abs=1e-9)
    assert agreement.iou == pytest.approx(0.47 / 0.53, abs=1e-6)


def test_completeness_of_one_is_correctness_of_the_other():
    one, other = compare_plan(ROOM, WALL, 0.1), compare_plan(WALL, ROOM, 0.1)
    assert (one.completeness, one.correctness) == (other.correctness, other.completeness)


def test_half_of_the_wall_is_half_complete_and_correct():
    agreement = compare_plan(box(0, 0, 5, 0.5), WALL, 0.05)
    assert agreement.completeness == pytest.approx(10.5 / 21 + 0.1 / 21, abs=0.003)
    assert agreement.correctness == pytest.approx(10.6 / 11, abs=0.003)


def test_an_invented_wall_costs_correctness_only():
    plan = MultiPolygon([WALL, box(0, 5, 10, 5.5)])
    agreement = compare_plan(plan, WALL, 0.05)
    assert agreement.completeness == pytest.approx(1.0)
    assert agreement.correctness == pytest.approx(0.5, abs=0.01)


def test_a_part_that_was_never_seen_is_not_missing():
    half = box(0, 0, 5, 0.5)
    seen = WALL.boundary.intersection(box(-1, -1, 4.9, 2))
    assert compare_plan(half, WALL, 0.05, seen).completeness == pytest.approx(1.0)


def test_the_back_of_a_wall_whose_other_face_was_not_seen_is_not_judged():
    seen = WALL.boundary.intersection(box(-1, -1, 11, 0.05))
    thin = box(0, 0, 10, 0.2)
    assert compare_plan(thin, WALL, 0.05, seen).correctness == pytest.approx(1.0)
    assert compare_plan(thin, WALL, 0.05, WALL.boundary).correctness == pytest.approx(0.5, abs=0.02)
    thick = box(0, 0, 10, 0.8)
    assert compare_plan(thick, WALL, 0.05, seen).correctness == pytest.approx(0.5, abs=0.03)


def test_an_empty_plan_finds_nothing_and_its_offsets_are_unknown():
    agreement = compare_plan(Polygon(), WALL, 0.05)
    assert (agreement.completeness, agreement.correctness, agreement.iou) == (0, 0, 0)
    assert np.isnan([agreement.median_offset, agreement.p95_offset]).all()


def test_faces_surveyed_as_lines_have_no_area_to_compare():
    agreement = compare_plan(WALL, WALL.boundary, 0.05)
    assert (agreement.completeness, agreement.correctness, agreement.median_offset) == (1, 1, 0)
    assert np.isnan(agreement.iou)


def test_another_tolerance_needs_no_other_comparison():
    agreement = compare_plan(translate(WALL, 0, 0.03), WALL, 0.05)
    assert numbers(agreement.at(0.02)) == numbers(compare_plan(translate(WALL, 0, 0.03), WALL, 0.02))


def test_the_stretches_are_both_boundaries_and_say_where_they_differ():
    plan = MultiPolygon([translate(box(0, 0, 4, 0.5), 0, 0.01), box(20, 0, 21, 1)])
    stretches = list(compare_plan(plan, WALL, 0.1).stretches())
    for side, outline in (("plan", plan), ("reference", WALL)):
        assert sum(s.line.length for s in stretches if s.side == side) == pytest.approx(outline.length)
    wrong = [s for s in stretches if s.state == "wrong" and s.line.distance(Point(20, 0)) < 2]
    assert sum(s.line.length for s in wrong) == pytest.approx(4)
    missing = [s for s in stretches if s.state == "missing"]
    assert sum(s.line.length for s in missing) == pytest.approx(12.3, abs=0.1)
    assert max(s.max_offset for s in missing) == pytest.approx(6, abs=0.05)
    agreeing = max(
        (s for s in stretches if s.side == "plan" and s.state == "agrees"), key=lambda s: s.line.length
    )
    assert agreeing.offset == pytest.approx(0.01)


def test_each_stretch_has_offsets_of_one_class():
    # The lower face leans from 0 to 6 cm over 10 m. At a tolerance of 4 cm, classes end at 1, 2 and 4 cm.
    leaning = Polygon([(0, 0), (10, -0.06), (10, 0.5), (0, 0.5)])
    plan = [stretch for stretch in compare_plan(leaning, WALL, 0.04).stretches() if stretch.side == "plan"]
    along = [s for s in plan if s.line.bounds[2] - s.line.bounds[0] > 1 and s.line.bounds[3] < 0.01]
    along.sort(key=lambda stretch: stretch.line.bounds[0])

    assert [stretch.state for stretch in along] == ["agrees"] * 3 + ["wrong"]
    assert [s.line.bounds[2] for s in along] == pytest.approx([10 / 6, 20 / 6, 40 / 6, 10], abs=0.03)
