"""Solutions: what contradicts, what supports, and which are kept."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.similarity import Pose
from ichnograph.algorithms.registration.matching.settings import SearchSettings
from ichnograph.algorithms.registration.matching.solution import Solution, enough, with_solution

POSE = Pose(np.eye(3), np.ones(()), np.zeros(3), np.zeros(3))
SETTINGS = SearchSettings(most_solutions=3, slack_targets=2)


def solution(*labels, misfit=1.0, gaps=None):
    labels = np.array(labels)
    return Solution(labels, POSE, misfit, np.full(len(labels), np.inf) if gaps is None else np.array(gaps))


def test_targets_near_their_points_support_a_solution():
    item = solution(4, 2, -1, -1, gaps=[np.inf, np.inf, 1.2, 2.0])

    assert item.matched == 2
    assert [item.support(width) for width in (1.0, 1.5, 2.0)] == [2, 3, 4]


@pytest.mark.parametrize(
    ("other", "contradicts"),
    [
        ((0, 1, 2, -1), False),
        ((0, 1, 2, 3), False),
        ((0, 1, 3, -1), True),
        ((0, 1, -1, -1), True),
        ((-1, -1, -1, 5), True),
    ],
)
def test_solutions_agree_if_enough_targets_have_the_same_points_and_none_another(other, contradicts):
    assert solution(0, 1, 2, -1).contradicts(solution(*other), 3) == contradicts


def test_solutions_that_match_little_less_than_the_best_are_worth_keeping():
    assert enough([], 3, SETTINGS) == 3
    assert enough([solution(0, 1, 2, 3, 4, 5)], 3, SETTINGS) == 4
    assert enough([solution(0, 1, 2, 3, -1, -1)], 3, SETTINGS) == 3


def test_with_too_many_solutions_only_better_ones_are_worth_keeping():
    equal = [solution(row, row + 1, row + 2) for row in range(3)]
    fewer = [solution(row, row + 1, -1) for row in range(3)]

    assert enough(equal, 1, SETTINGS) == 4
    assert enough([solution(0, 1, 2), *fewer], 1, SETTINGS) == 3


def test_a_better_solution_replaces_what_it_extends_and_what_matches_far_less():
    partial, few = solution(0, 1, 2, -1, -1, -1), solution(7, 8, 9, -1, -1, -1)
    rival = solution(5, 4, 3, 2, -1, -1)
    best = solution(0, 1, 2, 3, 4, 5)
    kept = with_solution(best, [partial, rival, few], 3, 3, SETTINGS)

    assert kept == [rival, best]


def test_a_solution_that_another_extends_is_not_kept():
    best = solution(0, 1, 2, 3, 4)

    assert with_solution(solution(0, 1, 2, 3, -1), [best], 3, 3, SETTINGS) == [best]
