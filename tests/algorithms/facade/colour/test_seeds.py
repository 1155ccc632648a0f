"""Seeds of regions: what the thresholds td, tr and Vr of the paper do."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.colour.seeds import find_seeds
from ichnograph.algorithms.facade.colour.settings import SeedSettings
from ichnograph.tests.algorithms.facade.colour.panel import PANEL, POINTS, painted, same
from ichnograph.tests.algorithms.facade.samples import lattice


def test_no_seed_is_farther_from_the_mean_of_its_surface_than_tr():
    seeds = find_seeds(POINTS, painted(noise=8.0), 0.2)
    assert seeds.accepted(30.0, 1e9).shifts.max() < 30
    assert 0 < len(seeds.accepted(5.0, 1e9).rows) < len(seeds.accepted(30.0, 1e9).rows)


def test_no_seed_surface_varies_more_than_vr():
    seeds = find_seeds(POINTS, painted(noise=4.0), 0.2)
    accepted = seeds.accepted(30.0, 200.0)
    assert accepted.variances.max() < 200
    on_the_edge = ~same(PANEL.astype(int), PANEL) | (np.abs(POINTS[accepted.rows, 0] - 1.0) < 0.01)
    assert not (on_the_edge & (accepted.radii > 0.15)).any()


def test_seed_surfaces_are_not_larger_than_td():
    assert find_seeds(POINTS, painted(), 0.2).radii.max() == 0.2
    assert find_seeds(POINTS, painted(), 0.08).radii.max() == 0.08


def test_the_variance_is_that_of_the_paper_or_twice_the_noise():
    assert find_seeds(POINTS, painted(noise=2.0), 0.2).automatic_variance() == SeedSettings().variance == 200
    noisy = find_seeds(POINTS, painted(noise=15.0), 0.2).automatic_variance()
    assert noisy == pytest.approx(2 * 3 * 15.0**2, rel=0.1)


def test_a_surface_of_fewer_points_than_required_has_no_seed():
    sparse, rgb = lattice(0, 0, 2, 2, 0.2), np.full((100, 3), 100, np.float32)

    assert np.isinf(find_seeds(sparse, rgb, 0.2).variances).all()
    assert np.isfinite(find_seeds(sparse, rgb, 0.2, SeedSettings(fewest_points=1)).variances).all()


def test_the_largest_and_most_uniform_surfaces_are_tried_first():
    seeds = find_seeds(POINTS, painted(), 0.2).accepted(30.0, 200.0)

    assert (np.diff(seeds.radii) <= 0).all()
    for radius in np.unique(seeds.radii):
        assert (np.diff(seeds.variances[seeds.radii == radius]) >= 0).all()
