"""From a seed to a solution."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.matching.refinement import refined
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import space

SEED = np.array([0, 1, 2])


@pytest.mark.parametrize("model", Model)
def test_a_true_seed_leads_to_all_targets(model):
    scale = 0.4 if model is Model.UNKNOWN_SCALE else 1.0
    targets = scanned(HALL, scale=scale, noise=0.001)[0]
    seed = SEED[: model.least_targets]
    solution = refined(space(HALL, targets, Settings(model=model)), seed, seed)

    assert solution.labels.tolist() == list(range(8))
    assert solution.misfit < 3 * 8
    assert np.isinf(solution.gaps).all()


def test_targets_that_are_not_control_points_stay_free_with_their_gap():
    targets = scanned(np.concatenate([HALL, [[6.0, 1.0, 2.0]]]))[0]
    solution = refined(space(HALL[:7], targets), SEED, SEED)

    assert solution.labels.tolist() == [*range(7), -1, -1]
    assert np.isinf(solution.gaps[:7]).all() and np.isinf(solution.gaps[7:]).all()


def test_a_gap_is_the_distance_of_a_target_from_the_nearest_free_point():
    places = HALL.copy()
    places[7] += [0.1, 0.0, 0.0]
    solution = refined(space(HALL, scanned(places)[0]), SEED, SEED)

    assert solution.labels[7] == -1
    assert 2 < solution.gaps[7] < 10


def test_a_wrong_target_of_the_seed_is_removed_again():
    places = HALL.copy()
    places[2] += [0.0, 0.09, 0.0]
    solution = refined(space(HALL, scanned(places)[0], Settings(sigma=0.01)), SEED, SEED)

    assert solution.labels[[0, 1, 3, 4, 5, 6, 7]].tolist() == [0, 1, 3, 4, 5, 6, 7]


def test_the_order_of_the_list_comes_back():
    targets = scanned(HALL)[0][[3, 1, 0, 2, 7, 6, 5, 4]]
    whole = space(HALL, targets)
    whole = whole.reordered(whole.matrix(3))
    seed = np.array([0, 1, 2])
    points = np.array([3, 1, 0, 2, 7, 6, 5, 4])[whole.order[seed]]

    assert refined(whole, seed, points).labels.tolist() == [3, 1, 0, 2, 7, 6, 5, 4]
