"""Progress: fractions of a whole, and cancelling."""

import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.progress import Progress


@pytest.fixture
def reports():
    return []


@pytest.fixture
def progress(reports):
    return Progress(lambda fraction, message: reports.append((fraction, message)))


def test_the_whole_is_reported_as_it_is(progress, reports):
    progress.update(0.25, "Reading")

    assert reports == [(0.25, "Reading")]


def test_a_part_covers_its_share_of_the_whole(progress, reports):
    part = progress.part(0.5, 0.9)
    part.update(0.0)
    part.update(0.5)
    part.update(1.0)

    assert [fraction for fraction, _ in reports] == pytest.approx([0.5, 0.7, 0.9])


def test_a_part_of_a_part_covers_its_share_of_that(progress, reports):
    progress.part(0.5, 1.0).part(0.0, 0.5).update(1.0)

    assert reports == [(0.75, "")]


@pytest.mark.parametrize(("given", "reported"), [(-0.1, 0.2), (1.5, 0.6)])
def test_fractions_outside_of_a_part_are_cut(progress, reports, given, reported):
    progress.part(0.2, 0.6).update(given)

    assert reports == [(pytest.approx(reported), "")]


def test_a_cancelled_task_stops_at_its_next_update_and_reports_nothing(reports):
    answers = iter([False, True])
    progress = Progress(lambda *report: reports.append(report), lambda: next(answers)).part(0.0, 0.5)
    progress.update(0.1)
    with pytest.raises(CancelledError):
        progress.update(0.2)

    assert len(reports) == 1


def test_a_task_without_a_listener_reports_to_nobody():
    Progress().part(0.1, 0.2).update(0.5, "unheard")
