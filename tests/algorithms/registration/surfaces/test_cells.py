"""Moments of points in cells: exact sums, whatever the order of the points."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.surfaces.cells import cells_of, packed, unpacked


@pytest.fixture
def points():
    return np.random.default_rng(0).uniform(-3, 3, (4000, 3))


def test_neither_the_order_of_points_nor_the_chunks_matter(points):
    shuffled = np.random.default_rng(1).permutation(points)
    one, other = cells_of([points], 0.4), cells_of([shuffled[:100], shuffled[100:]], 0.4)

    np.testing.assert_array_equal(one.keys, other.keys)
    np.testing.assert_array_equal(one.moments, other.moments)


def test_centres_and_covariances_are_those_of_the_points_of_a_cell(points):
    cells = cells_of([points], 0.8)
    row = int(cells.counts.argmax())
    inside = points[(np.floor(np.round(points, 5) / 0.8) == cells.numbers[row]).all(axis=1)]

    assert len(inside) == cells.counts[row] > 10
    np.testing.assert_allclose(cells.centres()[row], inside.mean(axis=0), atol=1e-5)
    np.testing.assert_allclose(cells.covariances()[row], np.cov(inside.T, bias=True), atol=1e-5)


def test_doubled_cells_are_those_of_twice_the_edge(points):
    doubled, direct = cells_of([points], 0.2).doubled(), cells_of([points], 0.4)

    assert doubled.edge == direct.edge
    np.testing.assert_array_equal(doubled.keys, direct.keys)
    np.testing.assert_array_equal(doubled.moments, direct.moments)


def test_points_beyond_a_million_cells_are_left_out(points):
    far = np.array([[1e9, 0.0, 0.0]])

    np.testing.assert_array_equal(
        cells_of([np.r_[points, far]], 0.2).moments, cells_of([points], 0.2).moments
    )


def test_numbers_of_cells_survive_packing():
    numbers = np.array([[0, 0, 0], [-1, 5, -7], [1_000_000, -1_000_000, 3]])

    np.testing.assert_array_equal(unpacked(packed(numbers)), numbers)
