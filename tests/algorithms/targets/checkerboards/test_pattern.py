"""The pattern of a target."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.targets.checkerboards.pattern import Pattern, first_pattern, fit_pattern
from ichnograph.algorithms.targets.checkerboards.settings import PatternSettings


def made(centre=(0.002, -0.001), turn=0.4, blur=0.002, spacing=0.002, noise=300.0, seed=1, radius=0.05):
    """Return places and intensities of a pattern of black 1000 and white 21 000."""
    rng = np.random.default_rng(seed)
    line = np.arange(-radius, radius, spacing)
    places = np.stack(np.meshgrid(line, line), axis=-1).reshape(-1, 2) + rng.uniform(0, spacing, 2)
    places = places[np.hypot(*places.T) < radius]
    truth = Pattern(np.array(centre), (turn, turn + np.pi / 2), blur, 11000.0, -10000.0, np.zeros((2, 2)))
    return places, truth.intensities(places) + rng.normal(0, noise, len(places))


def fitted(places, intensities):
    return fit_pattern(first_pattern(places, intensities, 0.004), places, intensities, PatternSettings())


@settings(max_examples=20, deadline=None)
@given(st.floats(0, 3.1), st.floats(-0.004, 0.004), st.floats(-0.004, 0.004))
def test_the_centre_is_found_at_any_rotation(turn, u, v):
    pattern = fitted(*made((u, v), turn))

    np.testing.assert_allclose(pattern.centre, [u, v], atol=2e-4)


def test_blur_and_intensities_are_found():
    pattern = fitted(*made())

    assert pattern.blur == pytest.approx(0.002, rel=0.05)
    assert (pattern.black, pattern.white) == pytest.approx((1000, 21000), abs=200)
    assert pattern.explained > 0.99


@pytest.mark.parametrize(("spacing", "noise"), [(0.002, 300.0), (0.006, 1000.0)])
def test_the_covariance_is_that_of_many_fits(spacing, noise):
    squares = []
    for seed in range(60):
        pattern = fitted(*made(spacing=spacing, noise=noise, blur=0.004, seed=seed))
        away = pattern.centre - [0.002, -0.001]
        squares.append(away @ np.linalg.solve(pattern.covariance, away))

    # The mean of a chi-square with two degrees of freedom.
    assert 1.2 < np.mean(squares) < 3.2


def test_a_stain_does_not_move_the_centre():
    places, intensities = made()
    intensities[np.hypot(*(places - [0.03, 0.01]).T) < 0.006] = 30000
    pattern = fitted(places, intensities)

    np.testing.assert_allclose(pattern.centre, [0.002, -0.001], atol=2e-4)


def test_a_single_edge_has_its_crossing_outside():
    places, _ = made()
    pattern = fitted(places, np.where(places[:, 0] > 0, 20000.0, 1000.0))

    assert np.hypot(*pattern.centre) > 0.04


def test_likeness_is_the_correlation_with_the_pattern():
    places, intensities = made(centre=(0.0, 0.0))
    pattern = first_pattern(places, intensities, 0.004)

    assert pattern.likeness(places, intensities) > 0.95
    assert pattern.likeness(places, -intensities) < -0.95
    assert pattern.likeness(places, np.ones(len(places))) == 0.0
