"""The tests that a candidate must pass."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.examination import Examination, FailedError
from ichnograph.algorithms.targets.results import Kind


@pytest.fixture
def examination():
    return Examination(Kind.SPHERE, np.array([1.0, 2.0, 3.0]))


def test_the_first_failure_says_what_was_found_and_how_many_tests_were_passed(examination):
    examination.at_least("points", 20, 16)
    examination.at_most("scatter", 0.001, 0.005, "m")
    with pytest.raises(FailedError) as caught:
        examination.at_most("difference of the diameter", 0.02, 0.003, "m")

    rejection = caught.value.rejection
    assert (rejection.test, rejection.passed) == ("difference of the diameter", 2)
    assert (rejection.value, rejection.limit, rejection.unit) == (0.02, 0.003, "m")


def test_a_value_that_is_unknown_fails(examination):
    with pytest.raises(FailedError):
        examination.at_least("share", float("nan"), 0.5)


def test_what_is_missing_fails_and_what_is_found_is_returned(examination):
    assert examination.found("plane", "the plane") == "the plane"
    with pytest.raises(FailedError):
        examination.found("plane", None)
