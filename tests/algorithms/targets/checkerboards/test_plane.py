"""The plane of a target."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.checkerboards.plane import fit_plane
from ichnograph.algorithms.targets.checkerboards.settings import PlaneSettings

NORMAL = np.array([0.9, 0.3, 0.2]) / np.linalg.norm([0.9, 0.3, 0.2])


def seen(count=400, noise=0.001, dark_noise=0.003, step=0.0, seed=1):
    """Return rays, ranges and colours of a plane 8 m away."""
    rng = np.random.default_rng(seed)
    rays = np.column_stack([np.ones(count), rng.uniform(-0.008, 0.008, (count, 2))])
    rays /= np.linalg.norm(rays, axis=1)[:, None]
    dark = rng.random(count) < 0.5
    true = 8.0 * NORMAL[0] / (rays @ NORMAL)
    noise = rng.normal(0, 1, count) * np.where(dark, dark_noise, noise)
    return rays, true + noise + step * dark, dark


def test_the_plane_is_that_of_white_whatever_black_is_measured():
    rays, ranges, dark = seen(step=0.01)
    plane = fit_plane(rays, ranges, dark, PlaneSettings())

    met = np.linalg.norm(plane.meets(np.array([1.0, 0.0, 0.0])))
    assert met == pytest.approx(8.0, abs=4 * plane.range_std(np.array([1.0, 0.0, 0.0])))
    assert plane.step == pytest.approx(0.01, abs=0.001)


def test_each_colour_has_its_own_scatter():
    plane = fit_plane(*seen(2000), PlaneSettings())

    assert plane.sigmas == pytest.approx((0.003, 0.001), rel=0.15)


def test_what_stands_before_the_target_is_left_out():
    rays, ranges, dark = seen()
    ranges[:80] -= 0.3
    plane = fit_plane(rays, ranges, dark, PlaneSettings())

    assert not np.any(plane.kept[:80])
    assert np.linalg.norm(plane.meets(np.array([1.0, 0.0, 0.0]))) == pytest.approx(8.0, abs=0.001)


def test_the_stated_standard_deviation_is_that_of_many_fits():
    ray = np.array([1.0, 0.0, 0.0])
    fits = [fit_plane(*seen(seed=seed), PlaneSettings()) for seed in range(60)]
    errors = [(np.linalg.norm(plane.meets(ray)) - 8.0) / plane.range_std(ray) for plane in fits]

    assert 0.75 < np.std(errors) < 1.25


def test_the_incidence_is_the_angle_between_ray_and_normal():
    plane = fit_plane(*seen(noise=0.0, dark_noise=0.0), PlaneSettings())

    assert plane.incidence_deg(np.array([2.0, 0.0, 0.0])) == pytest.approx(
        np.degrees(np.arccos(NORMAL[0])), abs=0.1
    )


def test_a_few_points_on_white_are_no_plane():
    rays, ranges, _ = seen(10)

    assert fit_plane(rays, ranges, np.arange(10) > 2, PlaneSettings()) is None


def test_scattered_points_are_no_plane():
    rays, ranges, dark = seen(noise=0.1, dark_noise=0.1)

    assert fit_plane(rays, ranges, dark, PlaneSettings()) is None
