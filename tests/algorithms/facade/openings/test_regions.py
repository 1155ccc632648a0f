"""An opening is a hole of the wall, whatever is seen in it, and whatever it touches."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.openings.regions import find_regions, open_sides, solid_wall
from ichnograph.tests.algorithms.facade.openings.scenes import (
    STEP,
    WINDOW,
    pane,
    reveal,
    states_of,
    wall,
)
from ichnograph.tests.algorithms.facade.samples import without


def boxes(*parts):
    states = states_of(*parts)
    return [tuple(states.grid.edges(region.box)) for region in find_regions(states)]


def close(box):
    return pytest.approx(box, abs=2.5 * STEP)


@pytest.mark.parametrize("content", [
    pane(WINDOW), pane(WINDOW)[::3],
    np.concatenate([pane(WINDOW, -1.5)[::4], pane((1.0, 1.2, 1.5, 2.4), -0.1)]),
    reveal(WINDOW),
], ids=["curtain", "pane", "shop", "nothing but jambs"])  # fmt: skip
def test_an_opening_is_found_whatever_is_seen_in_it(content):
    (found,) = boxes(wall(WINDOW), content)
    assert found == close(WINDOW)


def test_what_a_sign_in_front_hides_is_not_an_opening():
    assert boxes(wall(WINDOW), pane(WINDOW, 0.2)) == []


def test_a_room_seen_where_a_canopy_hides_the_wall_is_not_an_opening():
    assert boxes(wall(WINDOW), pane(WINDOW, -1.5)) == []


def test_a_part_without_any_points_is_not_an_opening():
    assert boxes(wall(WINDOW)) == []


def test_a_frame_flush_with_the_wall_is_content():
    left, bottom, right, top = WINDOW
    bars = np.concatenate([pane((1.46, bottom, 1.54, top), 0.0), pane((left, 1.76, right, 1.84), 0.0)])
    (found,) = boxes(np.concatenate([wall(WINDOW), bars]), without_bars(pane(WINDOW)))
    assert found == close(WINDOW)


def without_bars(points):
    kept = (np.abs(points[:, 0] - 1.5) > 0.04) & (np.abs(points[:, 1] - 1.8) > 0.04)
    return points[kept]


def test_two_windows_with_a_pier_between_them_are_two():
    second = (2.5, 1.2, 3.5, 2.4)
    assert len(boxes(wall(WINDOW, second), pane(WINDOW), pane(second))) == 2


def test_openings_that_a_gap_joins_come_apart_at_the_neck():
    second, gap = (3.0, 1.2, 4.0, 2.4), (2.0, 1.6, 3.0, 1.8)
    found = boxes(wall(WINDOW, second, gap), pane(WINDOW), pane(second), pane(gap, -0.05))

    assert [close(WINDOW), close(second)] == [box for box in found if box[3] - box[1] > 0.5]


@pytest.mark.parametrize("height", [0.15, 0.2, 0.25])
def test_a_neck_divides_the_mirrored_wall_at_the_mirrored_station(height):
    first, second, gap = (1.0, 1.0, 2.0, 2.4), (2.6, 1.0, 3.6, 2.4), (2.0, 1.5, 2.6, 1.5 + height)
    parts = wall(first, second, gap), pane(first), pane(second), pane(gap)
    mirrored = [part * (-1, 1, 1) + (6.0, 0, 0) for part in parts]
    found, others = boxes(*parts), boxes(*mirrored)

    assert len(found) == 2
    turned = sorted((6.0 - right, bottom, 6.0 - left, top) for left, bottom, right, top in others)
    assert np.allclose(sorted(found), turned, atol=1.5 * STEP)


def test_a_gate_at_the_foot_and_a_window_at_the_top_count_with_the_side_that_is_open():
    gate, dormer = (1.0, -1.0, 2.2, 2.1), (3.5, 2.8, 4.5, 9.0)
    states = states_of(wall(gate, dormer), pane((1.0, 0, 2.2, 2.1), -0.3), pane((3.5, 2.8, 4.5, 4.0), -0.3))
    found = find_regions(states)

    assert len(found) == 2
    sides = [open_sides(region, states, solid_wall(states)) for region in found]
    assert sides == [(False, False, True, False), (False, False, False, True)]


def test_gaps_between_the_points_of_a_wall_are_not_openings():
    whole = wall()
    thinned = whole[np.random.default_rng(0).random(len(whole)) < 0.5]
    assert boxes(thinned, pane((0, 0, 6, 4), -0.4)[::7]) == []


def test_points_in_the_holes_of_others_are_left_out():
    assert len(without(pane(WINDOW)[:, :2], *WINDOW)) == 0
