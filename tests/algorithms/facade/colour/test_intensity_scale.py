"""Intensities become comparable over a wall and between scans."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.colour.intensity_scale import make_relative
from ichnograph.tests.algorithms.facade.samples import lattice

POINTS = lattice(0, 0, 6, 4, 0.03)
PANEL = ((POINTS > (2, 1)) & (POINTS < (3.5, 3))).all(axis=1)
FALL = np.exp(-0.1 * POINTS[:, 0]) * (1 - 0.02 * POINTS[:, 1] ** 2)


def measured(scan, gains=(1.0,), noise=0.04):
    generator = np.random.default_rng(0)
    values = 20000 * np.where(PANEL, 0.5, 1.0) * FALL * np.array(gains)[scan]
    return (values * (1 + generator.normal(0, noise, len(POINTS)))).astype(np.float32)


def test_the_wall_is_one_everywhere_and_a_darker_panel_keeps_its_ratio():
    scan = np.zeros(len(POINTS), np.int32)
    relative = make_relative(POINTS, measured(scan), scan)
    for part in (POINTS[:, 0] < 1, POINTS[:, 0] > 5, POINTS[:, 1] > 3.5):
        assert relative.values[part & ~PANEL].mean() == pytest.approx(1, abs=0.02)
    assert relative.values[PANEL].mean() == pytest.approx(0.5, abs=0.02)


def test_scans_with_other_gains_come_to_the_same_level():
    scan = np.random.default_rng(1).integers(0, 2, len(POINTS)).astype(np.int32)
    relative = make_relative(POINTS, measured(scan, (1.0, 0.3)), scan)
    assert relative.levels[0] > 3 * relative.levels[1]
    for number in (0, 1):
        assert relative.values[(scan == number) & ~PANEL].mean() == pytest.approx(1, abs=0.01)
        assert relative.values[(scan == number) & PANEL].mean() == pytest.approx(0.5, abs=0.02)


@pytest.mark.parametrize("noise", [0.02, 0.05, 0.1])
def test_the_threshold_is_twice_the_noise_of_the_data(noise):
    scan = np.zeros(len(POINTS), np.int32)
    relative = make_relative(POINTS, measured(scan, noise=noise), scan)
    assert relative.threshold == pytest.approx(2 * noise, rel=0.15)


def test_a_scan_of_a_few_points_has_one_level():
    scan = np.zeros(20, np.int32)
    relative = make_relative(POINTS[:20], np.full(20, 500, np.float32), scan)
    np.testing.assert_allclose(relative.values, 1)
