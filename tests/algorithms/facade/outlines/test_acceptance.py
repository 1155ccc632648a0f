"""A hole with enough straight sides is an opening; damage and shadows are not."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import FREE, RECESS, RECTANGLE, Edges
from ichnograph.algorithms.facade.openings.content import DOOR, Opening
from ichnograph.algorithms.facade.openings.regions import Region
from ichnograph.algorithms.facade.outlines.acceptance import (
    AT_END,
    BENT,
    FEW_SIDES,
    LOW,
    OPEN,
    RAGGED,
    SHALLOW,
    UNSEEN,
    is_regular,
    reason_against_opening,
)
from ichnograph.algorithms.facade.outlines.border import Border
from ichnograph.algorithms.facade.outlines.regular_outlines import Outline
from ichnograph.algorithms.facade.output.elevation_layers import LEFT_OUT_FIELDS
from shapely.geometry import Polygon, box

NOT = float("nan")
SHAPE = box(0, 0, 1, 1.5)
REGION = Region((slice(0, 1), slice(0, 1)), np.ones((1, 1), bool), 0.0)
HOLE = Opening(REGION, SHAPE, RECESS, DOOR, -0.2, 0, (), np.empty(0, int))
BORDER = Border(SHAPE, np.zeros((10, 2)), np.ones(10), np.ones(10, bool))


def outline(left=0.001, right=0.001, bottom=0.001, top=0.001, polygon=SHAPE, shape=RECTANGLE):
    return Outline(shape, None, polygon, Edges(left, right, bottom, top), 0.001)


@pytest.mark.parametrize(("hidden", "reason"), [
    ((), None), (("top",), None), (("top", "left"), FEW_SIDES), (("top", "left", "right"), FEW_SIDES),
])  # fmt: skip
def test_three_sides_are_enough(hidden, reason):
    assert reason_against_opening(HOLE, BORDER, outline(**dict.fromkeys(hidden, NOT))) == reason


def test_the_ground_is_a_side_of_a_door():
    door = replace(HOLE, open_sides=("bottom",))
    high = outline(bottom=NOT, top=NOT, polygon=box(0, 0, 1, 2))
    assert reason_against_opening(door, BORDER, high) is None
    assert reason_against_opening(replace(HOLE, open_sides=("top",)), BORDER, high) == FEW_SIDES


def test_a_low_hole_without_head_and_sill_is_a_gap_between_things_on_the_ground():
    low = outline(bottom=NOT, top=NOT, polygon=box(0, 0, 1, 0.6))
    assert reason_against_opening(replace(HOLE, open_sides=("bottom",)), BORDER, low) == LOW


def test_where_nothing_was_seen_behind_the_wall_all_sides_must_be_measured():
    empty = replace(HOLE, depth=NOT)
    assert reason_against_opening(empty, BORDER, outline()) is None
    assert reason_against_opening(empty, BORDER, outline(top=NOT)) == UNSEEN
    assert reason_against_opening(empty, BORDER, outline(shape=FREE)) == UNSEEN


def test_shallow_small_holes_are_damage():
    stone = outline(polygon=box(0, 0, 0.4, 0.2))
    assert reason_against_opening(replace(HOLE, depth=-0.06), BORDER, stone) == SHALLOW
    assert reason_against_opening(replace(HOLE, depth=-0.3), BORDER, stone) is None
    assert reason_against_opening(replace(HOLE, depth=-0.06), BORDER, outline()) is None


def test_a_shallow_part_of_a_wall_that_bends_is_not_an_opening():
    bend = replace(HOLE, depth=-0.06, bent=2)
    assert reason_against_opening(bend, BORDER, outline()) == BENT
    assert reason_against_opening(replace(bend, bent=1), BORDER, outline()) is None
    assert reason_against_opening(replace(bend, depth=-0.3), BORDER, outline()) is None


def test_a_narrow_hole_that_shows_nothing_along_its_border_is_a_shadow():
    narrow = outline(polygon=box(0, 0, 0.25, 0.25))
    bare = replace(BORDER, bare=np.arange(10) < 6)
    assert reason_against_opening(HOLE, bare, narrow) == RAGGED
    assert reason_against_opening(HOLE, BORDER, narrow) is None
    assert reason_against_opening(HOLE, bare, outline()) is None


def test_a_shallow_shape_without_straight_sides_is_damage():
    shallow = replace(HOLE, depth=-0.06)
    assert reason_against_opening(shallow, BORDER, outline(shape=FREE)) == RAGGED


def test_a_narrow_gap_at_the_end_of_a_wall_is_no_opening():
    gap = outline(right=NOT, polygon=box(0, 0, 0.2, 1.4))
    assert reason_against_opening(HOLE, BORDER, gap) is None
    assert reason_against_opening(replace(HOLE, open_sides=("right",)), BORDER, gap) == AT_END


def test_a_free_shape_must_be_whole_and_bounded_by_the_wall():
    gable = outline(polygon=Polygon([(0, 0), (1, 0), (0.5, 1)]), shape=FREE)
    ragged = outline(polygon=SHAPE.difference(box(0.2, 0.2, 1, 0.8)), shape=FREE)

    assert reason_against_opening(HOLE, BORDER, gable) is None
    assert reason_against_opening(HOLE, BORDER, ragged) == RAGGED
    assert reason_against_opening(HOLE, replace(BORDER, seen=np.arange(10) < 5), gable) == OPEN
    assert reason_against_opening(replace(HOLE, open_sides=("left",)), BORDER, gable) == OPEN
    small = outline(polygon=box(0, 0, 0.5, 0.5), shape=FREE)
    assert reason_against_opening(replace(HOLE, depth=-0.06), BORDER, small) == SHALLOW


def test_a_colour_with_straight_sides_is_a_detail_and_a_stain_is_not():
    assert is_regular(outline())
    assert is_regular(outline(top=NOT))
    assert not is_regular(outline(top=NOT, left=NOT))
    assert not is_regular(outline(shape=FREE))


@pytest.mark.parametrize("reason", [BENT, FEW_SIDES, LOW, OPEN, RAGGED, SHALLOW, UNSEEN])
def test_a_reason_fits_into_its_field(reason):
    assert len(reason) <= int(LEFT_OUT_FIELDS["reason"].partition(":")[2])
