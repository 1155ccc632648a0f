"""Cancelling within a second, and a word while kernels are compiled.

The core asks between its steps whether to stop. Some steps are one long call of another package, or have no
progress of their own, such as the figures of a report. While an algorithm runs, a second thread watches the
feedback. Half a second after a cancel it raises `CancelledError` in the thread that computes, between two
instructions of Python, so that files are closed and outputs are rolled back as after any other error.
"""

import ctypes
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, Callable

from ..algorithms.errors import CancelledError

POLL_S = 0.1
GRACE_S = 0.5
"""Time in which the core notices by itself."""

AGAIN_S = 1.0
"""Time after which it is interrupted again: what is raised in a callback of another package may be lost."""


class _InterruptedError(CancelledError):
    """Raised by the watching thread, which cannot pass a message."""

    def __init__(self, message: str = "Cancelled.") -> None:
        super().__init__(message)


@contextmanager
def interruptible(is_cancelled: Callable[[], bool]) -> Iterator[None]:
    """Interrupt the block if it still runs half a second after it was cancelled.

    Parameters
    ----------
    is_cancelled : callable() -> bool

    Raises
    ------
    CancelledError
    """
    ended, turn = threading.Event(), threading.Lock()
    computing = ctypes.c_ulong(threading.get_ident())

    def watch() -> None:
        while not ended.wait(POLL_S):
            if is_cancelled():
                break
        pause = GRACE_S
        while not ended.wait(pause):
            with turn:
                if not ended.is_set():
                    ctypes.pythonapi.PyThreadState_SetAsyncExc(computing, ctypes.py_object(_InterruptedError))
            pause = AGAIN_S

    watcher = threading.Thread(target=watch, name="cancel", daemon=True)
    watcher.start()
    try:
        yield
    finally:
        while watcher.is_alive():
            # What is raised while the block ends must not leave the watcher behind.
            with suppress(_InterruptedError):
                with turn:
                    ended.set()
                watcher.join()


@contextmanager
def compilation_announced(announce: Callable[[str], None]) -> Iterator[None]:
    """Say once that kernels are compiled, if that happens in the block.

    Parameters
    ----------
    announce : callable(str)
    """
    try:
        from numba.core import event
    except ImportError:
        # Without numba, nothing is compiled.
        yield
        return

    class Listener(event.Listener):
        announced = False

        def on_start(self, event: Any) -> None:
            if not self.announced:
                self.announced = True
                announce("The first run on this computer compiles its kernels, which takes up to a minute.")

        def on_end(self, event: Any) -> None:
            pass

    with event.install_listener("numba:compile", Listener()):
        yield
