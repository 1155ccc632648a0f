"""Automatic beside manual lengths, as the paper's table 1."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.evaluation.length_lists import LengthList, MeasuredLength
from ichnograph.algorithms.evaluation.lengths import compare_lengths

SCHEDULE = LengthList(
    "schedule.csv",
    (
        MeasuredLength("1", "width", 1.204, 0.002),
        MeasuredLength("1", "height", 1.502, 0.004),
        MeasuredLength("1", "sill", 0.9),
        MeasuredLength("2", "width", 0.998),
    ),
)


def compare(*manual):
    return compare_lengths(SCHEDULE, LengthList("tape.csv", tuple(MeasuredLength(*item) for item in manual)))


THREE = (("1", "width", 1.2), ("2", "width", 1.0), ("1", "height", 1.5))


def test_lengths_are_paired_by_id_and_dimension_in_the_order_of_the_reference():
    found = compare(*THREE)

    assert [(item.id, item.dimension) for item in found.lengths] == [item[:2] for item in THREE]
    np.testing.assert_allclose(found.differences, [0.004, -0.002, 0.002], atol=1e-9)
    np.testing.assert_array_equal([item.std for item in found.lengths], [0.002, np.nan, 0.004])
    assert found.warnings == ()


def test_mean_standard_deviation_and_largest_are_those_of_the_differences():
    found = compare(*THREE)

    assert found.mean == pytest.approx(0.004 / 3)
    assert found.std == pytest.approx(np.std([0.004, 0.002, -0.002], ddof=1))
    assert found.largest == pytest.approx(0.004)


def test_a_single_length_has_no_standard_deviation():
    assert np.isnan(compare(("1", "width", 1.2)).std)


def test_what_the_schedule_does_not_have_is_named():
    found = compare(("1", "width", 1.2), ("9", "width", 3.0), ("2", "sill", 1.0))

    assert found.warnings == ("schedule.csv has no width of 9, sill of 2.",)


def test_without_a_common_length_there_is_nothing_to_compare():
    with pytest.raises(NothingFoundError, match=r"schedule\.csv has no length of tape\.csv; use the ids"):
        compare(("9", "width", 1.2))
