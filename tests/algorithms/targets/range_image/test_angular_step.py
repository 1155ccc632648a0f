"""The angular step of a scan."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.range_image.angular_step import angular_step
from ichnograph.algorithms.targets.range_image.settings import RangeImageSettings


def lattice(step, rows=80, columns=120):
    azimuth, elevation = np.meshgrid(np.arange(columns) * step, np.arange(rows) * step)
    return azimuth.ravel().astype(np.float32), elevation.ravel().astype(np.float32)


@pytest.mark.parametrize("step", [0.0001, 0.0006, 0.003])
def test_the_step_of_a_lattice_is_found(step):
    assert angular_step(*lattice(step), RangeImageSettings()) == pytest.approx(step, rel=0.02)


def test_the_order_of_the_points_changes_little(rng=np.random.default_rng(1)):
    azimuth, elevation = lattice(0.0006)
    order = rng.permutation(len(azimuth))

    step = angular_step(azimuth[order], elevation[order], RangeImageSettings())
    assert step == pytest.approx(0.0006, rel=0.02)


def test_gaps_do_not_widen_it():
    azimuth, elevation = lattice(0.0006)
    seen = (azimuth < 0.02) | (azimuth > 0.05)

    step = angular_step(azimuth[seen], elevation[seen], RangeImageSettings())
    assert step == pytest.approx(0.0006, rel=0.02)


def test_too_few_points_have_none():
    assert angular_step(np.zeros(5), np.zeros(5), RangeImageSettings()) == 0.0
