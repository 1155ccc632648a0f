"""Triangulation, noise removal and alpha shape: where a surface is, and where it is not."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.facade.outlines.alpha_shape import alpha_shape
from ichnograph.algorithms.facade.outlines.denoising import remove_noise
from ichnograph.algorithms.facade.outlines.surface import make_surface
from ichnograph.algorithms.facade.settings import Settings
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.algorithms.facade.samples import lattice
from shapely.geometry import Polygon

PAPER = {"factor": 3.0, "count": 5, "rounds": 10}


def scattered(points, share=0.3, step=0.02, seed=0):
    return points + np.random.default_rng(seed).uniform(-share, share, points.shape) * step


def without(points, left, bottom, right, top):
    inside = ((points > (left, bottom)) & (points < (right, top))).all(axis=1)
    return points[~inside]


def test_points_on_one_line_have_no_triangles_and_no_outline():
    mesh = triangulate(np.column_stack([np.arange(10.0), np.zeros(10)]))
    assert len(mesh.triangles) == 0
    assert alpha_shape(mesh).is_empty


def test_each_edge_is_there_once_and_knows_its_length():
    mesh = triangulate(np.array([(0, 0), (3, 0), (3, 4), (0, 4.1)]))
    assert len(mesh.edges) == len({tuple(edge) for edge in mesh.edges}) == 5
    assert sorted(mesh.lengths.round(6))[:2] == [3.0, round(float(np.hypot(3, 0.1)), 6)]
    assert mesh.areas.sum() == pytest.approx(0.5 * 3 * (4 + 4.1))


def test_coordinates_of_a_grid_lose_no_triangle():
    points = scattered(lattice(0, 0, 1, 1, 0.02))
    assert len(triangulate(points + 5e6).triangles) == len(triangulate(points).triangles)


def test_the_outline_of_a_lattice_ends_at_its_outermost_points():
    shape = alpha_shape(triangulate(lattice(0, 0, 2, 1, 0.02)))
    assert shape.area == pytest.approx(1.98 * 0.98)
    assert len(shape.geoms) == 1 and not shape.geoms[0].interiors


def test_a_window_is_an_inner_ring():
    points = without(scattered(lattice(0, 0, 2, 1, 0.02)), 0.5, 0.3, 1.0, 0.7)
    (part,) = alpha_shape(triangulate(points)).geoms
    (ring,) = [ring for ring in part.interiors if Polygon(ring).area > 0.01]
    assert ring.bounds == pytest.approx((0.5, 0.3, 1.0, 0.7), abs=0.02)


def test_a_thinly_scanned_part_has_no_holes():
    dense, thin = lattice(0, 0, 1, 1, 0.01), lattice(1, 0, 2, 1, 0.05)
    shape = alpha_shape(triangulate(np.concatenate([dense, thin])))
    assert len(shape.geoms) == 1 and not shape.geoms[0].interiors
    assert shape.area == pytest.approx(1.97 * 0.98, rel=0.02)


def test_a_smaller_alpha_opens_finer_gaps():
    points = without(lattice(0, 0, 2, 1, 0.02), 0.97, 0.2, 1.03, 0.8)
    mesh = triangulate(points)
    assert len(alpha_shape(mesh, 0.2).geoms[0].interiors) == 0
    assert len(alpha_shape(mesh, 0.02).geoms[0].interiors) == 1


@settings(max_examples=10, deadline=None)
@given(angle=st.floats(0, 6.3), shift=st.floats(-1e3, 1e3), seed=st.integers(0, 99))
def test_rotation_shift_and_order_leave_the_outline_as_it_is(angle, shift, seed):
    points = scattered(without(lattice(0, 0, 1, 1, 0.04), 0.3, 0.3, 0.6, 0.6), step=0.04)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    moved = np.random.default_rng(seed).permutation(points @ turn.T + shift)
    assert alpha_shape(triangulate(moved)).area == pytest.approx(
        alpha_shape(triangulate(points)).area, rel=1e-6
    )


def test_points_that_stray_far_from_the_surface_are_noise():
    generator = np.random.default_rng(0)
    surface = scattered(lattice(0, 0, 1, 1, 0.02))
    stray = np.column_stack([generator.uniform(1.2, 2.0, 12), generator.uniform(0, 1, 12)])
    kept = remove_noise(triangulate(np.concatenate([surface, stray])), **PAPER)
    assert kept[: len(surface)].mean() > 0.98
    assert kept[len(surface) :].mean() < 0.5


def test_more_large_triangles_are_allowed_with_a_larger_count_and_none_go_without_rounds():
    generator = np.random.default_rng(0)
    points = np.concatenate([lattice(0, 0, 1, 1, 0.02), generator.uniform(1.2, 2, (30, 2))])
    mesh = triangulate(points)
    removed = [np.sum(~remove_noise(mesh, **{**PAPER, **change})) for change in (
        {"count": 3}, {"count": 5}, {"count": 100}, {"rounds": 0})]  # fmt: skip
    assert removed[0] >= removed[1] > removed[2] == removed[3] == 0


def test_larger_triangles_are_allowed_with_a_larger_factor():
    points = np.concatenate([lattice(0, 0, 1, 1, 0.02), np.random.default_rng(0).uniform(1.2, 2, (30, 2))])
    mesh = triangulate(points)
    assert remove_noise(mesh, 1e6, 5, 10).all()
    assert not remove_noise(mesh, 3, 5, 10).all()


def test_a_surface_whose_points_come_twice_is_the_surface_of_the_points():
    uvw = np.column_stack([lattice(0, 0, 2, 1, 0.05), np.zeros(800)])
    once = make_surface(uvw, np.arange(len(uvw)), Settings())
    twice = make_surface(np.repeat(uvw, 2, axis=0), np.arange(2 * len(uvw)), Settings())

    assert twice.spacing == pytest.approx(once.spacing)
    assert twice.outline.area == pytest.approx(once.outline.area)
