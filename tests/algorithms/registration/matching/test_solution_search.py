"""The search beside an exhaustive one."""

from itertools import permutations

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.matching.settings import MatchingSettings, SearchSettings
from ichnograph.algorithms.registration.matching.solution_search import find_solutions
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import space
from ichnograph.tests.scenes.targets import target_scene

RECTANGLE = np.array([[0.0, 0, 0], [6, 0, 0], [6, 4, 0], [0, 4, 0]])


def labels(solutions):
    return {tuple(item.labels) for item in solutions}


def exhaustive(xyz, targets, limit):
    """Return all ways to lay every target on a point with residuals below a limit."""
    found = set()
    for rows in permutations(range(len(xyz)), len(targets)):
        points = xyz[list(rows)]
        pose = fit_pose(points, targets, Model.RIGID)
        if np.abs(pose.apply(targets) - points).max() < limit:
            found.add(rows)
    return found


@pytest.mark.parametrize("xyz", [RECTANGLE, np.concatenate([RECTANGLE, [[2.0, 1.5, 3.0]]])])
def test_all_solutions_of_a_symmetric_layout_are_found(xyz):
    targets = scanned(xyz)[0]
    solutions = find_solutions(space(xyz, targets), 3)
    complete = [item for item in solutions if item.matched == len(xyz)]

    assert labels(complete) == exhaustive(xyz, targets, 0.01)


def test_the_best_solution_comes_first():
    targets = scanned(np.concatenate([HALL[:6], [[4.0, 1.0, 3.0]]]), noise=0.001)[0]
    best, *others = find_solutions(space(HALL, targets), 4)

    assert best.labels.tolist() == [0, 1, 2, 3, 4, 5, -1]
    assert all(item.matched <= best.matched for item in others)


@pytest.mark.parametrize("seed", range(6))
def test_a_few_common_targets_among_many_are_found(seed):
    scene = target_scene(60, 15, 6, noise=0.002, seed=seed)
    control = scene.control.xyz - scene.control.xyz.mean(axis=0)
    best = find_solutions(space(control, scene.targets.xyz, Settings(sigma=0.002)), 5)[0]
    rows = {name: row for row, name in enumerate(scene.control.names)}

    assert best.labels.tolist() == [rows.get(point, -1) for point in scene.truth.values()]


def test_solutions_with_too_few_targets_are_not_found():
    targets = scanned(np.concatenate([HALL[:4], HALL[4:] + [0.0, 0.0, 30.0] * np.arange(4)[:, None]]))[0]

    assert find_solutions(space(HALL, targets), 4)
    assert not find_solutions(space(HALL, targets), 6)
    assert not find_solutions(space(HALL, targets[:3]), 4), "more than there are targets"


def test_the_order_of_the_targets_does_not_matter():
    targets = scanned(HALL, noise=0.001)[0]
    order = np.array([5, 2, 7, 0, 3, 6, 1, 4])
    straight, mixed = (find_solutions(space(HALL, targets[rows]), 4) for rows in (np.arange(8), order))

    assert straight[0].labels[order].tolist() == mixed[0].labels.tolist()


def test_a_search_that_places_too_many_targets_is_ended():
    targets = scanned(HALL, scale=2.0)[0]
    whole, cut = (
        find_solutions(
            space(
                HALL, targets, Settings(model=Model.UNKNOWN_SCALE, matches=MatchingSettings(search=search))
            ),
            5,
        )
        for search in (SearchSettings(), SearchSettings(most_placed=10, batch_size=8))
    )

    assert whole.complete and whole[0].matched == 8
    assert not cut.complete


def test_a_search_can_be_cancelled_at_every_batch():
    asked = []

    def is_cancelled():
        asked.append(None)
        return len(asked) > 3

    with pytest.raises(CancelledError):
        find_solutions(space(HALL, scanned(HALL)[0]), 4, Progress(is_cancelled=is_cancelled))
