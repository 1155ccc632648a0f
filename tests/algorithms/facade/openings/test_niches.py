"""A niche has nothing but wall in it; windows, doors and closed shutters have not."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import Points
from ichnograph.algorithms.facade.openings.content import DOOR, fill_regions
from ichnograph.algorithms.facade.openings.content import WINDOW as A_WINDOW
from ichnograph.algorithms.facade.openings.niches import NICHE, with_niches
from ichnograph.algorithms.facade.openings.regions import find_regions
from ichnograph.tests.algorithms.facade.openings.scenes import WINDOW, pane, reveal, states_of, wall

WALL, BACK = wall(WINDOW), pane(WINDOW, -0.2)
GATE = (1.0, -1.0, 2.2, 2.1)


def use_of(main, *content, intensity=None, rgb=None):
    """Return the use of the only opening; a wall has intensity 1000 and is grey."""
    states = states_of(main, *content)
    count = sum(map(len, content))
    noise = np.random.default_rng(0).normal(1, 0.03, len(main) + count)

    def values(inside, around):
        both = np.concatenate([np.tile(around, (len(main), 1)), np.tile(inside, (count, 1))])
        return (both * noise[:, None]).astype(np.float32)

    points = Points(
        np.empty((0, 3)), np.zeros(3),
        None if rgb is None else values(rgb, (180.0, 175, 165)),
        None if intensity is None else values([intensity], [1000.0])[:, 0],
        np.zeros(len(main) + count, np.int32),
    )  # fmt: skip
    (found,) = with_niches(states, fill_regions(states, find_regions(states)), points)
    return found.use


def test_a_hole_whose_back_is_wall_is_a_niche():
    assert use_of(WALL, BACK) == NICHE
    assert use_of(WALL, BACK, reveal(WINDOW), intensity=1000.0) == NICHE
    assert use_of(WALL, BACK, rgb=(180.0, 175, 165)) == NICHE


@pytest.mark.parametrize(("intensity", "rgb"), [(500.0, None), (None, (70.0, 105, 85))])
def test_a_closed_shutter_looks_different_from_the_wall(intensity, rgb):
    assert use_of(WALL, BACK, intensity=intensity, rgb=rgb) == A_WINDOW


def test_intensity_decides_where_a_niche_lies_in_shadow():
    assert use_of(WALL, BACK, intensity=1000.0, rgb=(70.0, 68, 64)) == NICHE


def test_a_window_of_frame_and_glass_is_no_niche():
    left, bottom, right, top = WINDOW
    glass = (left + 0.12, bottom + 0.12, right - 0.12, top - 0.12)
    u, v = BACK[:, 0], BACK[:, 1]
    within = (u > glass[0]) & (u < glass[2]) & (v > glass[1]) & (v < glass[3])
    assert use_of(WALL, BACK[~within], pane(glass, -0.3)) == A_WINDOW


def test_what_fills_an_opening_only_in_part_is_no_niche():
    assert use_of(WALL, BACK[BACK[:, 1] < 2.0], intensity=1000.0) == A_WINDOW


def test_what_stands_on_the_ground_is_a_door_unless_it_looks_like_the_wall():
    leaf = pane((1.0, 0.0, 2.2, 2.1), -0.2)
    assert use_of(wall(GATE), leaf) == DOOR
    assert use_of(wall(GATE), leaf, intensity=400.0) == DOOR
    assert use_of(wall(GATE), leaf, intensity=1000.0) == NICHE


def test_scans_of_different_gain_are_compared_each_with_itself():
    states = states_of(WALL, WALL + (0.01, 0, 0), BACK, BACK + (0.01, 0, 0))
    counts = [len(WALL), len(WALL), len(BACK), len(BACK)]
    scan = np.repeat([0, 1, 0, 1], counts).astype(np.int32)

    def use(content):
        intensity = np.repeat([1000.0, 300.0, content * 1000, content * 300], counts).astype(np.float32)
        points = Points(np.empty((0, 3)), np.zeros(3), None, intensity, scan)
        (found,) = with_niches(states, fill_regions(states, find_regions(states)), points)
        return found.use

    assert use(1.0) == NICHE
    assert use(0.7) == A_WINDOW
