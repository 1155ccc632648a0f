"""Candidates for black and white targets."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.checkerboards.candidates import best_of_neighbours, checkerboard_candidates
from ichnograph.algorithms.targets.checkerboards.settings import CandidateSettings
from ichnograph.tests.algorithms.targets.made_targets import image_of_simulated, one_target


@pytest.mark.parametrize("incidence", [0.0, 40.0, 65.0])
@pytest.mark.parametrize(("size", "distance"), [(0.075, 3.0), (0.15, 6.0), (0.3, 15.0)])
def test_the_centre_is_a_candidate(size, distance, incidence):
    scan = one_target("black and white", size, distance, incidence)
    found = checkerboard_candidates(image_of_simulated(scan), CandidateSettings())

    assert min(np.linalg.norm(item.xyz - scan.targets[0].centre) for item in found) < 0.1 * size


def test_of_neighbours_the_first_is_taken():
    places = np.array([[0.0, 0, 0], [0.5, 0, 0], [2.0, 0, 0], [1.4, 0, 0]])

    assert best_of_neighbours(places, 1.0) == [0, 2]
