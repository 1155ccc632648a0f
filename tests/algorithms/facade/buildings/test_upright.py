"""Columns of points that can be wall."""

import numpy as np
from ichnograph.algorithms.facade.buildings.upright import upright_rows

from .sites import level, upright


def test_walls_are_kept_and_the_ground_is_not():
    wall, ground = upright((0, 0), (5, 0), 0, 4), level(0, 1, 5, 4, 0)
    rows = upright_rows(np.concatenate([wall, ground]))
    assert set(rows) == set(range(len(wall)))


def test_what_is_lower_than_a_wall_is_not_kept():
    assert not len(upright_rows(upright((0, 0), (5, 0), 0, 1.0)))


def test_no_points_have_no_walls():
    assert not len(upright_rows(np.empty((0, 3))))
