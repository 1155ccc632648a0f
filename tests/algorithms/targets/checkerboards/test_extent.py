"""How far a pattern reaches."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.checkerboards.extent import extent_of, quadrants, tiled
from ichnograph.algorithms.targets.checkerboards.pattern import Pattern
from ichnograph.algorithms.targets.checkerboards.settings import ExtentSettings

SPACING = 0.002
PATTERN = Pattern(np.zeros(2), (0.0, np.pi / 2), 0.001, 11000.0, -10000.0, np.zeros((2, 2)))
"""Black 1000, white 21 000; white where the coordinates have equal signs."""


def board(size, background):
    """Return the points of a square target on a wall."""
    line = np.arange(-0.22, 0.22, SPACING)
    places = np.stack(np.meshgrid(line, line), axis=-1).reshape(-1, 2) + SPACING / 3
    inside = np.max(np.abs(places), axis=1) < size / 2
    return places, np.where(inside, PATTERN.intensities(places), background)


@pytest.mark.parametrize("size", [0.075, 0.15, 0.3])
@pytest.mark.parametrize("background", [1000.0, 8000.0, 21000.0])
def test_the_size_is_found_on_walls_of_any_tone(size, background):
    extent = extent_of(PATTERN, *board(size, background), SPACING, ExtentSettings())

    assert extent.size == pytest.approx(size, rel=0.12)
    assert extent.evenness > 0.9


def test_quadrants_without_end_have_no_size():
    places, _ = board(0.1, 0.0)
    extent = extent_of(PATTERN, places, PATTERN.intensities(places), SPACING, ExtentSettings())

    assert extent.size > 0.4


def test_unequal_quadrants_are_uneven():
    places, intensities = board(0.2, 8000.0)
    intensities[(places[:, 0] > 0.03) & (places[:, 1] > 0)] = 8000.0
    intensities[(places[:, 0] > 0.03) & (places[:, 1] < 0)] = 8000.0
    extent = extent_of(PATTERN, places, intensities, SPACING, ExtentSettings())

    assert extent.evenness < 0.5


def test_quadrants_are_counted_with_the_share_of_their_colour():
    places, intensities = board(0.5, 8000.0)
    wrong = (places[:, 0] < 0) & (places[:, 1] < 0)
    four = quadrants(PATTERN, places, np.where(wrong, 1000.0, intensities))

    assert four.counts.sum() == len(places)
    assert sorted(four.agreement.round(2)) == pytest.approx([0.0, 1.0, 1.0, 1.0], abs=0.1)


def test_quadrants_of_one_colour_have_one_tone():
    places, intensities = board(0.5, 8000.0)
    grey = (places[:, 0] < 0) & (places[:, 1] < 0)

    assert quadrants(PATTERN, places, intensities).unevenness < 0.01
    assert quadrants(PATTERN, places, np.where(grey, 15000.0, intensities)).unevenness > 0.5


def test_tiles_continue_the_pattern_and_a_wall_does_not():
    places, intensities = board(0.12, 8000.0)
    u, v = np.floor(places / 0.06).T
    tiles = np.where((u + v) % 2 == 0, 21000.0, 1000.0)

    assert tiled(PATTERN, 0.06, places, tiles, ExtentSettings()) > 0.9
    assert tiled(PATTERN, 0.06, places, intensities, ExtentSettings()) < 0.2
