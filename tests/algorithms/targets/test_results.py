"""What the search returns."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.results import Kind, Rejection
from ichnograph.tests.algorithms.targets.made_targets import search, station, target


def test_the_standard_deviation_is_that_in_space():
    assert target().std == pytest.approx(np.sqrt(14e-6))


def test_only_targets_without_doubt_are_counted():
    found = search(station("hall", target(), target(doubt="few points")), station("attic", target()))

    assert found.count == 2


def test_a_place_is_in_the_coordinates_of_the_file():
    hall = station("hall", target((1.0, 2.0, 3.0)))

    np.testing.assert_array_equal(hall.place(hall.targets[0]), [101.0, 202.0, 13.0])


@pytest.mark.parametrize(("value", "limit"), [(10.0, 5.0), (5.0, 10.0)])
def test_a_miss_is_the_ratio_of_value_and_limit(value, limit):
    assert Rejection(Kind.SPHERE, np.zeros(3), "scatter", 0, value, limit).miss == 2.0


def test_places_and_covariances_are_those_of_the_targets_without_doubt():
    found = station("hall", target((1.0, 2.0, 3.0)), target(doubt="few points"))

    assert found.places.tolist() == [[101.0, 202.0, 13.0]]
    assert np.array_equal(found.covariances, target().covariance[None])
    assert station("attic").places.shape == (0, 3) and station("attic").covariances.shape == (0, 3, 3)
