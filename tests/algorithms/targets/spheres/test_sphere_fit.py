"""The fit of a sphere."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.spheres.settings import FitSettings
from ichnograph.algorithms.targets.spheres.sphere_fit import fit_sphere

CENTRE = np.array([6.0, 1.0, 0.5])
RADIUS = 0.0725


def seen(noise=0.001, count=900, seed=1):
    """Return rays and ranges of a sphere before nothing."""
    rng = np.random.default_rng(seed)
    distance = np.linalg.norm(CENTRE)
    rays = CENTRE / distance + rng.uniform(-RADIUS, RADIUS, (count, 3)) / distance
    rays /= np.linalg.norm(rays, axis=1)[:, None]
    along = rays @ CENTRE
    inside = along**2 - CENTRE @ CENTRE + RADIUS**2
    rays, along, inside = (values[inside > 0] for values in (rays, along, inside))
    return rays, along - np.sqrt(inside) + rng.normal(0, noise, len(rays))


def fitted(rays, ranges, free=True):
    start = CENTRE + [0.01, -0.02, 0.01]
    return fit_sphere(rays, ranges, start, RADIUS if not free else 0.06, FitSettings(), free)


def test_centre_and_radius_are_exact_without_noise():
    fit = fitted(*seen(noise=0.0))

    np.testing.assert_allclose(fit.centre, CENTRE, atol=1e-5)
    assert fit.radius == pytest.approx(RADIUS, abs=1e-5)


def test_the_far_rim_has_no_weight():
    rays, ranges = seen()
    fit = fitted(rays, ranges)
    normals = (rays * ranges[:, None] - CENTRE) / RADIUS
    incidence = np.degrees(np.arccos(np.clip(-np.sum(normals * rays, axis=1), -1, 1)))

    assert not np.any(fit.used[incidence > 66])
    assert np.mean(fit.used[incidence < 50]) > 0.95


def test_mixed_points_behind_it_do_not_move_it():
    rays, ranges = seen()
    ranges[::7] += np.linspace(0.05, 0.5, len(ranges[::7]))
    fit = fitted(rays, ranges, free=False)

    np.testing.assert_allclose(fit.centre, CENTRE, atol=0.0005)


@pytest.mark.parametrize("free", [True, False])
def test_the_covariance_is_that_of_many_fits(free):
    squares = []
    for seed in range(60):
        fit = fitted(*seen(seed=seed, count=300), free)
        away = fit.centre - CENTRE
        squares.append(away @ np.linalg.solve(fit.covariance[:3, :3], away))

    # The mean of a chi-square with three degrees of freedom.
    assert 2.0 < np.mean(squares) < 4.5


def test_a_plane_has_no_sphere_of_that_size():
    rays, _ = seen()
    fit = fitted(rays, 6.0 / rays[:, 0])

    assert fit is None or fit.sigma > 0.003 or abs(fit.radius - RADIUS) > 0.02
