"""Motions move points by a matrix without loss of digits."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.motion import Motion, product

MIDDLE = np.array([412_345.6, 5_812_345.7, 71.3])


def matrix(degrees, scale=1.0, shift=(0.0, 0.0, 0.0)):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    out = np.eye(4)
    out[:3, :3] = scale * np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    out[:3, 3] = shift
    return out


def test_the_product_is_that_of_the_matrix_with_each_vector():
    linear, vectors = np.arange(9.0).reshape(3, 3), np.array([[1.0, 2.0, 3.0], [0.0, -1.0, 4.0]])
    np.testing.assert_allclose(product(vectors, linear), vectors @ linear.T)


def test_the_product_does_not_depend_on_how_the_points_are_cut():
    vectors, linear = np.random.default_rng(0).normal(size=(1000, 3)), matrix(17)[:3, :3]
    parts = [product(part, linear) for part in np.array_split(vectors, 7)]
    np.testing.assert_array_equal(np.concatenate(parts), product(vectors, linear))


def test_points_come_to_lie_where_the_matrix_sends_them():
    given = matrix(30, 1.0001, (5.0, -7.0, 2.0))
    motion = Motion.about(given, MIDDLE)
    xyz = np.array([[0.0, 0.0, 0.0], [1.5, -2.5, 0.25]])
    moved = motion.positions(xyz) + motion.offset
    np.testing.assert_allclose(moved, (xyz + motion.origin) @ given[:3, :3].T + given[:3, 3], atol=1e-8)


def test_directions_are_turned_and_keep_their_length():
    motion = Motion.about(matrix(90, 3.0), MIDDLE)
    assert motion.directions(np.array([[1.0, 0.0, 0.0]]))[0] == pytest.approx([0, 1, 0], abs=1e-12)


def test_origin_and_offset_are_whole_metres():
    motion = Motion.about(matrix(12), MIDDLE)
    assert (motion.origin == np.floor(MIDDLE)).all()
    assert (motion.offset % 1 == 0).all()
    assert (np.abs(motion.shift) < 1).all()
