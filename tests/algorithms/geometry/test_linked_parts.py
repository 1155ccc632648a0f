"""Things that are linked, directly or through others, have one label."""

import numpy as np
from ichnograph.algorithms.geometry.linked_parts import label_linked


def test_chains_of_links_are_one_part_and_the_unlinked_are_alone():
    labels = label_linked(np.array([0, 4]), np.array([2, 0]), 5)
    assert labels[0] == labels[2] == labels[4]
    assert len({labels[0], labels[1], labels[3]}) == 3


def test_without_links_everything_is_alone():
    assert len(set(label_linked(np.array([], int), np.array([], int), 4))) == 4
