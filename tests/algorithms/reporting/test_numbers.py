"""Numbers as people read them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.reporting.numbers import MISSING, number, round_step


@pytest.mark.parametrize(
    ("value", "text"),
    [(1.25, "1.2"), (None, MISSING), (float("nan"), MISSING), (-0.04, "0.0"), (-0.06, "-0.1")],
)
def test_a_number_has_its_decimals_and_one_that_is_not_known_is_a_dash(value, text):
    assert number(value, 1) == text


@given(st.floats(1e-9, 1e9))
def test_a_round_step_is_below_a_value_but_near_it(value):
    step = round_step(value)
    mantissa = step / 10 ** np.floor(np.log10(step) + 1e-9)

    assert round(mantissa) in (1, 2, 5)
    assert value / 2.5 * (1 - 1e-6) <= step <= value * (1 + 1e-6)
