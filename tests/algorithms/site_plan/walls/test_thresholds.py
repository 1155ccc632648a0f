"""Thresholds come from the density of the horizontal surfaces, unless they are given."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.site_plan.walls.thresholds import choose_thresholds

RANDOM = np.random.default_rng(0)


def image():
    """Build a floor of about 3 points per pixel and a wall of about 50."""
    density = RANDOM.normal(3.0, 0.4, (100, 100))
    density[40:42] = RANDOM.normal(50.0, 5.0, (2, 100))
    wall = np.zeros(density.shape, bool)
    wall[40:42] = True
    return density, wall


def test_given_thresholds_are_used_as_they_are():
    density, wall = image()
    thresholds = choose_thresholds(density, ~wall, wall, 0.5, 2.0, 4)
    assert thresholds.values == pytest.approx((0.5, 1.0, 1.5, 2.0))
    assert thresholds.deviation == pytest.approx(density.std())


def test_a_highest_below_the_lowest_is_refused():
    density, wall = image()
    with pytest.raises(InputError, match="THRESHOLD_MAX 1 is below THRESHOLD 2"):
        choose_thresholds(density, ~wall, wall, 2.0, 1.0, 4)


def test_behind_the_gate_the_lowest_is_the_usual_density_of_a_floor():
    density, wall = image()
    thresholds = choose_thresholds(density, ~wall, wall, None, None, 10)
    assert thresholds.values[0] * thresholds.deviation == pytest.approx(3.0, abs=0.2)
    assert thresholds.values[-1] * thresholds.deviation == pytest.approx(50.0, rel=0.05)


def test_without_a_gate_the_lowest_parts_the_floor_from_the_rest():
    density, wall = image()
    thresholds = choose_thresholds(density, ~wall, np.ones(wall.shape, bool), None, None, 10)
    lowest = thresholds.values[0] * thresholds.deviation
    assert np.mean(density[~wall] > lowest) < 0.02
    assert np.mean(density[wall] > lowest) > 0.98


def test_with_density_alone_the_lowest_parts_the_two_populations():
    density, wall = image()
    everywhere = np.ones(wall.shape, bool)
    thresholds = choose_thresholds(density, everywhere, everywhere, None, None, 10)
    assert 4.5 < thresholds.values[0] * thresholds.deviation < 40.0


def test_a_uniform_image_has_thresholds_too():
    density = np.full((5, 5), 2.0)
    thresholds = choose_thresholds(density, density < 0, density > 0, None, None, 3)
    assert np.isfinite(thresholds.values).all()
    assert thresholds.deviation > 0


def test_pixels_without_density_do_not_count():
    density, wall = image()
    wide = np.full((300, 300), np.nan)
    wide[:100, :100] = density
    flat, tall = np.zeros((2, 300, 300), bool)
    flat[:100, :100], tall[:100, :100] = ~wall, wall
    assert choose_thresholds(wide, flat, tall, None, None, 5) == choose_thresholds(
        density, ~wall, wall, None, None, 5
    )
