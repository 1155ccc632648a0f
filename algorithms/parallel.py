"""Work on several cores: what comes next is made while the caller works on what came before."""

import os
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from threading import Thread
from typing import Any, Callable, TypeVar

from .progress import Progress

Item = TypeVar("Item")
Result = TypeVar("Result")

WAITING = 2
"""Items for each core that are begun: fewer leave cores idle, more hold memory without gain."""


POLL_S = 0.1
"""Between two looks whether a long call has ended, or the user has cancelled."""


def apart(function: Callable[..., Result], *arguments: Any, progress: Progress = Progress()) -> Result:
    """Return the result of one long call of another package, which a cancel need not wait for.

    The call has a thread of its own, so the thread of the caller can be interrupted while it waits. After a
    cancel the call runs to its end in vain; it must leave the lock of Python and change nothing.

    Parameters
    ----------
    function : callable
    *arguments
    progress : Progress
        Asked whether to stop.

    Raises
    ------
    CancelledError
    """
    outcome: Future[Result] = Future()

    def call() -> None:
        try:
            outcome.set_result(function(*arguments))
        except BaseException as error:
            outcome.set_exception(error)

    Thread(target=call, name=getattr(function, "__name__", "call"), daemon=True).start()
    while not outcome.done():
        wait([outcome], POLL_S)
        progress.check()
    return outcome.result()


def ahead(items: Iterable[Item]) -> Iterator[Item]:
    """Yield items in order, each made by a second thread while the caller works on the one before.

    The first is not, so that a caller who takes no more does not wait for the second.
    """
    iterator = iter(items)
    end: Any = object()
    item = next(iterator, end)
    if item is end:
        return
    yield item
    with ThreadPoolExecutor(1) as pool:
        following = pool.submit(next, iterator, end)
        while (item := following.result()) is not end:
            following = pool.submit(next, iterator, end)
            yield item


def in_parts(work: Callable[[slice], None], count: int, part: int) -> None:
    """Call `work` for slices of so many rows, on all cores."""
    slices = (slice(start, start + part) for start in range(0, count, part))
    for _ in in_order(work, slices):
        pass


def in_order(function: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
    """Yield `function(item)` for items in order, computed on all cores.

    Parameters
    ----------
    function : callable
        Without side effects that other calls see; fast on several cores if it works in kernels and numpy.
    items : iterable
        Asked in the thread of the caller, not much sooner than needed.
    """
    workers = os.cpu_count() or 1
    waiting: deque[Future[Result]] = deque()
    with begun_only(workers) as pool:
        for item in items:
            waiting.append(pool.submit(function, item))
            if len(waiting) > WAITING * workers:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()


@contextmanager
def begun_only(workers: int) -> Iterator[ThreadPoolExecutor]:
    """Return threads that, if the caller stops or fails, finish what they have begun and no more."""
    pool = ThreadPoolExecutor(workers)
    try:
        yield pool
    finally:
        pool.shutdown(cancel_futures=True)
