"""Robust estimates agree with the usual ones on normal deviates, and gross errors do not move them."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.robust import (
    sigma_about_median,
    sigma_of_residuals,
    tukey_weights,
    weighted_median,
    weighted_sigma_of_residuals,
)

NORMAL = np.random.default_rng(0).normal(0.0, 2.0, 20_001)


def test_the_standard_deviation_of_normal_deviates():
    assert sigma_about_median(NORMAL + 70) == pytest.approx(2.0, rel=0.03)
    assert sigma_of_residuals(NORMAL) == pytest.approx(2.0, rel=0.03)


def test_a_fifth_of_gross_errors_less_than_doubles_it():
    spoilt = np.concatenate([NORMAL, np.full(5_000, 1e6)])
    assert sigma_about_median(spoilt) < 4.0
    assert sigma_of_residuals(spoilt) < 4.0


def test_about_the_median_a_shift_does_not_count_but_residuals_are_about_zero():
    values = np.array([1.0, 2.0, 3.0])
    assert sigma_about_median(values + 10) == sigma_about_median(values)
    assert sigma_of_residuals(values + 10) == pytest.approx(12 * sigma_about_median(values))


def test_the_standard_deviation_along_an_axis():
    rows = np.stack([NORMAL, 3 * NORMAL])
    assert sigma_about_median(rows, axis=1) == pytest.approx([sigma_about_median(row) for row in rows])


def test_a_weighted_median_halves_the_weight():
    values, weights = np.array([5.0, 1.0, 3.0]), np.array([1.0, 1.0, 5.0])
    assert weighted_median(values, weights) == 3.0
    assert weighted_median(values, np.array([9.0, 1.0, 1.0])) == 5.0


def test_weights_count_as_repeated_residuals():
    residuals, weights = np.array([-3.0, 1.0, 2.0]), np.array([4, 1, 2])
    assert weighted_sigma_of_residuals(residuals, weights) == pytest.approx(
        sigma_of_residuals(np.repeat(residuals, weights))
    )


def test_tukey_weights_fall_from_one_to_zero_at_the_cut():
    residuals = np.array([0.0, 1.5, -1.5, 3.0, 30.0])
    assert tukey_weights(residuals, 1.0, 3.0) == pytest.approx([1.0, 0.5625, 0.5625, 0.0, 0.0])
