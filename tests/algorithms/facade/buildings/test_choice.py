"""The choice of a facade, and the points around it."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.facade.buildings.choice import around, choose
from ichnograph.algorithms.facade.buildings.facades import find_facades

from .sites import block


@pytest.fixture(scope="module")
def facades():
    xyz = block()
    return find_facades(xyz, np.zeros(len(xyz), int), None, 0.05)


def test_the_first_is_the_default_and_others_go_by_number(facades):
    assert choose(facades) is facades[0]
    assert choose(facades, 2) is facades[1]


def test_a_number_that_no_facade_has_is_refused_with_the_numbers_there_are(facades):
    with pytest.raises(InputError, match="FACADE is 3, but the cloud has 2 facades"):
        choose(facades, 3)


def test_a_point_chooses_the_facade_nearest_to_it(facades):
    assert choose(facades, near=np.array([[6.0, 7.0]])) is facades[1]
    assert choose(facades, near=np.array([[20.0, -1.0]])) is facades[0]


def test_a_line_chooses_the_facade_along_it(facades):
    assert choose(facades, near=np.array([[0.0, 8.2], [12.0, 8.1]])) is facades[1]


def test_what_stands_near_a_facade_is_kept_and_the_other_side_of_the_block_is_not(facades):
    xyz = block()
    kept = xyz[around(xyz, facades[0])]
    assert kept[:, 1].max() < 7 and kept[:, 1].min() < -8
    assert kept[:, 0].min() > -2 and kept[:, 0].max() < 14
