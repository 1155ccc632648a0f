"""The surface of a wall follows its lean and bulge, and not what is in front of it or behind."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.openings.wall_surface import fit_surface
from ichnograph.tests.algorithms.facade.samples import at, lattice

MOST = 0.05


def bulging(noise, seed=0):
    points = at(lattice(0, 0, 6, 5, 0.05))
    u, v = points[:, :2].T
    points[:, 2] = 0.01 * v - 0.003 * (u - 3) ** 2
    points[:, 2] += np.random.default_rng(seed).normal(0, noise, len(points))
    return points


def test_a_leaning_and_bulging_wall_is_followed():
    wall = bulging(0.002)
    surface = fit_surface(wall, MOST)

    assert np.abs(surface.above(wall)).max() < 0.012
    assert surface.tolerance == 0.015
    assert surface.roughness == pytest.approx(0.006, rel=0.2)


def test_points_of_recesses_do_not_draw_the_surface():
    wall = bulging(0.002)
    wall[::5, 2] -= 0.04
    surface = fit_surface(wall, MOST)

    assert np.median(np.abs(surface.above(bulging(0)))) < 0.004


@pytest.mark.parametrize(("noise", "tolerance"), [(0.001, 0.015), (0.01, 0.03), (0.04, 0.05)])
def test_the_tolerance_is_three_sigma_within_its_limits(noise, tolerance):
    assert fit_surface(bulging(noise), MOST).tolerance == pytest.approx(tolerance, rel=0.08)


def test_beyond_the_wall_its_surface_does_not_curve_away():
    surface = fit_surface(bulging(0.001), MOST)
    assert surface.at(np.array([(60.0, 2.0)])) == pytest.approx(surface.at(np.array([(6.0, 2.0)])), abs=0.002)
