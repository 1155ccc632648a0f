"""Simulations that several tests look at."""

import pytest
from ichnograph.algorithms.registration.simulation.simulation import simulate
from ichnograph.tests.algorithms.registration.simulation.simulated import FEW, box_at, points
from ichnograph.tests.scenes.targets import target_scene


@pytest.fixture(scope="module")
def building():
    return target_scene(40, 5, 5, seed=3).control


@pytest.fixture(scope="module")
def found(building):
    return simulate(building, trials=FEW)


@pytest.fixture(scope="module")
def box():
    return simulate(points(box_at((500_000, 5_700_000, 100))), targets_per_scan=8, trials=5)
