"""The test of the scale."""

import pytest
from ichnograph.tests.algorithms.registration.hall import (
    HALL,
    register,
    scanned,
)


def test_a_scale_that_the_model_lacks_is_told():
    targets, _ = scanned(HALL * 3, scale=1.0004)
    scan = register(HALL * 3, targets, sigma=0.003)

    assert scan.scale_test.significant
    assert scan.scale_test.deviation == pytest.approx(400, abs=40)
    assert "model with scale" in scan.scale_test.advice
    assert any("differs from 1 by +400 ppm" in warning for warning in scan.warnings)
