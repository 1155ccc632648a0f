"""Seeds where the scale is unknown."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.matching.similar_triangles import SimilarTriangles, named_seeds
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import control_points

COUNT = len(HALL)


@pytest.mark.parametrize("scale", [0.01, 0.37, 1.0, 304.8])
def test_triangles_of_the_same_shape_are_found_at_any_scale(scale):
    rows = [6, 1, 4]
    targets = scanned(HALL[rows], scale=scale)[0]
    found = np.concatenate(list(SimilarTriangles(control_points(HALL)).seeds(targets, 2, COUNT)))
    labels = {
        tuple(nodes % COUNT for nodes in sorted(seed, key=lambda node: node // COUNT)) for seed in found
    }

    assert tuple(rows) in labels
    assert len(found) < 60, "of 336 ways"


def test_triangles_that_are_short_beside_the_noise_have_no_shape():
    tiny = HALL / 1000

    assert not list(SimilarTriangles(control_points(tiny)).seeds(tiny[:3], 2, COUNT))


def test_targets_in_one_place_have_no_shape():
    found = SimilarTriangles(control_points(HALL)).seeds(HALL[[6, 6, 4]], 2, COUNT)
    assert not any(len(seeds) for seeds in found)


def named(rows):
    allowed = np.zeros((len(rows), COUNT), bool)
    for number, row in enumerate(rows):
        if row is not None:
            allowed[number, row] = True
    return allowed


def test_by_names_a_seed_has_the_shape_of_its_points():
    targets = scanned(HALL[[0, 1, 2, 3]], scale=2.5)[0]
    right = named_seeds(control_points(HALL), targets, 3, named([0, 1, 2, 3]), 3)
    wrong = named_seeds(control_points(HALL), targets, 3, named([0, 1, 2, 6]), 3)

    assert {tuple(seed // COUNT) for seed in right} == {(0, 1, 3), (0, 2, 3), (1, 2, 3)}
    assert all(np.array_equal(seed // COUNT, seed % COUNT) for seed in right)
    assert not len(wrong)


def test_by_names_two_targets_are_always_of_the_same_shape():
    targets = scanned(HALL[[0, 1, 2]])[0]
    seeds = named_seeds(control_points(HALL), targets, 2, named([4, None, 2]), 2)

    assert seeds.tolist() == [[4, 2 * COUNT + 2]]


def test_a_target_without_a_named_point_ends_no_seed():
    targets = scanned(HALL[:4])[0]

    assert named_seeds(control_points(HALL), targets, 3, named([0, 1, 2, None]), 3).shape == (0, 3)
