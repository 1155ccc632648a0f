"""The iteration: it stops when nothing changes, or after the most rounds."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.gauss_newton import iterated
from ichnograph.algorithms.registration.adjustment.settings import IterationSettings


def towards_root_of_two(x):
    step = np.array([(2 - x * x) / (2 * x)])
    return x + step[0], step


def test_it_converges():
    assert iterated(towards_root_of_two, 1.0) == pytest.approx(np.sqrt(2), abs=1e-15)


def test_it_stops_after_a_small_step():
    calls = []

    def advance(state):
        calls.append(state)
        return state + 1, np.array([10.0 ** -len(calls)])

    assert iterated(advance, 0, IterationSettings(smallest_step=5e-4)) == 4


def test_it_stops_after_the_most_rounds():
    assert iterated(lambda state: (state + 1, np.ones(2)), 0, IterationSettings(most_rounds=7)) == 7
