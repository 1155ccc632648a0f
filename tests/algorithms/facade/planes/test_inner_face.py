"""The inner face of a wall is the parallel surface that covers most of it."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.planes.inner_face import find_face


def test_a_parallel_surface_is_found_with_its_offset_and_its_share():
    cells = np.concatenate([np.arange(400), np.arange(100)])
    distances = np.concatenate([np.full(400, 0.38), np.full(100, 0.7)])
    face = find_face(cells, distances, 1000)

    assert face.offset == pytest.approx(0.38) and face.share == pytest.approx(0.4)


def test_a_surface_that_scatters_is_one_surface():
    cells = np.arange(500)
    distances = np.random.default_rng(0).normal(0.3, 0.008, 500)

    assert find_face(cells, distances, 500).share > 0.99


@pytest.mark.parametrize("distance", [0.05, 1.5])
def test_what_is_nearer_or_farther_than_walls_are_thick_is_not_an_inner_face(distance):
    assert find_face(np.arange(100), np.full(100, distance), 100) is None


def test_many_points_of_one_pixel_count_once():
    assert find_face(np.zeros(500, int), np.full(500, 0.3), 100).share == pytest.approx(0.01)
