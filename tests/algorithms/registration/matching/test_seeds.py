"""Seeds: which there are, which are wide enough, and how many targets they match at most."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.matching.seeds import are_wide, matched_at_most, seed_sets
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import space

COUNT = len(HALL)


@pytest.mark.parametrize("model", Model)
@pytest.mark.parametrize("matching", Matching)
def test_the_true_seeds_are_among_them(model, matching):
    scale = 0.4 if model is Model.UNKNOWN_SCALE else 1.0
    targets = scanned(HALL, scale=scale)[0]
    allowed = np.eye(COUNT, dtype=bool) if matching is Matching.NAMES else None
    found = space(HALL, targets, Settings(matching=matching, model=model), allowed)
    matrix = None if found.settings.free_scale else found.matrix(model.least_targets)
    seeds = {tuple(sorted(seed)) for _, nodes in seed_sets(found, matrix) for seed in nodes.tolist()}
    own = [row * COUNT + row for row in range(COUNT)]

    assert tuple(own[: model.least_targets]) in seeds
    assert tuple(own[-model.least_targets :]) in seeds


def test_narrow_seeds_are_not_wide():
    found = space(HALL, HALL, Settings(sigma=0.003))
    narrow = [[0.0, 0, 0], [8, 0, 0], [4, 0.2, 0]]
    wide = [[0.0, 0, 0], [8, 0, 0], [4, 0.4, 0]]

    assert 0.2 < found.width < 0.4
    assert are_wide(found, np.array([narrow, wide])).tolist() == [False, True]


def test_a_levelled_seed_is_wide_if_its_targets_are_not_above_each_other():
    found = space(HALL, HALL, Settings(model=Model.LEVELLED))
    above, beside = [[0.0, 0, 0], [0.1, 0, 3]], [[0.0, 0, 0], [2, 0, 3]]

    assert are_wide(found, np.array([above, beside])).tolist() == [False, True]


def test_a_true_seed_matches_all_targets_and_a_wrong_one_few():
    targets = scanned(HALL, noise=0.002)[0]
    found = space(HALL, targets)
    mine = np.array([[0, 1, 2], [0, 1, 2]])
    theirs = np.array([[0, 1, 2], [3, 6, 4]])
    poses = fit_pose(HALL[theirs], targets[mine], Model.RIGID)

    true, wrong = matched_at_most(found, poses, mine, theirs)
    assert true == COUNT
    assert wrong < 5


def test_no_seeds_match_nothing():
    nothing = np.empty((0, 3), int)
    poses = fit_pose(HALL[nothing], HALL[nothing], Model.RIGID)

    assert matched_at_most(space(HALL, HALL), poses, nothing, nothing).shape == (0,)
