"""Loops over points that numpy cannot express, compiled by numba and kept on disk where that is possible."""

from contextlib import suppress
from typing import Any, Callable

from numba import njit

from .errors import CancelledError


class ForgivingCache:
    """The cache of a compiled function, whose damage or full disk costs the time to compile, not the run.

    Parameters
    ----------
    cache : numba.core.caching.FunctionCache
    """

    def __init__(self, cache: Any) -> None:
        self._cache = cache

    def __getattr__(self, name: str) -> Any:
        return getattr(self._cache, name)

    def load_overload(self, *arguments: Any) -> Any:
        """Return what is kept; nothing if it cannot be read, and then empty the cache."""
        # What a damaged pickle raises is not limited.
        try:
            return self._cache.load_overload(*arguments)
        except CancelledError:
            raise
        except Exception:
            with suppress(Exception):
                self._cache.flush()
            return None

    def save_overload(self, *arguments: Any) -> None:
        """Keep what was compiled, if the disk allows."""
        with suppress(Exception):
            self._cache.save_overload(*arguments)


def kernel(function: Callable[..., Any]) -> Any:
    """Compile a function at its first call, without the lock of Python, and keep it for the next runs.

    Where neither the folder of the plugin nor that of the user can be written, it is compiled in every run.

    Parameters
    ----------
    function : callable
        In the part of Python that numba compiles.
    """
    try:
        compiled = njit(nogil=True, cache=True)(function)
    except RuntimeError:
        return njit(nogil=True)(function)
    compiled._cache = ForgivingCache(compiled._cache)
    return compiled
