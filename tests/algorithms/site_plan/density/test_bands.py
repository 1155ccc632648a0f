"""The bands of a density image are filled tile by tile."""

from types import SimpleNamespace

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.density.bands import Bands, occupied_bins
from ichnograph.algorithms.site_plan.density.grid import Grid
from ichnograph.algorithms.site_plan.density.settings import DensitySettings

STEP = 10_000
"""Pixels of 0.1 m, in lattice steps of 10 micrometres."""


def filled(points_m, kept=slice(None), neighbourhood=1):
    """Return the bands of 5 x 5 pixels, filled with points whose ground is at 0 m."""
    bands = Bands(Grid(0, 0, 5, 5, STEP), np.zeros((5, 5)), DensitySettings())
    xyz = np.round(np.array(points_m) * 100_000).astype(np.int32)
    tile = SimpleNamespace(corner=(0, 0), xyz=xyz, edge=50_000)
    bands.spread(tile, np.arange(len(xyz))[kept], neighbourhood)
    bands.stack(tile)
    return bands


def test_a_point_on_a_pixel_centre_gives_all_to_it():
    density = filled([(0.25, 0.15, 0.0)]).density
    assert density[1, 2] == density.sum() == 1


def test_other_points_are_shared_by_inverse_distance():
    density = filled([(0.27, 0.25, 0.0)]).density
    assert density.sum() == pytest.approx(1)
    assert density[2, 2] / density[2, 3] == pytest.approx(0.08 / 0.02)
    assert filled([(0.27, 0.25, 0.0)], neighbourhood=0).density[2, 2] == 1


def test_thinning_counts_for_the_density_and_not_for_the_heights():
    bands = filled([(0.25, 0.25, 1.0), (0.25, 0.25, 2.0)], kept=slice(0, 1))
    assert bands.density.sum() == 1
    assert (bands.base[2, 2], bands.top[2, 2]) == pytest.approx((1.0, 2.0))


def test_bins_begin_at_the_window_above_the_ground():
    bits = filled([(0.25, 0.25, 0.29), (0.25, 0.25, 0.35), (0.25, 0.25, 0.55)]).bits
    assert bits[2, 2] == 0b101
    assert bits.sum() == bits[2, 2]


@pytest.mark.parametrize(
    ("word", "filled_bins"), [(0b101, 3), (0b1001, 4), (0b10001, 2), (0b11, 2), (1 << 30, 0)]
)
def test_up_to_two_empty_bins_between_two_points_count(word, filled_bins):
    assert occupied_bins(np.array([[word]], np.uint64), 20)[0, 0] == filled_bins
