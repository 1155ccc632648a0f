"""The Delaunay triangulation of points in a plane."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.algorithms.facade.samples import lattice, scattered


def test_points_on_one_line_have_no_triangles():
    assert len(triangulate(np.column_stack([np.arange(10.0), np.zeros(10)])).triangles) == 0


def test_each_edge_is_there_once_and_knows_its_length():
    mesh = triangulate(np.array([(0, 0), (3, 0), (3, 4), (0, 4.1)]))
    assert len(mesh.edges) == len({tuple(edge) for edge in mesh.edges}) == 5
    assert sorted(mesh.lengths.round(6))[:2] == [3.0, round(float(np.hypot(3, 0.1)), 6)]
    assert mesh.areas.sum() == pytest.approx(0.5 * 3 * (4 + 4.1))


def test_coordinates_of_a_grid_lose_no_triangle():
    points = scattered(lattice(0, 0, 1, 1, 0.02))
    assert len(triangulate(points + 5e6).triangles) == len(triangulate(points).triangles)
