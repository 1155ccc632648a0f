"""The cells that lines divide a storey into."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.division.arrangement import (
    OUTSIDE,
    arrange,
    find_tracks,
    footprint_lines,
    seen_and_unseen,
    sheet_lines,
)
from ichnograph.algorithms.site_plan.storeys.evidence.footprint import Footprint
from ichnograph.algorithms.site_plan.storeys.settings import CutSettings
from ichnograph.tests.algorithms.site_plan.storeys.drawn import COARSE, Face, footprint_of
from shapely.geometry import LineString, Point, box
from shapely.ops import unary_union

ACROSS = LineString([(5, -9), (5, 20)])
CUT = CutSettings()


def cell_at(arrangement, x, y):
    (number,) = [i for i, cell in enumerate(arrangement.cells) if cell.contains(Point(x, y))]
    return number


def test_a_line_divides_the_frame_in_two():
    found = arrange([ACROSS], COARSE)
    assert sorted(cell.area for cell in found.cells) == pytest.approx([6 * 12, 6 * 12])


def test_without_lines_the_frame_is_one_cell():
    found = arrange([], COARSE)
    assert [cell.area for cell in found.cells] == pytest.approx([144])
    assert (found.sides == OUTSIDE).any(axis=1).all()
    assert found.lengths == pytest.approx([12] * 4)


def test_a_border_knows_the_cells_to_its_left_and_right():
    found = arrange([ACROSS], COARSE)
    (border,) = np.flatnonzero((found.sides != OUTSIDE).all(axis=1))
    x0, y0, x1, y1 = found.ends[border]
    assert (x0, x1) == (5, 5)
    west, east = cell_at(found, 0, 5), cell_at(found, 10, 5)
    assert found.sides[border].tolist() == ([west, east] if y1 > y0 else [east, west])


def test_a_cell_within_another_has_borders_on_both():
    found = arrange([LineString(box(2, 2, 3, 3).exterior.coords)], COARSE)
    inner, outer = cell_at(found, 2.5, 2.5), cell_at(found, 8, 8)
    rim = [set(pair) for pair in found.sides.tolist() if OUTSIDE not in pair]
    assert rim == [{inner, outer}] * 4
    assert found.cells[outer].area == pytest.approx(143)


def test_cells_fill_the_frame_and_do_not_overlap():
    rng = np.random.default_rng(2)
    found = arrange([LineString(ends) for ends in rng.uniform(-3, 13, (12, 2, 2))], COARSE)
    assert sum(cell.area for cell in found.cells) == pytest.approx(144)
    assert unary_union(found.cells).area == pytest.approx(144)
    # Both sides of every border inside were found, whatever the lines.
    inside = ~np.isclose(np.abs(found.ends[:, :2] - 5), 6).any(axis=1)
    assert (found.sides[inside] != OUTSIDE).all()


def test_lines_go_on_beyond_their_sheets_to_hidden_corners():
    (line,) = sheet_lines([Face((1, 1), (4, 1)).sheet], CUT)
    assert line.bounds == pytest.approx((0.5, 1, 4.5, 1))


def test_a_short_sheet_goes_on_less_far():
    (line,) = sheet_lines([Face((1, 1), (1.1, 1)).sheet], CUT)
    assert line.bounds == pytest.approx((0.85, 1, 1.25, 1))


def test_the_outline_of_what_was_seen_is_a_line():
    (line,) = footprint_lines(footprint_of((0, 0, 4, 3)), CUT)
    rim = LineString(box(0, 0, 4, 3).exterior.coords)
    assert LineString(line.coords).hausdorff_distance(rim) < CUT.outline_m
    assert len(line.coords) == 5


def test_spots_and_what_is_unsure_divide_nothing():
    assert footprint_lines(footprint_of((0, 0, 0.2, 0.2)), CUT) == []
    unsure = footprint_of((0, 0, 4, 3))
    assert footprint_lines(Footprint(COARSE, 0.3 * unsure.weight, unsure.floor, unsure.ceiling), CUT) == []


def tracks_of(ends, *faces):
    return find_tracks(np.array(ends, float), [face.sheet for face in faces], 0.1)


def test_a_border_on_a_sheet_and_one_beyond_its_end_are_on_its_line():
    found = tracks_of([(1, 0, 2, 0), (4.1, 0, 4.4, 0), (2, 1, 3, 1)], Face((0, 0), (4, 0)))
    assert found.sheet.tolist() == [0, 0, -1]
    assert found.within.tolist() == [True, False, False]
    assert not found.beside.any()


def test_a_border_near_a_sheet_but_not_on_its_line_is_beside_it():
    found = tracks_of([(1, 0.06, 2, 0.06), (1, 0.2, 2, 0.2)], Face((0, 0), (4, 0)))
    assert found.beside.tolist() == [True, False]


def test_of_two_sheets_on_one_line_a_border_lies_on_the_one_around_it():
    found = tracks_of([(5, 0, 5.5, 0)], Face((0, 0), (4, 0)), Face((4.8, 0), (6, 0)))
    assert (found.sheet.tolist(), found.within.tolist()) == ([1], [True])


def test_without_sheets_no_border_lies_on_any():
    found = tracks_of([(1, 0, 2, 0)])
    assert (found.sheet.tolist(), found.within.tolist(), found.beside.tolist()) == ([-1], [False], [False])


def test_cells_are_seen_as_far_as_the_footprint_reaches():
    found = arrange([ACROSS], COARSE)
    seen, unseen = seen_and_unseen(found, footprint_of((0, 0, 4, 3)))
    west, east = cell_at(found, 0, 5), cell_at(found, 10, 5)
    assert (seen[west], unseen[west]) == pytest.approx((12, 60), abs=0.05)
    assert (seen[east], unseen[east]) == pytest.approx((0, 72), abs=0.05)


def test_what_is_neutral_is_neither_seen_nor_unseen():
    neutral = np.full(COARSE.shape, np.nan, np.float32)
    seen, unseen = seen_and_unseen(arrange([ACROSS], COARSE), Footprint(COARSE, neutral, neutral, neutral))
    assert (seen.tolist(), unseen.tolist()) == ([0, 0], [0, 0])


def test_the_core_of_a_partition_counts_with_what_its_faces_hide():
    weight = footprint_of((-1, -1, 5, 11), (5.16, -1, 11, 11)).weight
    # Of four pixels across the partition, the outer two hold its faces.
    (_, (first, last)) = COARSE.places(np.array([[5.001, 0], [5.159, 0]]))
    weight[:, [first, last]] = np.nan
    arrangement = arrange([ACROSS, LineString([(5.16, -9), (5.16, 20)])], COARSE)
    _, unseen = seen_and_unseen(arrangement, Footprint(COARSE, weight, weight, weight))
    assert unseen[cell_at(arrangement, 5.08, 5)] == pytest.approx(0.16 * 12, rel=0.05)
