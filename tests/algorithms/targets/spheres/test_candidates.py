"""Candidates for spheres."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.spheres.candidates import sphere_candidates
from ichnograph.algorithms.targets.spheres.settings import CandidateSettings
from ichnograph.tests.algorithms.targets.made_targets import image_of_simulated, one_target


@pytest.mark.parametrize(("size", "distance"), [(0.076, 3.0), (0.145, 8.0), (0.2, 15.0)])
def test_the_best_candidate_is_the_nearest_point_of_the_sphere(size, distance):
    scan = one_target("sphere", size, distance)
    best = sphere_candidates(image_of_simulated(scan), (size,), CandidateSettings())[0]

    centre = scan.targets[0].centre
    assert np.linalg.norm(best.xyz - centre * (1 - size / 2 / np.linalg.norm(centre))) < 0.3 * size


def test_a_board_before_a_wall_has_none():
    scan = one_target("black and white", 0.15, 5.0, 30.0)

    assert sphere_candidates(image_of_simulated(scan), (0.145, 0.2), CandidateSettings()) == []
