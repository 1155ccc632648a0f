"""A painted panel on a wall, as camera and laser see it; shared by the tests of colour."""

import numpy as np
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.algorithms.facade.samples import lattice

STEP = 0.02
POINTS = lattice(0, 0, 3, 2, STEP)
MESH = triangulate(POINTS)
LINKED = MESH.lengths < 2 * STEP
SIZES = np.full(len(POINTS), STEP**2)
PANEL = ((POINTS > (1.0, 0.5)) & (POINTS < (1.6, 1.3))).all(axis=1)
SHADE = POINTS[:, 0] + 0.3 * POINTS[:, 1] > 1.5
WHITE, GREEN = np.array([210.0, 200, 180]), np.array([70.0, 105, 85])


def painted(noise=4.0, panel=GREEN):
    rgb = np.where(PANEL[:, None], panel, WHITE)
    return (rgb + np.random.default_rng(0).normal(0, noise, rgb.shape)).astype(np.float32)


def reflecting(panel=0.5, noise=0.03):
    values = np.where(PANEL, panel, 1.0)
    return (values * (1 + np.random.default_rng(1).normal(0, noise, len(values)))).astype(np.float32)


def same(labels, chosen):
    """Whether a region consists of the chosen points."""
    return np.mean((labels == np.bincount(labels[chosen]).argmax()) == chosen) > 0.995
