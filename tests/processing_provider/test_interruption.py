"""A cancelled algorithm ends within a second, whatever it computes; compiling is announced."""

import threading
import time

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.processing_provider.interruption import compilation_announced, interruptible

pytestmark = pytest.mark.alone


def busy(seconds):
    """Compute without ever asking whether to stop."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        np.linalg.svd(np.ones((60, 60)))


def test_a_step_that_never_asks_is_cancelled_within_a_second():
    cancelled = threading.Event()
    threading.Timer(0.2, cancelled.set).start()
    start = time.monotonic()
    with pytest.raises(CancelledError, match=r"Cancelled\."), interruptible(cancelled.is_set):
        busy(10)

    assert time.monotonic() - start < 0.2 + 0.1 + 0.5 + 1.0


def test_files_are_closed_and_clean_up_runs_as_after_any_error():
    done = []
    with pytest.raises(CancelledError), interruptible(lambda: True):
        try:
            busy(10)
        finally:
            done.append("cleaned up")

    assert done == ["cleaned up"]


def test_a_block_that_notices_by_itself_is_not_interrupted():
    with interruptible(lambda: True):
        busy(0.2)
    busy(0.8)


def test_nothing_happens_without_a_cancel():
    with interruptible(lambda: False):
        busy(0.3)

    assert not [thread for thread in threading.enumerate() if thread.name == "cancel"]


def test_compiling_is_announced_once():
    numba = pytest.importorskip("numba")
    said = []
    with compilation_announced(said.append):
        kernels = [numba.njit(lambda x: x + 1), numba.njit(lambda x: x - 1)]
        assert [kernel(1) for kernel in kernels] == [2, 0]
        assert [kernel(1) for kernel in kernels] == [2, 0]

    assert len(said) == 1 and "compiles" in said[0]
    numba.njit(lambda x: x * 2)(1)
    assert len(said) == 1


def test_an_interrupt_that_is_lost_in_a_callback_comes_again():
    start = time.monotonic()
    with pytest.raises(CancelledError), interruptible(lambda: True):
        try:
            busy(10)
        except CancelledError:
            busy(10)

    assert time.monotonic() - start < 0.1 + 0.5 + 1.0 + 1.0
