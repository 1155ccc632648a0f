"""Rivals: solutions that match as many targets as the best one, and fit as well."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.registration.matching.matching_task import matching_task
from ichnograph.algorithms.registration.matching.rivals import as_likely, rivals_of_best, squares_of
from ichnograph.algorithms.registration.matching.settings import DecisionSettings
from ichnograph.algorithms.registration.matching.solution import Solutions
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, listed, register, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import network

LIKELY = DecisionSettings()


def task(points, targets, **chosen):
    return matching_task(listed("scan", targets), network(points), Settings(**chosen))


@pytest.mark.parametrize("redundant", [1, 3, 6, 12, 30])
def test_a_solution_is_as_likely_as_itself_and_less_so_the_worse_it_fits(redundant):
    odds = [as_likely(squares, float(redundant), redundant, LIKELY) for squares in (redundant, 400.0, np.inf)]

    assert odds == [True, False, False]


def test_a_sum_of_squares_of_192_is_no_rival_to_one_of_18():
    assert not any(as_likely(192.0, 18.0, redundant, LIKELY) for redundant in range(3, 30))


def test_where_the_noise_is_twice_sigma_a_larger_difference_is_asked_for():
    assert not as_likely(12.0 + 35, 12.0, 12, LIKELY)
    assert as_likely(48.0 + 35, 48.0, 12, LIKELY)


def test_a_solution_is_compared_with_as_many_targets_as_the_best_matches():
    places = HALL.copy()
    places[7] += [0.1, 0.0, 0.0]
    plain = task(HALL, scanned(places)[0])
    best = plain.solutions(plain.scan.xyz, Model.RIGID, 5)[0]

    assert best.matched == 7
    assert squares_of(plain, best, 7) == best.misfit < 1e-6
    assert squares_of(plain, best, 8) == pytest.approx((0.1 / 0.003) ** 2, rel=0.5)
    assert squares_of(plain, best, 9) == np.inf, "there are eight targets"


def test_by_names_only_the_point_of_the_name_joins():
    names = [f"P{row}" for row in range(1, 8)] + ["X"]
    named = matching_task(
        listed("scan", scanned(HALL)[0], names), network(HALL), Settings(matching=Matching.NAMES)
    )
    best = named.solutions(named.scan.xyz, Model.RIGID, 5)[0]

    assert squares_of(named, best, 8) == np.inf


def test_a_solution_of_fewer_targets_that_fits_far_worse_is_no_rival():
    rectangle = np.array([[0.0, 0, 0], [6, 0, 0], [6, 4, 0], [0, 4, 0], [1.0, 1.5, 3], [4.9, 2.4, 3]])
    plain = task(rectangle, scanned(rectangle)[0])
    solutions = plain.solutions(plain.scan.xyz, Model.RIGID, 4)
    fewer = replace(solutions[0], labels=np.array([2, 3, 0, 1, -1, -1]), misfit=0.0)

    assert rivals_of_best(plain, Solutions((solutions[0], fewer))) == []


def test_equally_good_solutions_are_rivals_and_by_names_the_advice_is_not_to_match_by_names():
    square = np.array([[0.0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 0]])
    reason = register(square, scanned(square)[0]).reason

    assert reason.endswith("or match by names.")
