"""Errors that the number of points does not average out."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.common_errors import (
    CommonErrorSettings,
    common_covariance,
    dim_white_error,
    footprint_error,
)

SETTINGS = CommonErrorSettings(range_m=0.0001, direction=1e-5)


def test_along_the_ray_ranges_err_and_across_it_directions_do_in_proportion_to_the_distance():
    covariance = common_covariance(np.array([0.0, 20.0, 0.0]), 0.0, SETTINGS)

    assert np.sqrt(np.diag(covariance)) == pytest.approx([0.0002, 0.0001, 0.0002])
    assert covariance == pytest.approx(np.diag(np.diag(covariance)))


def test_a_further_error_along_the_ray_adds_to_that_of_the_range():
    ray = np.array([0.6, 0.0, 0.8])
    covariance = common_covariance(10 * ray, 0.0003, SETTINGS)

    assert ray @ covariance @ ray == pytest.approx(0.0001**2 + 0.0003**2)
    assert covariance[1, 1] == pytest.approx(0.0001**2)


def test_white_seen_squarely_is_measured_as_white():
    assert dim_white_error(0.002, 100.0, 1000.0, 0.0, SETTINGS) == 0.0


def test_white_seen_at_60_degrees_lacks_half_its_light_and_is_off_by_as_much_of_the_step():
    # Black lacks 900 of 1000 and is off by 1.8 mm; white lacks 1000 of 2000, and half of that is taken.
    found = dim_white_error(-0.0018, 100.0, 1000.0, 60.0, SETTINGS)

    assert found == pytest.approx(0.5 * 0.0018 * 1000 / 900)


def test_the_mean_depth_of_a_footprint_on_a_sphere_is_that_of_many_rays():
    radius, width = 0.0725, SETTINGS.footprint(10.0)
    away = np.random.default_rng(0).normal(0.0, width, (100_000, 2))
    depth = radius - np.sqrt(radius**2 - np.sum(away**2, axis=1))

    assert footprint_error(10.0, radius, SETTINGS) == pytest.approx(depth.mean(), rel=0.02)
