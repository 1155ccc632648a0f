"""Work ahead of the caller and on several cores gives what a plain loop gives."""

import threading
import time

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.parallel import ahead, apart, in_order, in_parts
from ichnograph.algorithms.progress import Progress


@pytest.mark.parametrize("count", [0, 1, 2, 50])
def test_items_come_in_order(count):
    assert list(ahead(range(count))) == list(range(count))
    assert list(in_order(lambda item: item**2, range(count))) == [item**2 for item in range(count)]


def test_parts_are_all_rows_once():
    rows = np.zeros(1003, int)

    def add(part):
        rows[part] += 1

    in_parts(add, len(rows), 10)
    assert rows.tolist() == [1] * 1003


def test_the_next_item_is_made_while_the_caller_works_on_the_last():
    made = threading.Event()

    def items():
        yield from (0, 1)
        made.set()
        yield 2

    reader = ahead(items())
    assert (next(reader), next(reader)) == (0, 1)
    assert made.wait(10)
    assert list(reader) == [2]


def test_who_takes_the_first_item_only_does_not_wait_for_the_second():
    made = []

    def items():
        for item in range(3):
            made.append(item)
            yield item

    assert next(ahead(items())) == 0
    assert made == [0]


def test_several_items_are_worked_on_at_once_but_not_all(monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    asked, together = [], threading.Barrier(2)

    def items():
        for item in range(1000):
            asked.append(item)
            yield item

    def work(item):
        if item < 2:
            together.wait(10)
        return item

    assert next(iter(in_order(work, items()))) == 0
    assert len(asked) < 1000


def test_an_error_reaches_the_caller():
    def fails(item):
        time.sleep(0.001)
        raise ValueError(item)

    def broken():
        yield from (0, 1)
        raise ValueError("third")

    with pytest.raises(ValueError, match="0"):
        list(in_order(fails, [0, 1]))
    with pytest.raises(ValueError, match="third"):
        list(ahead(broken()))


def test_a_long_call_gives_its_result_or_its_error():
    assert apart(sorted, [3, 1, 2]) == [1, 2, 3]
    with pytest.raises(ZeroDivisionError):
        apart(divmod, 1, 0)


def test_a_cancel_does_not_wait_for_the_end_of_a_long_call():
    ended = threading.Event()
    start = time.monotonic()
    with pytest.raises(CancelledError):
        apart(ended.wait, 60, progress=Progress(is_cancelled=lambda: True))
    ended.set()
    assert time.monotonic() - start < 30
