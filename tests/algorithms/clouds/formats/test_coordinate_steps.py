"""Coordinates that went through single precision are recognised, whatever holds them now."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.coordinate_steps import (
    coordinate_warnings,
    height_warning,
    rounding_warning,
    step_warning,
    unit_warning,
)

PATH = Path("scan.ply")
NATIONAL = np.array([412345.0, 5812345.0, 71.0])


def points(decimals=4):
    return np.round(np.random.default_rng(0).random((300, 3)) * 10, decimals)


def test_single_precision_at_national_coordinates_is_said_with_its_steps():
    single = (points() + NATIONAL).astype(np.float32).astype(float)
    (warning,) = step_warning(PATH, single)

    assert "scan.ply have single precision" in warning
    assert "0.031 m in x, 0.5 m in y;" in warning


def test_the_steps_are_seen_through_the_decimals_of_a_text():
    single = np.round((points() + NATIONAL).astype(np.float32).astype(float), 3)
    assert "0.5 m in y" in step_warning(PATH, single)[0]


@pytest.mark.parametrize("origin", [0.0, 100.0])
def test_single_precision_near_the_origin_is_fine(origin):
    assert step_warning(PATH, (points() + origin).astype(np.float32).astype(float)) == ()


def test_double_precision_is_fine_anywhere():
    assert step_warning(PATH, points(3) + NATIONAL) == ()


def test_the_unit_of_the_file_counts():
    millimetres = (1000 * (points() + [0, 0, 20_000])).astype(np.float32).astype(float)
    assert "0.002 m in z" in step_warning(PATH, millimetres, (1e-3, 1e-3, 1e-3))[0]


@pytest.mark.parametrize("step", [1.0, 2.0])
def test_coordinates_that_are_rounded_to_metres_have_no_single_precision(step):
    whole = np.round((100 * points() + NATIONAL) / step) * step
    assert step_warning(PATH, whole) == ()


def test_whole_numbers_over_more_than_a_hundred_may_be_millimetres():
    millimetres = np.round(1000 * points())
    assert "are whole numbers, which were read as metres" in unit_warning(PATH, millimetres)[0]
    assert unit_warning(PATH, millimetres, unit_stated=True) == ()
    assert unit_warning(PATH, np.round(10 * points() / np.ptp(points()))) == ()
    assert unit_warning(PATH, millimetres + [0.5, 0, 0]) == ()


def test_a_cloud_higher_than_any_building_may_be_in_millimetres():
    heights = np.linspace(0, 2.5, 100)
    assert "reach over 2450 m in height" in height_warning(PATH, 1000 * heights)[0]
    assert height_warning(PATH, heights) == ()
    # A single stray point is not the height of the cloud.
    assert height_warning(PATH, np.append(heights, 5000)) == ()


@pytest.mark.parametrize("step", [0.01, 0.1, 1.0, 100.0])
def test_coordinates_that_a_spreadsheet_rounded_are_said(step):
    rounded = np.round((100 * points() + NATIONAL) / step) * step
    (warning,) = rounding_warning(PATH, rounded)
    said = f"{step:g} m in x, {step:g} m in y, {step:g} m in z"
    assert f"scan.ply are multiples of {said}; if they were rounded" in warning


def test_millimetres_and_equal_heights_are_not_rounded():
    assert rounding_warning(PATH, points(3) + NATIONAL) == ()
    assert rounding_warning(PATH, np.round(1000 * points()), (1e-3, 1e-3, 1e-3)) == ()
    assert rounding_warning(PATH, points(3) * [1, 1, 0]) == ()


def test_points_at_zero_are_said_where_others_are_elsewhere():
    lost = points()
    lost[:30] = 0
    assert "10.0% of the points of scan.ply are at 0, 0, 0" in coordinate_warnings(PATH, lost)[0]
    assert coordinate_warnings(PATH, points()) == ()
    lost[1:] = points()[1:]
    assert coordinate_warnings(PATH, lost) == ()


def test_few_of_many_points_at_zero_are_strays():
    many = np.random.default_rng(0).random((20_000, 3))
    many[:12] = 0
    assert coordinate_warnings(PATH, many) == ()
    many[:40] = 0
    assert "0.2% of the points" in coordinate_warnings(PATH, many)[0]


@pytest.mark.parametrize("decimals", [0, 1, 2, 3])
def test_coordinates_that_may_be_millimetres_are_not_said_to_be_rounded(decimals):
    (warning,) = coordinate_warnings(PATH, np.round(343 * points(), decimals))
    assert "millimetres" in warning


def test_a_high_cloud_in_single_precision_has_both_faults():
    single = ((points() * [1, 1, 200]) + NATIONAL).astype(np.float32).astype(float)
    warnings = coordinate_warnings(PATH, single)
    assert ["single precision" in warnings[0], "in height" in warnings[1]] == [True, True]


def test_slices_at_round_heights_are_not_rounded():
    slices = points()
    slices[:, 2] = 1 + np.arange(len(slices)) % 2
    assert rounding_warning(PATH, slices) == ()


def test_few_different_national_coordinates_are_rounded():
    rounded = points() + NATIONAL
    rounded[:, 1] = np.where(rounded[:, 2] < 75, 5_812_300.0, 5_812_400.0)
    assert "multiples of 100 m in y;" in rounding_warning(PATH, rounded)[0]
