"""Regions of one colour: tr2 of the paper, gradients and intensity."""

import numpy as np
from ichnograph.algorithms.facade.colour.appearance import Appearance
from ichnograph.algorithms.facade.colour.region_growing import NONE, absorb, grow_regions
from ichnograph.algorithms.facade.colour.seeds import find_seeds
from ichnograph.tests.algorithms.facade.colour.panel import (
    LINKED,
    MESH,
    PANEL,
    POINTS,
    SHADE,
    WHITE,
    painted,
    reflecting,
    same,
)


def grow(rgb, colour=60.0, seed_colour=30.0, variance=None, relative=None):
    seeds = find_seeds(POINTS, rgb, 0.2)
    variance = seeds.automatic_variance() if variance is None else variance
    looks = Appearance(rgb, relative, 0.06)
    return grow_regions(MESH, LINKED, looks, seeds.accepted(seed_colour, variance), variance, colour)


def test_a_painted_panel_is_a_region_and_the_wall_another():
    labels = grow(painted())
    assert len(np.unique(labels[labels > 0])) == 2
    assert same(labels, PANEL)


def test_a_panel_in_noisy_colours_is_found_with_the_derived_variance():
    assert same(grow(painted(noise=15.0)), PANEL)


def test_growing_takes_no_colour_farther_from_the_mean_than_tr2():
    near, far = WHITE - 30, WHITE - 50
    assert same(grow(painted(panel=far), colour=60), PANEL)
    assert grow(painted(panel=near), colour=60).max() == 1
    assert same(grow(painted(panel=near), colour=40), PANEL)


def test_colour_does_not_chain_through_a_gradient():
    fall = np.clip((POINTS[:, 0] - 0.5) / 2, 0, 1)
    rgb = (WHITE - 160 * fall[:, None]).astype(np.float32)
    labels = grow(rgb)
    assert len(np.unique(labels)) > 2
    for region in np.unique(labels[labels > 0]):
        assert np.ptp(rgb[labels == region, 0]) < 2 * 60


def test_intensity_keeps_a_lit_dark_panel_from_a_light_wall_in_the_shade():
    rgb = np.where(SHADE[:, None], 0.4 * WHITE, WHITE)
    rgb = np.where(PANEL[:, None], np.where(SHADE[:, None], 0.4, 1.0) * (WHITE * 0.42), rgb).astype(
        np.float32
    )
    labels = grow(rgb, relative=reflecting())
    for region in np.unique(labels[labels > 0]):
        share = PANEL[labels == region].mean()
        assert share > 0.99 or share < 0.01


def test_points_of_small_regions_join_the_neighbouring_region_of_the_nearest_colour():
    rgb = painted(noise=0.0)
    labels = np.where(PANEL, 2, 1).astype(np.int32)
    at_the_border = np.hypot(*(POINTS - (1.01, 0.81)).T) < 0.001, np.hypot(*(POINTS - (0.99, 1.01)).T) < 0.001
    for point in at_the_border:
        assert point.sum() == 1
        labels[point] = 3

    absorbed = absorb(MESH, LINKED, rgb, labels, np.array([False, True, True, False]))

    np.testing.assert_array_equal(absorbed, np.where(PANEL, 2, 1))


def test_points_that_no_region_reaches_remain_outside_all_regions():
    labels = np.zeros(len(POINTS), np.int32)
    assert (absorb(MESH, LINKED, painted(), labels, np.array([False])) == NONE).all()
