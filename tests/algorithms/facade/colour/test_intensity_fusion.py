"""Fusion of regions: f of the paper, and soft borders without intensity."""

import numpy as np
from ichnograph.algorithms.facade.colour.intensity_fusion import (
    components,
    fuse_by_intensity,
    fuse_by_soft_borders,
    largest_first,
)
from ichnograph.tests.algorithms.facade.colour.panel import LINKED, MESH, PANEL, POINTS, painted


def test_regions_whose_intensities_differ_by_less_than_f_are_one_surface():
    labels = np.repeat([1, 2, 3], 100).astype(np.int32)
    relative = np.repeat([1.0, 0.95, 0.5], 100)
    assert len(np.unique(fuse_by_intensity(labels, relative, 0.1))) == 2
    assert len(np.unique(fuse_by_intensity(labels, relative, 0.04))) == 3


def test_fusing_does_not_chain():
    labels = np.repeat(np.arange(1, 11), 50).astype(np.int32)
    relative = np.repeat(np.linspace(1, 0.1, 10), 50)
    surfaces = fuse_by_intensity(labels, relative, 0.15)
    for surface in np.unique(surfaces):
        assert np.ptp(relative[surfaces == surface]) < 0.3


def test_soft_borders_fuse_and_sharp_ones_do_not():
    labels = np.where(PANEL, 3, np.where(POINTS[:, 0] < 0.8, 1, 2)).astype(np.int32)
    assert len(np.unique(fuse_by_soft_borders(MESH, LINKED, labels, painted(noise=0.0), 30.0))) == 2


def test_the_largest_region_becomes_the_first():
    np.testing.assert_array_equal(largest_first(np.array([0, 1, 2, 2, 2, 3, 3])), [0, 3, 1, 1, 1, 2, 2])


def test_regions_of_one_label_that_do_not_touch_are_separate_components():
    left, right = POINTS[:, 0] < 0.5, POINTS[:, 0] > 2.5
    pieces = components(MESH, LINKED, left | right)

    assert len(np.unique(pieces)) == 3
    assert len(np.unique(pieces[left])) == len(np.unique(pieces[right])) == 1
    assert pieces[left][0] != pieces[right][0]
