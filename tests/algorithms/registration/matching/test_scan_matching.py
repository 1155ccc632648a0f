"""The decision about the best solution."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import labels, register, scanned

COLUMNS = np.array([[6.0 * x, 6.0 * y, 1.5] for x in range(6) for y in range(5)])


@pytest.mark.parametrize("seed", range(40))
def test_a_nearly_regular_hall_is_never_labelled_wrong_even_if_sigma_is_too_small(seed):
    random = np.random.default_rng(seed)
    control = COLUMNS + random.normal(0, random.choice([0.0, 0.003, 0.01, 0.03]), COLUMNS.shape)
    seen = random.choice(len(control), random.integers(4, 10), replace=False)
    targets, _ = scanned(control[seen], heading=random.uniform(0, 360), noise=0.002, seed=seed)
    targets[0] += random.choice([0.0, 0.01, 0.1]) * np.array([0.6, 0.8, 0.0])
    scan = register(control, targets, sigma=0.001, model=Model([0, 2][seed % 2]))

    truth = {str(row + 1): f"P{number + 1}" for row, number in enumerate(seen)}
    assert not scan.registered or labels(scan).items() <= truth.items()
