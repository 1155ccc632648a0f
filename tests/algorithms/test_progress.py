"""Progress: parts of parts report their share of the whole, and every update can be cancelled."""

import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.progress import Progress


def reports():
    """Return a list, and the progress that reports to it."""
    said = []
    return said, Progress(lambda fraction, message: said.append((fraction, message)))


def test_a_part_of_a_part_reports_its_share_of_the_whole():
    said, progress = reports()
    progress.part(0.5, 1.0).part(0.0, 0.5).update(0.5, "halfway")

    assert said == [(0.625, "halfway")]


def test_a_part_neither_begins_before_its_start_nor_ends_after_its_stop():
    said, progress = reports()
    part = progress.part(0.2, 0.4)
    part.update(-1.0)
    part.update(2.0)

    assert [fraction for fraction, _ in said] == pytest.approx([0.2, 0.4])


def test_a_cancelled_run_stops_at_the_next_update_and_reports_nothing():
    said = []
    progress = Progress(lambda fraction, message: said.append(fraction), lambda: True)
    with pytest.raises(CancelledError):
        progress.part(0.0, 0.5).update(0.1, "on")
    assert said == []


def test_without_a_caller_progress_is_ignored():
    Progress().update(0.5, "on")
