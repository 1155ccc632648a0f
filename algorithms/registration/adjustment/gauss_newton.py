"""The iteration that all least squares adjustments share."""

from typing import Callable, TypeVar

import numpy as np

from .settings import IterationSettings

State = TypeVar("State")


def iterated(
    advance: Callable[[State], tuple[State, np.ndarray]],
    state: State,
    settings: IterationSettings = IterationSettings(),
) -> State:
    """Return the state after Gauss-Newton steps, when no unknown changes any more.

    Parameters
    ----------
    advance : callable
        Takes a state, and returns the next one and the step of the unknowns that leads to it.
    state : object
        Start values.
    settings : IterationSettings
    """
    for _ in range(settings.most_rounds):
        state, step = advance(state)
        if np.abs(step).max() < settings.smallest_step:
            break
    return state
