"""What an elevation does not show, with the reason and the area."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import COLOURED, OPENING, LeftOut
from ichnograph.algorithms.facade.left_out import OBLIQUE, SURFACE, summary
from ichnograph.algorithms.facade.measurement import measure_facade
from ichnograph.algorithms.facade.outlines.acceptance import RAGGED
from ichnograph.tests.algorithms.facade.samples import bare, lattice, upright
from shapely.geometry import box

STEP = 0.02


def test_the_summary_adds_up_what_has_one_reason_the_largest_first():
    square = box(0, 0, 1, 1)
    stain = LeftOut(square, COLOURED, "a", 1.0)
    items = [stain, LeftOut(square, OPENING, "b", 2.5), stain]
    assert summary(items) == [(OPENING, "b", 1, 2.5), (COLOURED, "a", 2, 2.0)]


def canted():
    """Return a wall of 6 x 3 m with a side of a bay, 0.9 m wide, that comes forward at 45 degrees."""
    side = lattice(0, 0, 0.9, 3, STEP)
    out = side[:, 0] * np.sqrt(0.5)
    bay = np.column_stack([4 + out, -out, side[:, 1]])
    return np.concatenate([upright(4, 3), bay, upright(2.5, 3) + (4.64, -0.64, 0)])


def test_a_surface_at_an_angle_is_left_out_with_its_own_area():
    elevation = measure_facade(bare(canted()))
    (side,) = (item for item in elevation.left_out if item.kind == SURFACE)
    assert side.reason == OBLIQUE.format(45)
    # The points close to the edges belong to the neighbours.
    assert 0.75 * 0.9 * 3 < side.area < 0.9 * 3
    left, _, right, _ = side.shape.bounds
    assert right - left == pytest.approx(0.64, abs=0.1)


def test_a_ragged_hole_is_left_out_with_the_area_of_the_wall_that_is_missing():
    wall = upright(4, 3)
    u, v = wall[:, 0] - 2, wall[:, 2] - 1.5
    angle = np.arctan2(v, u)
    hole = np.hypot(u, v) < 0.5 + 0.25 * np.sin(3 * angle) + 0.2 * np.cos(5 * angle)
    behind = wall[hole] + (0, 0.4, 0)
    elevation = measure_facade(bare(np.concatenate([wall[~hole], behind])))
    (damage,) = elevation.left_out
    assert elevation.details == ()
    assert damage.reason == RAGGED
    assert damage.area == pytest.approx(hole.sum() * STEP**2, rel=0.15)
