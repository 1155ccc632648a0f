"""The planes of a real cornice beside a published segmentation of it (Point Cloud Library, BSD licence)."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.facade.planes.segmentation import find_planes
from ichnograph.tests.algorithms.facade.samples import bare

CORNICE = Path(__file__).parents[5] / "shared" / "data" / "cornice_pcl_region_growing" / "cornice.xyz"
UPRIGHT = np.array([[0.899, 0.438, 0.0], [0.0, 0.0, 1.0], [0.438, -0.899, 0.0]])
"""From the frame of the camera: right, away from it, up."""

FLAT = 0.005
FACING = 0.99
LARGE = 1000


@pytest.mark.skipif(not CORNICE.exists(), reason="the shared test data are not here")
def test_flat_regions_of_a_cornice_lie_on_one_plane_each():
    rows = np.loadtxt(CORNICE)
    xyz = rows[:, :3] / 1000 @ UPRIGHT.T
    _, region, sizes = np.unique(rows[:, 3:6], axis=0, return_inverse=True, return_counts=True)
    region = region.ravel()
    # The mouldings are a few centimetres deep, so the planes need a smaller distance.
    labels = find_planes(bare(xyz - xyz.min(axis=0)), 0.02).labels

    shares = []
    for number in np.flatnonzero(sizes >= LARGE):
        own = region == number
        spread, axes = np.linalg.eigh(np.cov(xyz[own].T))
        if np.sqrt(spread[0]) < FLAT and abs(axes[1, 0]) > FACING:
            shares.append(np.bincount(np.maximum(labels[own], 0))[1:].max() / own.sum())
    assert len(shares) >= 8
    assert np.median(shares) > 0.95 and min(shares) > 0.85
