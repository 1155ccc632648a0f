"""Sheets on common lines, and short ones square to long ones."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.evidence.regular import share_lines, square_up
from ichnograph.algorithms.site_plan.storeys.evidence.sheets import Sheet


def sheet(start, stop, levels=20.0):
    return Sheet(np.array(start, float), np.array(stop, float), levels, 0.002)


def test_pieces_of_a_wall_on_both_sides_of_a_door_share_a_line():
    first, second = share_lines([sheet((0, 0), (2, 0.004)), sheet((2.9, 0.001), (5, 0.003))])
    assert abs(first.normal @ (second.start - first.start)) < 1e-9
    assert abs(first.normal @ (second.stop - first.start)) < 1e-9


def test_walls_a_hand_apart_do_not_share_a_line():
    found = share_lines([sheet((0, 0), (2, 0)), sheet((2.9, 0.1), (5, 0.1))])
    assert sorted(one.start[1] for one in found) == [0.0, 0.1]


def test_a_short_sheet_is_turned_square_to_a_long_one():
    reveal = square_up([sheet((0, 0), (3, 0)), sheet((3.002, 0), (3.008, 0.12))])[1]
    assert reveal.direction == pytest.approx([0, 1], abs=1e-9)
    slanted = sheet((3, 0), (3.06, 0.12))
    assert square_up([sheet((0, 0), (3, 0)), slanted])[1] is slanted


def test_a_short_sheet_far_from_any_long_one_keeps_its_direction():
    far = sheet((6, 0), (6.008, 0.12))
    assert square_up([sheet((0, 0), (3, 0)), far])[1] is far


def test_without_a_long_sheet_nothing_is_turned():
    short = [sheet((0, 0), (0.3, 0.01)), sheet((0.3, 0), (0.3, 0.2))]
    assert square_up(short) == short


def test_a_bent_wall_is_not_drawn_straight():
    bent = [sheet((0, 0), (2, 0)), sheet((2.1, 0.03), (4.1, 0.09))]
    found = sorted(share_lines(bent), key=lambda one: one.start[0])
    for one, other in zip(bent, found):
        assert np.allclose(one.start, other.start)
        assert np.allclose(one.stop, other.stop)


def test_sheets_on_one_line_but_far_apart_keep_their_own_lines():
    found = share_lines([sheet((0, 0), (2, 0)), sheet((4.5, 0.006), (6.5, 0.006))])
    assert sorted(one.start[1] for one in found) == [0.0, 0.006]


def test_no_sheets_share_no_lines():
    assert square_up([]) == share_lines([]) == []
