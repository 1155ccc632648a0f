"""Pixels of an elevation, and what is seen from them along rows and columns."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.facade.openings.grid import (
    ABOVE,
    BELOW,
    LEFT,
    RIGHT,
    beyond,
    first_seen,
    grid_over,
)

IMAGE = np.array([[0, 1, 0, 2, 0]])


def test_points_are_in_the_pixel_that_holds_them_and_others_outside():
    grid = grid_over(np.array([(0.0, 0.0), (1.0, 0.5)]), 0.1, 1000)
    cells = grid.cells(np.array([(0.05, 0.05), (9.0, 9.0)]))

    assert cells[1] == -1
    np.testing.assert_allclose(grid.centres(grid.holds(cells)), [(0.05, 0.05)], atol=0.05)


def test_a_box_of_pixels_has_edges_in_metres():
    grid = grid_over(np.array([(2.0, 3.0), (4.0, 5.0)]), 0.5, 1000)
    np.testing.assert_allclose(grid.edges((slice(1, 3), slice(1, 2))), (2.0, 3.0, 2.5, 4.0))


def test_pixels_grow_until_there_are_few_enough():
    grid = grid_over(np.array([(0.0, 0.0), (10.0, 10.0)]), 0.001, 10_000)
    assert np.prod(grid.shape) < 11_000


def test_a_mark_is_beyond_a_pixel_in_the_direction_where_it_lies():
    found = beyond(IMAGE == 1)[:, 0]

    assert found[LEFT].tolist() == [False, True, True, True, True]
    assert found[RIGHT].tolist() == [True, True, False, False, False]
    assert not found[BELOW][[0, 2, 3, 4]].any() and not found[ABOVE][[0, 2, 3, 4]].any()


def test_the_first_barrier_is_seen_and_not_what_is_behind_it():
    seen = first_seen(IMAGE > 0, IMAGE == 2)[:, 0]

    assert seen[RIGHT].tolist()[:3] == [False, False, True]
    assert seen[LEFT].tolist()[4] and not seen[LEFT].tolist()[2]


@settings(deadline=None)
@given(st.integers(0, 1000))
def test_turning_the_image_turns_what_is_seen(seed):
    generator = np.random.default_rng(seed)
    barrier = generator.random((6, 9)) < 0.3
    wanted = barrier & (generator.random((6, 9)) < 0.5)
    seen, turned = first_seen(barrier, wanted), first_seen(barrier.T, wanted.T)

    np.testing.assert_array_equal(seen[LEFT].T, turned[BELOW])
    np.testing.assert_array_equal(seen[ABOVE].T, turned[RIGHT])
