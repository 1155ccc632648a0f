"""The Delaunay triangulation of points in a plane, and the quantities derived from it."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.triangulation import triangulate

STEP = 0.1
TRIANGLE = np.array([(0, 0), (3, 0), (3, 4), (0, 4.1)])


def lattice(columns, rows, scatter=0.0):
    """Return points `STEP` apart, moved at random by up to a share of that."""
    points = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), axis=-1).reshape(-1, 2)
    return STEP * (points + np.random.default_rng(0).uniform(-scatter, scatter, points.shape))


@pytest.mark.parametrize("count", [0, 1, 3, 10])
def test_points_on_one_line_and_too_few_points_have_no_triangles(count):
    mesh = triangulate(np.column_stack([np.arange(float(count)), np.zeros(count)]))
    assert len(mesh.triangles) == len(mesh.edges) == 0


def test_each_edge_is_listed_once_with_its_length():
    mesh = triangulate(TRIANGLE)
    assert len(mesh.edges) == len({tuple(edge) for edge in mesh.edges}) == 5
    assert sorted(mesh.lengths.round(6))[:2] == [3.0, round(float(np.hypot(3, 0.1)), 6)]


def test_areas_add_up_to_that_of_the_hull():
    assert triangulate(TRIANGLE).areas.sum() == pytest.approx(0.5 * 3 * (4 + 4.1))


def test_the_circumradius_of_a_right_triangle_is_half_its_hypotenuse():
    mesh = triangulate(np.array([(0, 0), (3, 0), (0, 4), (30, 40)]))
    right = np.isclose(mesh.areas, 6)
    assert mesh.circumradii[right] == pytest.approx(2.5)


def test_coordinates_of_a_national_grid_lose_no_triangle():
    points = lattice(20, 20, 0.3)
    assert len(triangulate(points + 5e6).triangles) == len(triangulate(points).triangles)


def test_the_spacing_of_a_lattice_is_its_step_also_beside_a_gap():
    points = lattice(20, 20)
    gap = ((points > 0.55) & (points < 1.25)).all(axis=1)
    np.testing.assert_allclose(triangulate(points[~gap]).spacings[25:-25], STEP)


def test_points_with_fewer_than_three_edges_have_no_spacing():
    spacings = triangulate(TRIANGLE).spacings
    assert np.isinf(spacings).sum() == 2


def test_the_sides_of_all_triangles_are_all_edges():
    mesh = triangulate(lattice(5, 5, 0.2))
    kept = np.zeros(len(mesh.triangles), bool)

    assert not mesh.sides_of(kept).any()
    assert mesh.sides_of(~kept).all()
    kept[0] = True
    assert mesh.sides_of(kept).sum() == 3


def test_pieces_are_what_the_chosen_edges_connect_by_their_first_points():
    mesh = triangulate(lattice(6, 4, 0.1))
    column = np.arange(24) % 6
    chosen = (column[mesh.edges] < 2).all(axis=1) | (column[mesh.edges] > 2).all(axis=1)
    pieces = mesh.pieces(chosen)

    assert (pieces[column < 2] == 0).all()
    np.testing.assert_array_equal(pieces[column == 2], [1, 3, 4, 5])
    assert (pieces[column > 2] == 2).all()


def test_a_point_with_many_edges_has_them_in_order():
    angles = np.linspace(0, 6, 50)
    around = STEP * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    edges = triangulate(np.concatenate([np.zeros((1, 2)), around])).edges
    np.testing.assert_array_equal(edges[edges[:, 0] == 0, 1], np.arange(1, 51))
    np.testing.assert_array_equal(edges, edges[np.lexsort(edges.T[::-1])])


def test_neighbours_are_the_other_ends_of_the_chosen_edges():
    mesh = triangulate(lattice(5, 5, 0.2))
    chosen = mesh.lengths < 1.3 * STEP
    starts, neighbours = mesh.neighbours(chosen)

    for point in range(len(mesh.points)):
        ends = mesh.edges[chosen & (mesh.edges == point).any(axis=1)]
        assert sorted(neighbours[starts[point] : starts[point + 1]]) == sorted(ends[ends != point])
