"""Parallel parts belong to a facade; what is seen through openings, and what stands before it, does not."""

import numpy as np
import pytest
from ichnograph.tests.algorithms.facade.openings.scenes import pane, states_of, wall
from ichnograph.tests.algorithms.facade.samples import at, lattice, without


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


def test_a_neighbour_set_back_a_little_is_a_layer_although_specks_of_the_wall_are_beside_it():
    neighbour, specks = (0.0, 0.0, 3.0, 4.0), pane((-0.3, 0.5, -0.2, 3.5), 0.0)
    main = np.concatenate([wall(left=3.0), specks])
    assert depths(main, pane(neighbour, -0.06)) == pytest.approx([0, -0.06])


def test_what_is_seen_in_the_windows_of_a_neighbour_set_back_is_not_a_layer():
    neighbour, window = (0.0, 0.0, 3.0, 4.0), (0.6, 0.8, 2.0, 2.6)
    other = at(without(lattice(*neighbour, 0.03), *window), -0.06)
    main = np.concatenate([wall(left=3.0), pane((-0.3, 0.5, -0.2, 3.5), 0.0)])
    assert depths(main, other, pane(window, -0.25)) == pytest.approx([0, -0.06])


def test_the_pane_of_a_bay_is_not_a_layer():
    bay, window = (1.0, 0.3, 4.5, 3.6), (1.6, 1.0, 3.4, 2.4)
    front = at(without(lattice(*bay, 0.03), *window), 0.7)
    assert depths(wall(bay), front, pane(window, 0.5)) == pytest.approx([0, 0.7])
