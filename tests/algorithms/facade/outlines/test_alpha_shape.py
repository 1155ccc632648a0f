"""The alpha shape: where a surface is, and where it is not."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.facade.outlines.alpha_shape import alpha_shape
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.algorithms.facade.samples import lattice, scattered, without
from shapely.geometry import Polygon


def test_points_on_one_line_have_no_outline():
    assert alpha_shape(triangulate(np.column_stack([np.arange(10.0), np.zeros(10)]))).is_empty


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
