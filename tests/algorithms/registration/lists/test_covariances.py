"""Covariances from standard deviations and correlations."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.lists.covariances import covariances_of


def test_a_covariance_has_the_stated_standard_deviations_and_correlations():
    (found,) = covariances_of(np.array([[0.001, 0.002, 0.003]]), np.array([[0.5, -0.25, 0.0]]))

    assert np.sqrt(np.diag(found)) == pytest.approx([0.001, 0.002, 0.003])
    assert found[0, 1] == found[1, 0] == pytest.approx(0.5 * 0.001 * 0.002)
    assert found[0, 2] == pytest.approx(-0.25 * 0.001 * 0.003)


def test_coordinates_without_correlations_are_not_correlated():
    (found,) = covariances_of(np.array([[0.001, 0.002, 0.003]]), np.full((1, 3), np.nan))

    assert found == pytest.approx(np.diag([1e-6, 4e-6, 9e-6]))


@pytest.mark.parametrize("stds", [(0.001, 0.0, 0.001), (0.001, np.nan, 0.001), (-0.001, 0.001, 0.001)])
def test_a_point_without_three_standard_deviations_has_no_covariance(stds):
    found = covariances_of(np.array([stds, (0.001,) * 3]), np.zeros((2, 3)))

    assert np.isnan(found[0]).all() and np.isfinite(found[1]).all()


def test_correlations_that_contradict_each_other_are_not_used():
    found = covariances_of(np.full((1, 3), 0.001), np.array([[0.9, 0.9, -0.9]]))

    assert np.isnan(found).all()
