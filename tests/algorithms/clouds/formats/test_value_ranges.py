"""Intensity and colour of any range become 0..65535."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.value_ranges import (
    intensity_scale,
    rgb_factor,
    scaled_colour,
    to_uint16,
)
from ichnograph.algorithms.errors import InputError


@pytest.mark.parametrize(
    ("values", "signed", "low", "high"),
    [
        ([0.0, 0.25, 1.0], False, 0.0, 1.0),
        ([-2048, 0, 2047], False, -2048, 2047),
        ([0, 100, 2047], True, -2048, 2047),
        ([0, 100, 65535], False, 0, 65535),
        ([-30.5, -3.0, 5.25], False, -30.5, 5.25),
        ([0, 100, 200_000], False, 0, 200_000),
    ],
)
def test_the_ends_of_the_range_become_0_and_65535(values, signed, low, high):
    summand, factor = intensity_scale(np.array(values, float), signed)
    assert (low + summand) * factor == pytest.approx(0)
    assert (high + summand) * factor == pytest.approx(65535)


def test_small_whole_numbers_are_kept_where_the_format_has_no_largest_intensity():
    assert intensity_scale(np.array([0.0, 1.0, 1.0])) == (0.0, 1.0)
    assert intensity_scale(np.array([0.0, 7.0, 255.0])) == (0.0, 1.0)


@pytest.mark.parametrize("largest", [1.0, 255.0])
def test_the_largest_intensity_becomes_65535_where_the_format_has_one(largest):
    assert intensity_scale(np.array([0.0, largest]), relative=True)[1] * largest == 65535


def test_what_is_not_a_number_does_not_count():
    assert intensity_scale(np.array([np.nan, 0.5])) == (0.0, 65535.0)


@pytest.mark.parametrize(
    ("brightest", "factor"),
    [([0.5, 1.0, 0.0], 65535), ([255, 0, 1], 257), ([256, 0, 1], 1), ([65535, 9, 1], 1)],
)
def test_the_brightest_colour_decides_how_many_bits_there_are(brightest, factor):
    assert rgb_factor(np.array([brightest, [0, 0, 0]], float)) == factor


def test_a_colour_that_contradicts_the_sample_of_its_file_is_refused():
    np.testing.assert_array_equal(
        scaled_colour(Path("a.ply"), np.array([[0, 1, 255]]), 257.0), [[0, 257, 65535]]
    )
    with pytest.raises(InputError, match=r"a\.ply has colours above 255"):
        scaled_colour(Path("a.ply"), np.array([[0, 1, 256]]), 257.0)


def test_values_are_rounded_and_clipped():
    values = to_uint16(np.array([-5.0, 0.4, 0.6, 65534.7, 70000.0, np.nan]))
    np.testing.assert_array_equal(values, [0, 0, 1, 65535, 65535, 0])
    assert values.dtype == np.uint16


def test_eight_bits_are_not_the_range_of_pts():
    assert intensity_scale(np.array([0.0, 7.0, 255.0]), signed=True) == (0.0, 1.0)
