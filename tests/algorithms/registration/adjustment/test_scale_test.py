"""The test of the scale, and the advice that follows."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import HALL, register, scanned

SITE = HALL * 3


def scale_test(scale=1.0, model=Model.RIGID, noise=0.0, seed=0, site=SITE):
    return register(site, scanned(site, scale=scale, noise=noise, seed=seed)[0], model=model).scale_test


def test_a_scale_that_the_model_lacks_is_reported():
    scan = register(SITE, scanned(SITE, scale=1.0004)[0])

    assert scan.scale_test.significant
    assert scan.scale_test.deviation == pytest.approx(400, abs=40)
    assert "choose a model with scale" in scan.scale_test.advice
    assert any("differs from 1 by +400 ppm" in warning for warning in scan.warnings)


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY, Model.LEVELLED, Model.LEVELLED_SCALE])
def test_the_true_scale_is_found_with_and_without_a_model_that_has_it(model):
    found = scale_test(1.0003, model)

    assert found.deviation == pytest.approx(300, abs=1)
    assert found.significant


def test_one_scan_in_a_hundred_has_a_scale_by_accident():
    found = [scale_test(noise=0.003, seed=seed) for seed in range(150)]

    assert sum(item.significant for item in found) <= 6
    ratios = [(item.deviation / item.std) ** 2 for item in found]
    assert sum(ratios) / len(ratios) == pytest.approx(1.1, abs=0.35), "Student's t of 17 degrees of freedom"


def test_the_advice_names_the_projection_only_for_its_deviations():
    projection, small = scale_test(1.0004), scale_test(1.00003, site=2 * SITE)
    large = scale_test(1.0008, site=HALL)

    assert "projection" in projection.advice
    assert small.significant and "calibration" in small.advice
    assert large.significant and "calibration" in large.advice


def test_a_scale_that_moves_targets_by_less_than_the_tolerance_is_not_one_of_a_projection():
    small = HALL * 0.5
    found = scale_test(0.9996, site=small)

    assert found.significant
    assert "projection" not in found.advice
    assert "3.5 mm over the 9 m of the targets" in found.advice


def test_an_unknown_scale_is_stated_in_metres():
    assert "One unit of the scan is 0.3048 m." in scale_test(0.3048, Model.UNKNOWN_SCALE).advice


def test_the_fewest_targets_have_redundancy_for_the_test():
    two = register(HALL[:5], scanned(HALL[[1, 4]])[0], model=Model.LEVELLED)

    assert two.registered
    assert np.isfinite(two.scale_test.deviation)
