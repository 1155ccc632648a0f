"""Which cells of a grid hold points that are far from the site."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.strays import stray_cells

EDGE = 10.0


def strays(counts):
    """Return the cells of 10 m that are stray, from a dictionary of counts by cell."""
    cells = np.array(list(counts))
    found = stray_cells(cells, np.array(list(counts.values())), EDGE)
    return [tuple(cell) for cell in cells[found].tolist()]


def test_cells_that_touch_are_one_part():
    assert strays({(0, 0): 1000, (1, 1): 1}) == []


@pytest.mark.parametrize("shift", range(10))
def test_points_nearer_than_the_gap_are_never_stray_wherever_the_cells_begin(shift):
    edge, stations = 2.0, np.arange(shift, shift + 19, 18)
    cells = np.column_stack([stations // 2, stations // 2])
    assert not stray_cells(cells, np.array([100_000, 1]), edge).any()


@pytest.mark.parametrize("far", [(50, 0), (0, -50), (100_000, 100_000)])
def test_hardly_any_points_far_away_are_stray(far):
    assert strays({(0, 0): 100_000, far: 50}) == [far]


def test_few_and_thin_points_far_away_are_stray():
    assert strays({(0, 0): 100_000, (90, 0): 1500}) == [(90, 0)]


def test_a_second_building_far_away_belongs_to_the_site():
    assert strays({(0, 0): 100_000, (50, 0): 20_000}) == []


def test_points_high_above_the_site_are_stray_where_cells_have_heights():
    assert strays({(0, 0, 0): 100_000, (0, 0, 1): 40, (0, 0, 60): 40}) == [(0, 0, 60)]


def test_the_part_with_most_points_is_never_stray():
    assert strays({(0, 0): 1}) == []
