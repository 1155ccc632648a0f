"""The schedule: a row for each detail."""

import csv

import numpy as np
import pytest
from ichnograph.algorithms.facade.output.schedule import write_schedule
from ichnograph.tests.algorithms.facade.samples import site_of, small_elevation

TOLERANCE = 1e-5
"""A hundredth of a millimetre (m)."""


def test_the_schedule_has_a_row_for_each_detail(tmp_path):
    write_schedule(tmp_path / "schedule.csv", small_elevation())
    with (tmp_path / "schedule.csv").open(newline="") as stream:
        (row,) = csv.DictReader(stream)

    assert (row["id"], row["kind"], row["width"], row["height"]) == ("1", "opening", "1.0", "1.5")
    middle = site_of(row, [(float(row["u"]), float(row["v"]))])
    np.testing.assert_allclose(
        middle, small_elevation().frame.world([[1.5, 1.75, 0]]), atol=TOLERANCE, rtol=0
    )


def test_what_was_not_seen_is_empty(tmp_path):
    write_schedule(tmp_path / "schedule.csv", small_elevation())
    with (tmp_path / "schedule.csv").open(newline="") as stream:
        (row,) = csv.DictReader(stream)
    assert row["width_std"] == "" and float(row["height_std"]) == pytest.approx(0.00361)


def test_the_same_elevation_gives_the_same_bytes(tmp_path):
    for name in "ab":
        write_schedule(tmp_path / f"{name}.csv", small_elevation())
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
