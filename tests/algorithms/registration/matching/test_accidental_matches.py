"""The expected number of accidental matches beside counted ones, and its closed form."""

from math import comb, pi

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.control_network import ControlNetwork
from ichnograph.algorithms.registration.matching.accidental_matches import AccidentalMatches
from ichnograph.algorithms.registration.matching.control_points import ControlPoints
from ichnograph.algorithms.registration.matching.matching_matrix import matching_matrix, seeds
from ichnograph.algorithms.registration.settings import Model, Settings

SIDE = np.array([20.0, 15.0, 8.0])
MANY = 1e9
"""A misfit that every match within the limits has at most."""


def control_points(xyz, sigma=0.02):
    names = tuple(map(str, range(len(xyz))))
    return ControlPoints.of_network(ControlNetwork.of_surveyed(names, xyz, 0.0), Settings(sigma=sigma))


def random_case(seed, points=25, targets=8, sigma=0.02):
    random = np.random.default_rng(seed)
    return control_points(random.random((points, 3)) * SIDE, sigma), random.random((targets, 3)) * SIDE


def counted_triangles(control, targets):
    allowed = np.ones((len(targets), len(control.points)), bool)
    matrix = matching_matrix(control, targets, allowed, levelled=False)
    return sum(len(part) for last in range(2, len(targets)) for part in seeds(matrix, last, Model.RIGID))


def test_as_many_triangles_match_by_accident_as_expected():
    # Unrelated points and targets: three targets match if their three distances agree with those of points.
    # Distances of a triangle are not quite independent, so that the expectation is a little too small.
    cases = [random_case(seed, sigma=0.05) for seed in range(60)]
    counted = np.mean([counted_triangles(*case) for case in cases])
    expected = np.mean([AccidentalMatches(*case, Model.RIGID).expected(3, MANY) for case in cases])

    assert counted > 20, "enough to compare"
    assert counted / 1.6 < expected < counted * 1.1


def test_the_expected_number_is_that_of_ways_times_the_probability_of_distances():
    # C(n, k) N! / (N - k)! ways to lay k of n targets on N points; each redundant coordinate agrees with the
    # probability p that a distance does, so that two numbers k give p.
    control, targets = random_case(1)
    accidents = AccidentalMatches(control, targets, Model.RIGID)

    def ways(k):
        return comb(8, k) * np.prod([25.0 - number for number in range(k)])

    p = (accidents.expected(3, MANY) / ways(3)) ** (1 / 3)
    assert 0 < p < 0.05
    assert accidents.expected(4, MANY) == pytest.approx(ways(4) * p**6)
    assert accidents.expected(5, MANY) == pytest.approx(ways(5) * p**9)


def test_a_match_that_fits_better_is_rarer_by_the_volume_of_its_residuals():
    control, targets = random_case(2)
    accidents = AccidentalMatches(control, targets, Model.RIGID)
    # With 3 redundant coordinates: a ball of radius sqrt(misfit) in a cube of the width of both limits.
    misfit = 1.0
    share = 4 / 3 * pi * misfit**1.5 / (2 * control.factor) ** 3

    assert accidents.expected(3, misfit) == pytest.approx(share * accidents.expected(3, MANY))


def test_noise_and_more_points_make_accidents_more_probable_and_more_targets_less():
    def expected(matched=4, **changes):
        return AccidentalMatches(*random_case(3, **changes), Model.RIGID).expected(matched, MANY)

    assert expected(sigma=0.01) < expected(sigma=0.02)
    assert expected(points=25) < expected(points=100)
    assert expected(matched=5) < expected(matched=4)


def test_heights_that_must_agree_make_levelled_accidents_rarer_than_their_two_targets_suggest():
    case = random_case(4)
    levelled, rigid = (AccidentalMatches(*case, model) for model in (Model.LEVELLED, Model.RIGID))

    assert levelled.expected(3, MANY) < rigid.expected(3, MANY)


def test_regular_distances_are_repeated():
    raster = np.array([[x, y, 0.0] for x in range(5) for y in range(4)]) * 5.0
    regular = AccidentalMatches(control_points(raster), raster[:4], Model.RIGID)
    random = AccidentalMatches(*random_case(5), Model.RIGID)

    assert regular.repetition(np.arange(4)) > 10 * random.repetition(np.arange(4))


def test_the_least_number_is_the_first_that_cannot_be_accidental():
    control, targets = random_case(6, points=100, targets=10)
    accidents = AccidentalMatches(control, targets, Model.RIGID)
    least = accidents.least(3)

    assert 4 <= least <= 7
    assert not accidents.may_explain(least, 3 * least - 6)
    assert accidents.may_explain(least - 1, 3 * (least - 1) - 6)


def test_three_targets_among_three_hundred_points_are_never_enough():
    control, targets = random_case(7, points=300, targets=3)

    assert AccidentalMatches(control, targets, Model.RIGID).least(3) == 4, "one more than there are targets"
