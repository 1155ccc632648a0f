"""The choice of a facade, and the points around it."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.facade.buildings.choice import along, around, choose
from ichnograph.algorithms.facade.buildings.facades import find_facades
from shapely.geometry import LineString, box

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


def test_a_wall_of_a_plan_has_the_facade_on_its_outer_face(facades):
    assert along(facades, [box(0, 0, 12, 0.4)]) == (facades[0],)
    assert along(facades, [box(0, 7.6, 12, 8)]) == (facades[1],)


def test_a_line_along_a_part_of_a_facade_has_it(facades):
    assert along(facades, [LineString([(2, -1), (4, -1)])]) == (facades[0],)


def test_several_shapes_have_a_facade_each_the_longest_first(facades):
    shapes = [LineString([(2, -1), (4, -1)]), LineString([(1, 9), (11, 9)])]
    assert along(facades, shapes) == (facades[1], facades[0])


def test_a_building_has_the_facades_around_it(facades):
    assert along(facades, [box(0, 0, 12, 8)]) == tuple(facades)


@pytest.mark.parametrize("line", [[(6, -1), (6, 9)], [(0, -3), (12, -3)]], ids=["across", "far"])
def test_a_line_along_no_facade_is_refused(facades, line):
    with pytest.raises(InputError, match="without a facade within 2 m"):
        along(facades, [LineString(line)])


def test_what_stands_near_a_facade_is_kept_and_the_other_side_of_the_block_is_not(facades):
    xyz = block()
    kept = xyz[around(xyz, facades[0])]
    assert kept[:, 1].max() < 7 and kept[:, 1].min() < -8
    assert kept[:, 0].min() > -2 and kept[:, 0].max() < 14
