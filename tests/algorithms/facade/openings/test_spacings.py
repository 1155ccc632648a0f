"""The spacing of the points follows the wall, and the gaps between them are wall."""

import numpy as np
from ichnograph.algorithms.facade.openings.grid import grid_over
from ichnograph.algorithms.facade.openings.spacings import closed_wall, local_spacings
from ichnograph.tests.algorithms.facade.samples import lattice, without

DENSE, THIN = 0.02, 0.08


def uneven():
    return np.concatenate([lattice(0, 0, 3, 4, DENSE), lattice(3, 0, 6, 4, THIN)])


def grid_of(points, size=1.5 * DENSE):
    grid = grid_over(points, size, 10**7)
    return grid, grid.cells(points)


def test_each_part_of_a_wall_has_its_own_spacing():
    grid, cells = grid_of(uneven())
    spacings = local_spacings(cells, grid)
    middle = grid.shape[1] // 2

    assert np.allclose(spacings[:, : middle - 20], DENSE, rtol=0.2)
    assert np.allclose(spacings[:, middle + 20 :], THIN, rtol=0.2)


def test_a_window_does_not_make_the_wall_around_it_thinner():
    grid, cells = grid_of(without(uneven(), 1.0, 1.0, 2.0, 2.5))
    assert np.allclose(local_spacings(cells, grid)[:, : grid.shape[1] // 2 - 20], DENSE, rtol=0.2)


def test_a_wall_without_points_has_the_spacing_of_its_pixels():
    grid, _ = grid_of(uneven())
    assert (local_spacings(np.empty(0, np.int64), grid) == grid.size).all()


def test_gaps_between_thin_points_are_wall_and_a_window_is_not():
    window = 4.0, 1.0, 5.0, 2.5
    grid, cells = grid_of(without(uneven(), *window))
    wall = grid.holds(cells)
    closed = closed_wall(wall, local_spacings(cells, grid), grid.size)
    inside = grid.cells(without(lattice(3.2, 0.2, 5.8, 3.8, 0.05), 3.9, 0.9, 5.1, 2.6))
    pane = grid.cells(lattice(4.1, 1.1, 4.9, 2.4, 0.05))

    assert wall.ravel()[inside].mean() < 0.5
    assert closed.ravel()[inside].all()
    assert not closed.ravel()[pane].any()


def test_where_points_are_dense_nothing_is_closed():
    grid, cells = grid_of(without(lattice(0, 0, 3, 4, DENSE), 1.0, 1.0, 1.06, 2.5))
    wall = grid.holds(cells)
    assert (closed_wall(wall, local_spacings(cells, grid), grid.size) == wall).all()


def test_a_wall_whose_gaps_are_all_within_the_spacing_is_closed_everywhere():
    wall = np.zeros((40, 60), bool)
    wall[::4, ::4] = True
    assert closed_wall(wall, np.full(wall.shape, 0.5), 0.1).all()
