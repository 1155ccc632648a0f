"""The matching matrix: which pairs of targets have the distance of which pairs of control points."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.matching import matching_matrix as module
from ichnograph.algorithms.registration.matching.matching_matrix import (
    MatchingMatrix,
    matching_matrix,
    pruned,
    seeds,
)
from ichnograph.algorithms.registration.matching.settings import SearchSettings
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import control_points
from scipy.spatial.distance import pdist, squareform

COUNT = len(HALL)
TARGETS = scanned(HALL)[0][[5, 2, 7, 0]]
TRUE = {number * COUNT + row for number, row in enumerate([5, 2, 7, 0])}


def all_seeds(matrix, last, model):
    """Return all seeds that end with a target."""
    return np.concatenate(list(seeds(matrix, last, model)))


def everything(targets):
    return np.ones((len(targets), COUNT), bool)


def edges(matrix):
    return set(zip(matrix.starts.tolist(), matrix.ends.tolist()))


def whole(allowed=None, levelled=False, targets=TARGETS):
    allowed = everything(targets) if allowed is None else allowed
    return matching_matrix(control_points(HALL), targets, allowed, levelled)


def test_an_edge_stands_for_every_pair_of_equal_distances():
    limit = control_points(HALL).limits[0, 1]
    mine, theirs = squareform(pdist(TARGETS)), squareform(pdist(HALL))
    expected = {
        (i * COUNT + a, j * COUNT + c)
        for i in range(4)
        for j in range(i + 1, 4)
        for a in range(COUNT)
        for c in range(COUNT)
        if a != c and abs(mine[i, j] - theirs[a, c]) <= limit
    }

    assert edges(whole()) == expected


def test_the_edges_are_sorted():
    matrix = whole()

    assert np.array_equal(np.lexsort([matrix.ends, matrix.starts]), np.arange(len(matrix.starts)))


def test_points_that_are_not_allowed_have_no_edges():
    allowed = everything(TARGETS)
    allowed[0] = False

    assert all(start >= COUNT for start, _ in edges(whole(allowed)))


def test_levelled_heights_must_agree_too():
    tilted = scanned(HALL, tilt=20.0)[0][[5, 2, 7, 0]]

    def true_edges(targets, levelled):
        return sum({*edge} <= TRUE for edge in edges(whole(targets=targets, levelled=levelled)))

    assert true_edges(TARGETS, levelled=True) == true_edges(tilted, levelled=False) == 6
    assert true_edges(tilted, levelled=True) < 6
    assert edges(whole(levelled=True)) <= edges(whole())


def test_a_scale_error_widens_the_limits_by_the_distance():
    stretched = TARGETS * 1.001
    control = control_points(HALL, scale_error=0.0)
    wide = control_points(HALL, scale_error=0.0012)
    allowed = everything(TARGETS)

    def true_edges(points):
        matrix = matching_matrix(points, stretched, allowed, False)
        return sum({*edge} <= TRUE for edge in edges(matrix))

    assert true_edges(wide) == 6
    assert true_edges(control) <= true_edges(wide)


def test_pruning_keeps_what_agrees_with_all_others_but_one():
    # Targets 0 to 3 with point 0 each, all joined; and a pair that hangs on by one edge.
    complete = [(i * 2, j * 2) for i in range(4) for j in range(i + 1, 4)]
    graph = sorted([*complete, (1, 3)])
    starts, ends = np.array(graph).T
    kept = pruned(MatchingMatrix(2, 4, starts, ends), 4, 4)

    assert edges(kept) == set(complete)
    assert edges(pruned(kept, 4, 6)) == set()


def test_seeds_are_the_triangles_that_end_with_a_target():
    matrix = whole()
    found = {tuple(row) for last in range(2, 4) for row in all_seeds(matrix, last, Model.RIGID).tolist()}
    joined = edges(matrix)
    nodes = sorted({node for edge in joined for node in edge})
    expected = {(u, v, w) for u in nodes for v in nodes for w in nodes if {(u, v), (u, w), (v, w)} <= joined}

    assert found == expected
    assert all(len(set(np.array(row) // COUNT)) == 3 for row in found)


@pytest.mark.parametrize("last", [1, 2, 3])
def test_two_nodes_are_a_seed_when_levelled(last):
    found = all_seeds(whole(levelled=True), last, Model.LEVELLED)

    assert found.shape[1] == 2
    assert (found[:, 1] // COUNT == last).all()


def test_without_edges_there_are_no_seeds():
    nothing = np.empty(0, np.int64)

    assert all_seeds(MatchingMatrix(COUNT, COUNT, nothing, nothing), 2, Model.RIGID).shape == (0, 3)


def test_of_a_regular_layout_the_last_targets_are_left_out():
    grid = np.array([[5.0 * x, 5.0 * y, 0] for x in range(6) for y in range(6)])
    allowed = np.ones((36, 36), bool)
    few, all_of_them = (
        matching_matrix(control_points(grid), grid, allowed, False, SearchSettings(most_edges=most))
        for most in (5000, 10**9)
    )

    assert 3 <= few.targets < 36 == all_of_them.targets
    early = all_of_them.ends // 36 < few.targets
    assert len(few.starts) == early.sum() <= 5000


def test_triangles_come_in_parts_that_are_the_whole(monkeypatch):
    matrix = whole(levelled=False, targets=scanned(HALL)[0])
    at_once = all_seeds(matrix, 5, Model.RIGID)
    monkeypatch.setattr(module, "PAIRS", 7)
    parts = list(seeds(matrix, 5, Model.RIGID))

    assert len(parts) > 1
    assert np.array_equal(np.concatenate(parts), at_once)
