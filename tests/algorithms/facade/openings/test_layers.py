"""Parallel parts belong to a facade; what is seen through openings, and what stands before it, does not."""

import pytest
from ichnograph.tests.algorithms.facade.openings.scenes import pane, states_of, wall
from ichnograph.tests.algorithms.facade.samples import at, lattice


def depths(*parts):
    return [layer.depth for layer in states_of(*parts).layers]


def test_a_storey_set_back_is_a_layer():
    storey = at(lattice(0, 4.1, 6, 6, 0.03), -0.8)
    assert depths(wall(), storey) == pytest.approx([0, -0.8])


def test_a_bay_is_a_layer_where_the_wall_is_not_seen_behind_it():
    bay = (2.0, 0.5, 4.0, 3.0)
    assert depths(wall(bay), pane(bay, 0.6)) == pytest.approx([0, 0.6])


def test_a_car_before_the_wall_is_not_a_layer():
    assert depths(wall(), pane((2.0, 0.0, 4.0, 1.4), 1.2)) == [0]


def test_a_door_and_the_room_behind_it_are_not_layers():
    gate = (2.0, 0.0, 4.0, 3.0)
    assert depths(wall(gate), pane(gate, -0.4), pane(gate, -2.0)) == [0]
