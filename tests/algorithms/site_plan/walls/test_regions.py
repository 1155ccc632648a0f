"""The three criteria, and the column that fails two of them."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.walls.regions import Criteria, select_regions

CRITERIA = Criteria(min_area=0.1, max_fill=0.4, min_elongation=3.0)


def picture(*rows):
    return np.array([[c == "#" for c in row] for row in rows])


def test_a_region_smaller_than_the_least_area_is_dropped():
    line = np.zeros((5, 40), bool)
    line[1, :9] = True
    line[3, :10] = True
    selection = select_regions(line, 0.1, CRITERIA)
    assert selection.kept.sum() == 10
    assert (selection.regions, selection.too_small, selection.wrong_shape) == (2, 1, 0)


def test_a_bar_is_a_straight_wall_in_any_direction():
    y, x = np.mgrid[:60, :60]
    for angle in (0, 30, 45, 77, 90):
        along = (x - 30) * np.cos(np.radians(angle)) + (y - 30) * np.sin(np.radians(angle))
        across = -(x - 30) * np.sin(np.radians(angle)) + (y - 30) * np.cos(np.radians(angle))
        bar = (np.abs(along) < 20) & (np.abs(across) < 3)
        assert select_regions(bar, 0.1, CRITERIA).kept.sum() == bar.sum()


def test_an_arc_is_a_curved_wall():
    y, x = np.mgrid[:80, :80]
    ring = np.abs(np.hypot(x - 40, y - 40) - 30) < 2
    assert select_regions(ring, 0.1, CRITERIA).kept.all() == ring.all()
    assert select_regions(ring, 0.1, CRITERIA).kept.sum() == ring.sum()


def test_a_blob_is_no_wall():
    y, x = np.mgrid[:60, :60]
    blob = np.hypot(x - 30, y - 30) < 20
    selection = select_regions(blob, 0.1, CRITERIA)
    assert not selection.kept.any()
    assert selection.wrong_shape == 1


@pytest.mark.parametrize(
    ("limit", "kept"), [({"max_fill": 0.2}, False), ({"min_elongation": 1.0, "max_fill": 0.2}, True)]
)
def test_each_limit_decides(limit, kept):
    corner = np.zeros((20, 20), bool)
    corner[:3, :] = corner[:, :3] = True
    criteria = Criteria(**{"min_area": 0.1, "max_fill": 0.4, "min_elongation": 30.0, **limit})
    assert select_regions(corner, 0.1, criteria).kept.any() == kept


def test_regions_that_touch_at_a_corner_are_one():
    diagonal = np.eye(20, dtype=bool)
    assert select_regions(diagonal, 0.1, CRITERIA).regions == 1


def test_the_outline_of_a_column_is_kept_where_it_is_filled_to_a_columns_height():
    column = picture("########", "#......#", "#......#", "#......#", "#......#", "########")
    high = np.ones(column.shape, bool)
    strict = Criteria(min_area=0.1, max_fill=0.3, min_elongation=3.0)
    assert select_regions(column, 0.1, strict, high).kept.sum() == column.sum()
    assert not select_regions(column, 0.1, strict, ~high).kept.any()
    assert not select_regions(column, 0.1, strict).kept.any()


def test_a_bush_as_high_as_a_column_is_full_of_points_and_dropped():
    y, x = np.mgrid[:20, :20]
    bush = np.hypot(x - 10, y - 10) < 8
    assert not select_regions(bush, 0.1, CRITERIA, np.ones(bush.shape, bool)).kept.any()
