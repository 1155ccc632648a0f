"""Regions of one colour, and what the four thresholds of the paper do."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.colour.appearance import Appearance
from ichnograph.algorithms.facade.colour.coloured_details import divide_at_half, find_coloured
from ichnograph.algorithms.facade.colour.intensity_fusion import (
    fuse_by_intensity,
    fuse_by_soft_borders,
    largest_first,
)
from ichnograph.algorithms.facade.colour.region_growing import grow_regions
from ichnograph.algorithms.facade.colour.seeds import PAPER_VARIANCE, find_seeds
from ichnograph.algorithms.facade.settings import Settings
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.algorithms.facade.samples import lattice

STEP = 0.02
PLACES = lattice(0, 0, 3, 2, STEP)
MESH = triangulate(PLACES)
LINKED = MESH.lengths < 2 * STEP
SIZES = np.full(len(PLACES), STEP**2)
PANEL = ((PLACES > (1.0, 0.5)) & (PLACES < (1.6, 1.3))).all(axis=1)
SHADE = PLACES[:, 0] + 0.3 * PLACES[:, 1] > 1.5
WHITE, GREEN = np.array([210.0, 200, 180]), np.array([70.0, 105, 85])


def painted(noise=4.0, panel=GREEN):
    rgb = np.where(PANEL[:, None], panel, WHITE)
    return (rgb + np.random.default_rng(0).normal(0, noise, rgb.shape)).astype(np.float32)


def reflecting(panel=0.5, noise=0.03):
    values = np.where(PANEL, panel, 1.0)
    return (values * (1 + np.random.default_rng(1).normal(0, noise, len(values)))).astype(np.float32)


def grow(rgb, colour=60.0, seed_colour=30.0, variance=None, relative=None):
    seeds = find_seeds(PLACES, rgb, 0.2)
    variance = seeds.automatic_variance() if variance is None else variance
    looks = Appearance(rgb, relative, 0.06)
    return grow_regions(MESH, LINKED, looks, seeds.accepted(seed_colour, variance), variance, colour)


def found(rgb, relative, **changes):
    looks = Appearance(rgb, relative, 0.06)
    return find_coloured(MESH, LINKED, SIZES, looks, Settings(**changes))


def same(labels, chosen):
    """Tell whether a region is the chosen points."""
    return np.mean((labels == np.bincount(labels[chosen]).argmax()) == chosen) > 0.995


def test_a_painted_panel_is_a_region_and_the_wall_another():
    labels = grow(painted())
    assert len(np.unique(labels[labels > 0])) == 2
    assert same(labels, PANEL)


def test_growing_takes_no_colour_farther_from_the_mean_than_tr2():
    near, far = WHITE - 30, WHITE - 50
    assert same(grow(painted(panel=far), colour=60), PANEL)
    assert grow(painted(panel=near), colour=60).max() == 1
    assert same(grow(painted(panel=near), colour=40), PANEL)


def test_no_seed_is_farther_from_the_mean_of_its_surface_than_tr():
    seeds = find_seeds(PLACES, painted(noise=8.0), 0.2)
    assert seeds.accepted(30.0, 1e9).shifts.max() < 30
    assert 0 < len(seeds.accepted(5.0, 1e9).rows) < len(seeds.accepted(30.0, 1e9).rows)


def test_no_seed_surface_varies_more_than_vr():
    seeds = find_seeds(PLACES, painted(noise=4.0), 0.2)
    accepted = seeds.accepted(30.0, 200.0)
    assert accepted.variances.max() < 200
    on_the_edge = ~same(PANEL.astype(int), PANEL) | (np.abs(PLACES[accepted.rows, 0] - 1.0) < 0.01)
    assert not (on_the_edge & (accepted.radii > 0.15)).any()


def test_seed_surfaces_are_not_larger_than_td():
    assert find_seeds(PLACES, painted(), 0.2).radii.max() == 0.2
    assert find_seeds(PLACES, painted(), 0.08).radii.max() == 0.08


def test_the_variance_is_the_papers_unless_the_noise_asks_for_more():
    assert find_seeds(PLACES, painted(noise=2.0), 0.2).automatic_variance() == PAPER_VARIANCE
    noisy = find_seeds(PLACES, painted(noise=15.0), 0.2).automatic_variance()
    assert noisy == pytest.approx(2 * 3 * 15.0**2, rel=0.1)
    assert same(grow(painted(noise=15.0)), PANEL)


def test_colour_does_not_chain_through_a_gradient():
    fall = np.clip((PLACES[:, 0] - 0.5) / 2, 0, 1)
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


def test_a_cast_shadow_is_no_detail_but_the_panel_in_it_is():
    rgb = painted() * np.where(SHADE, 0.42, 1.0)[:, None].astype(np.float32)
    coloured = found(rgb, reflecting())
    assert coloured.labels.max() == 1
    assert np.mean((coloured.labels == 1) == PANEL) > 0.99


def test_a_gradient_of_brightness_is_no_detail_even_without_intensity():
    rgb = painted() * (1 - 0.5 * PLACES[:, :1] / 3).astype(np.float32)
    coloured = found(rgb, None)
    assert coloured.labels.max() == 1
    assert np.mean((coloured.labels == 1) == PANEL) > 0.99


def test_what_is_smaller_than_the_smallest_detail_is_none():
    assert found(painted(), reflecting(), min_area=0.6).labels.max() == 0
    assert found(painted(), reflecting(), min_area=0.4).labels.max() == 1


def test_regions_whose_intensities_differ_by_less_than_f_are_one_surface():
    labels = np.repeat([1, 2, 3], 100).astype(np.int32)
    relative = np.repeat([1.0, 0.95, 0.5], 100)
    assert len(np.unique(fuse_by_intensity(labels, relative, 0.1))) == 2
    assert len(np.unique(fuse_by_intensity(labels, relative, 0.04))) == 3


def test_fusing_does_not_chain():
    labels = np.repeat(np.arange(1, 11), 50).astype(np.int32)
    relative = np.repeat(np.linspace(1, 0.1, 10), 50)
    surfaces = fuse_by_intensity(labels, relative, 0.15)
    for surface in np.unique(surfaces):
        assert np.ptp(relative[surfaces == surface]) < 0.3


def test_soft_borders_fuse_and_sharp_ones_stay():
    labels = np.where(PANEL, 3, np.where(PLACES[:, 0] < 0.8, 1, 2)).astype(np.int32)
    assert len(np.unique(fuse_by_soft_borders(MESH, LINKED, labels, painted(noise=0.0), 30.0))) == 2


def test_the_largest_region_becomes_the_first():
    np.testing.assert_array_equal(largest_first(np.array([0, 1, 2, 2, 2, 3, 3])), [0, 3, 1, 1, 1, 2, 2])


@pytest.mark.parametrize("relative", [None, reflecting()], ids=["colour", "intensity"])
def test_points_at_the_border_go_to_the_side_they_resemble(relative):
    looks = Appearance(painted(), relative, 0.06)
    grown = ((PLACES > (0.97, 0.47)) & (PLACES < (1.63, 1.33))).all(axis=1)
    np.testing.assert_array_equal(divide_at_half(MESH, LINKED, looks, grown, STEP, 30.0), PANEL)


def test_specks_beyond_the_border_are_of_no_detail():
    rgb = painted()
    speck = ((PLACES > (1.62, 0.8)) & (PLACES < (1.66, 0.84))).all(axis=1) & (PLACES[:, 0] > 1.64)
    rgb[speck] = GREEN
    divided = divide_at_half(MESH, LINKED, Appearance(rgb), PANEL, STEP, 30.0)
    assert not divided[speck].any()
