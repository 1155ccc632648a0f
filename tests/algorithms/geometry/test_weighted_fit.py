"""Weighted linear least squares."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.geometry.weighted_fit import weighted_fit

LINE = np.column_stack([np.ones(5), np.arange(5.0)])


def test_observations_count_by_their_weights():
    solution, inverse = weighted_fit(np.ones((2, 1)), np.array([1.0, 4.0]), np.array([2.0, 1.0]))

    assert solution == pytest.approx([2.0])
    assert inverse == pytest.approx(np.array([[1 / 3]]))


def test_an_observation_without_weight_changes_nothing():
    observed = 3.0 + 0.5 * LINE[:, 1]
    observed[2] = 99.0
    solution, _ = weighted_fit(LINE, observed, np.array([1.0, 1.0, 0.0, 1.0, 1.0]))

    assert solution == pytest.approx([3.0, 0.5])


def test_the_inverse_is_the_covariance_if_weights_are_inverse_variances():
    random, stds = np.random.default_rng(0), np.array([0.1, 0.2, 0.1, 0.3, 0.1])
    found = [weighted_fit(LINE, random.normal(0.0, stds), stds**-2.0) for _ in range(4000)]
    solutions = np.array([solution for solution, _ in found])

    assert np.cov(solutions.T) == pytest.approx(found[0][1], rel=0.1)


@given(st.floats(0.01, 100.0))
def test_a_common_factor_of_the_weights_does_not_move_the_solution(factor):
    observed, weights = np.array([1.0, 0.0, 2.0, 5.0, 1.0]), np.array([1.0, 2.0, 3.0, 2.0, 1.0])

    assert weighted_fit(LINE, observed, factor * weights)[0] == pytest.approx(
        weighted_fit(LINE, observed, weights)[0]
    )


def test_unknowns_that_nothing_determines_are_the_smallest():
    solution, _ = weighted_fit(np.array([[1.0, 1.0]]), np.array([2.0]), np.ones(1))

    assert solution == pytest.approx([1.0, 1.0])
