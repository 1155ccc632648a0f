"""The tests of an adjustment beside published tables."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.settings import OutlierTestSettings
from ichnograph.algorithms.registration.adjustment.statistical_tests import (
    critical_tau,
    detectable_biases,
    divided,
    global_test,
    normalized_residuals,
    spread_factor,
    worst_target,
)
from scipy import stats

ONE = np.ones(1)


def at_level(significance, power=0.80):
    return OutlierTestSettings(significance=significance, power=power)


def test_baardas_critical_value_and_noncentrality():
    # Baarda (1968), A testing procedure for use in geodetic networks: alpha0 = 0.001, beta0 = 0.80 give the
    # critical value 3.29, delta0 = 4.13 and lambda0 = 17.07.
    tests = OutlierTestSettings()

    assert round(tests.critical_w, 2) == 3.29
    assert round(tests.noncentrality, 2) == 4.13
    assert round(tests.noncentrality**2, 2) == 17.07


@pytest.mark.parametrize(
    ("alpha", "power", "delta0"),
    [(0.05, 0.80, 2.80), (0.01, 0.80, 3.42), (0.001, 0.80, 4.13), (0.05, 0.90, 3.24), (0.001, 0.90, 4.57)],
)
def test_noncentrality_for_other_levels(alpha, power, delta0):
    # The table of delta0 in textbooks of reliability, for example Foerstner (1987), Reliability analysis.
    assert round(at_level(alpha, power).noncentrality, 2) == delta0


@pytest.mark.parametrize(
    ("redundancy", "quantile", "alpha"),
    [
        *[(1, 3.841, 0.05), (5, 11.070, 0.05), (10, 18.307, 0.05), (14, 23.685, 0.05), (30, 43.773, 0.05)],
        *[(1, 10.828, 0.001), (5, 20.515, 0.001), (10, 29.588, 0.001), (20, 45.315, 0.001)],
    ],
)
def test_the_global_test_agrees_with_tables_of_chi_square(redundancy, quantile, alpha):
    # Fisher and Yates (1963), Statistical tables, table IV.
    test = global_test(quantile, redundancy)

    assert test.probability == pytest.approx(alpha, rel=2e-3)
    assert test.sigma0 == pytest.approx(np.sqrt(quantile / redundancy))


def test_without_redundancy_nothing_is_tested():
    test = global_test(0.3, 0.0)

    assert np.isnan(test.sigma0) and np.isnan(test.probability)
    assert spread_factor(test) == 1.0
    assert spread_factor(global_test(8.0, 2.0)) == 2.0


@pytest.mark.parametrize(
    ("observations", "tau"),
    [
        *[(3, 1.1511), (4, 1.4250), (5, 1.5712), (6, 1.6563), (7, 1.7110), (8, 1.7491)],
        *[(9, 1.7770), (10, 1.7984), (11, 1.8153), (12, 1.8290), (15, 1.8579)],
    ],
)
def test_critical_tau_agrees_with_thompsons_table(observations, tau):
    # The table of Thompson's tau for alpha = 0.05, as ASME PTC 19.1 and Wheeler and Ganji (Introduction to
    # engineering experimentation) print it. It holds for the residuals of a mean, whose redundancy numbers
    # are (n - 1) / n.
    redundancy = observations - 1
    number = redundancy / observations

    assert round(critical_tau(redundancy, at_level(0.05)) * np.sqrt(number), 4) == tau


@pytest.mark.parametrize("alpha", [0.001, 0.01, 0.05])
def test_critical_tau_agrees_with_popes_closed_forms(alpha):
    # Pope (1976), The statistics of residuals and the detection of outliers: tau of redundancy 2 has the
    # arcsine distribution, that of 3 is uniform, and that of many is normal.
    tests = at_level(alpha)

    assert critical_tau(2, tests) == pytest.approx(np.sqrt(2) * np.sin(np.pi / 2 * (1 - alpha)))
    assert critical_tau(3, tests) == pytest.approx(np.sqrt(3) * (1 - alpha))
    assert critical_tau(1e7, tests) == pytest.approx(stats.norm.isf(alpha / 2), rel=1e-5)
    assert np.isinf(critical_tau(1, tests))


def test_critical_tau_leaves_the_stated_share_of_residuals_beyond():
    # Pope's tau of the residuals of a mean of six observations.
    random = np.random.default_rng(0)
    values = random.normal(size=(40_000, 6))
    residuals = values - values.mean(axis=1, keepdims=True)
    sigma0 = np.sqrt((residuals**2).sum(axis=1) / 5)
    tau = residuals[:, 0] / (sigma0 * np.sqrt(5 / 6))

    assert (np.abs(tau) > critical_tau(5, at_level(0.05))).mean() == pytest.approx(0.05, abs=0.004)


def test_w_is_the_residual_over_its_own_standard_deviation():
    w = normalized_residuals(np.array([2.0, -3.0, 1e-9]), np.array([0.25, 1.0, 1e-12]), ONE)

    assert w[:2] == pytest.approx([4.0, -3.0])
    assert np.isnan(w[2])


@pytest.mark.parametrize(("redundancy", "factor"), [(1.0, 4.13), (0.25, 8.26), (0.1, 13.07), (0.01, 41.32)])
def test_minimal_detectable_biases_grow_with_small_redundancy_numbers(redundancy, factor):
    # Baarda: sigma delta0 / sqrt(r).
    bias = detectable_biases(np.array([redundancy / 0.003**2]), np.array([0.003**-2]))

    assert bias[0] == pytest.approx(0.003 * factor, rel=1e-3)
    assert np.isnan(detectable_biases(np.array([0.0]), np.array([0.003**-2]))[0])


def test_a_bias_of_the_minimal_detectable_size_is_found_with_the_stated_power():
    tests, random = OutlierTestSettings(), np.random.default_rng(1)
    number = 5 / 6
    bias = detectable_biases(np.array([number]), np.array([1.0]))[0]
    values = random.normal(size=(40_000, 6))
    values[:, 0] += bias
    w = (values - values.mean(axis=1, keepdims=True))[:, 0] / np.sqrt(number)

    assert (np.abs(w) > tests.critical_w).mean() == pytest.approx(0.80, abs=0.01)


def test_a_target_is_suspected_only_if_both_tests_agree():
    normalized = np.array([[0.5, -1.0, 0.2], [0.1, 6.0, np.nan], [1.0, 0.3, 0.2]])

    assert worst_target(normalized, sigma0=1.0, redundancy=12.0) == 1
    assert worst_target(normalized, sigma0=2.5, redundancy=12.0) is None, "SIGMA was underestimated"
    assert worst_target(0.5 * normalized, sigma0=0.2, redundancy=12.0) is None, "w is small"
    assert worst_target(normalized, sigma0=1.0, redundancy=1.0) is None, "every |tau| is 1"


def test_division_by_zero_gives_unknown():
    assert np.array_equal(
        divided(np.ones(3), np.array([2.0, 0.0, -1.0])), [0.5, np.nan, np.nan], equal_nan=True
    )
