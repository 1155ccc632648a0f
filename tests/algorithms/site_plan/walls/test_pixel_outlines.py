"""Outlines follow the pixel edges, are valid and do not overlap."""

import numpy as np
import pytest
from affine import Affine
from hypothesis import example, given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.site_plan.walls.closing import bridge_corners
from ichnograph.algorithms.site_plan.walls.pixel_outlines import label_walls, trace_outlines
from shapely.ops import unary_union

GRID = Affine(0.1, 0, 412_300.0, 0, -0.1, 5_812_700.0)


def outlines_of(walls, transform=GRID):
    return trace_outlines(label_walls(walls), transform)


def test_a_rectangle_comes_out_at_its_pixel_edges_at_grid_coordinates():
    walls = np.zeros((50, 80), bool)
    walls[10:14, 20:60] = True
    outline = outlines_of(walls)[1]
    np.testing.assert_allclose(outline.bounds, [412_302.0, 5_812_698.6, 412_306.0, 5_812_699.0], atol=1e-8)
    assert len(outline.exterior.coords) == 5


def test_a_room_is_a_ring_with_a_hole():
    walls = np.zeros((40, 40), bool)
    walls[5:35, 5:35] = True
    walls[8:32, 8:32] = False
    outline = outlines_of(walls)[1]
    assert len(outline.interiors) == 1
    assert abs(outline.area - 0.01 * walls.sum()) < 1e-6


@pytest.mark.parametrize("slope", [0.05, 0.2, 0.5, 1.0, 3.0])
def test_the_steps_of_a_slanting_wall_are_straightened_without_bias(slope):
    y, x = np.mgrid[:200, :200]
    across = (x - 100 - (y - 100) * slope) / np.hypot(1, slope)
    along = (y - 100 + (x - 100) * slope) / np.hypot(1, slope)
    walls = (np.abs(across) < 4) & (np.abs(along) < 70)
    outline = outlines_of(walls)[1]
    assert len(outline.exterior.coords) < 40
    assert outline.area == pytest.approx(0.01 * walls.sum(), rel=0.03)
    assert outline.area / outline.minimum_rotated_rectangle.area > 0.9


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000))
@example(2048)
def test_outlines_are_valid_and_never_overlap(seed):
    random = np.random.default_rng(seed)
    walls = random.random((25, 25)) < random.uniform(0.2, 0.8)
    walls = bridge_corners(walls, random.random(walls.shape))
    outlines = list(outlines_of(walls).values())
    assert all(outline.is_valid for outline in outlines)
    assert abs(unary_union(outlines).area - sum(outline.area for outline in outlines)) < 1e-6
