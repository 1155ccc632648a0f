"""Things that are linked, directly or through others, have one label."""

import numpy as np
from ichnograph.algorithms.geometry.linked_parts import label_linked, label_near


def test_chains_of_links_are_one_part_and_the_unlinked_are_alone():
    labels = label_linked(np.array([0, 4]), np.array([2, 0]), 5)
    assert labels[0] == labels[2] == labels[4]
    assert len({labels[0], labels[1], labels[3]}) == 3


def test_without_links_everything_is_alone():
    assert len(set(label_linked(np.array([], int), np.array([], int), 4))) == 4


def test_cells_within_reach_also_by_a_corner_are_one_part():
    cells = np.array([(0, 0), (1, 1), (3, 1), (6, 1)])

    assert len(set(label_near(cells, 1))) == 3
    assert len(set(label_near(cells, 2))) == 2
