"""The report of a facade."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.facade.development.curves import Circle
from ichnograph.algorithms.facade.elevation import COLOURED, LeftOut
from ichnograph.algorithms.facade.output.report import write_report
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.tests.algorithms.facade.buildings.sites import block, level
from ichnograph.tests.algorithms.facade.samples import bare, small_elevation
from shapely.geometry import box

pytest.importorskip("jinja2", reason="jinja2 is not installed")


@pytest.fixture
def written(tmp_path):
    def write(selection, elevation):
        write_report(tmp_path / "report.html", selection, elevation)
        return (tmp_path / "report.html").read_text(encoding="utf-8")

    return write


@pytest.fixture(scope="module")
def selection():
    xyz = block()
    return select_facade(bare(xyz + np.random.default_rng(0).normal(0, 0.002, xyz.shape)), number=2)


def test_it_lists_every_facade_and_marks_the_one_that_is_drawn(written, selection):
    page = written(selection, small_elevation())
    assert "Facade 2 of 2" in page
    marked = [row for row in page.split("<tr")[1:] if row.startswith(" class=")]
    assert len(marked) == 1 and ">2</td>" in marked[0]
    assert "<svg" in page


def test_sizes_with_an_edge_that_was_not_seen_are_in_brackets(written, selection):
    page = written(selection, small_elevation())
    assert "(1.000)" in page and "1.500 ±" in page


def test_warnings_are_written(written, selection):
    page = written(selection, replace(small_elevation(), warnings=("The side is doubtful.",)))
    assert "The side is doubtful." in page


def test_what_is_left_out_is_added_up_by_reason(written, selection):
    stain = LeftOut(box(2, 1, 3, 2), COLOURED, "no straight sides", 1.25)
    page = written(selection, replace(small_elevation(), left_out=(stain, stain)))
    assert "no straight sides" in page and "2.50" in page
    assert "Left out" not in written(selection, small_elevation())


def test_the_radius_of_a_tower_that_is_rolled_out_is_said(written, selection):
    tower = Circle(np.array([3.0, 6.0]), 2.125, 180.0)
    assert "on a radius of 2.125 m" in written(selection, replace(small_elevation(), curve=tower))
    assert "rolled out" not in written(selection, small_elevation())


def test_a_cloud_without_facades_has_no_key_plan(written):
    page = written(select_facade(bare(level(0, 0, 5, 5, 0))), small_elevation())
    assert "<svg" not in page and "Details" in page


@pytest.mark.parametrize("side", [0.0, 180.0])
def test_the_table_states_the_side_from_which_the_facade_was_measured(written, selection, side):
    azimuth = (selection.chosen.azimuth + side) % 360
    elevation = small_elevation()
    page = written(selection, replace(elevation, frame=replace(elevation.frame, azimuth=azimuth)))
    (marked,) = [row for row in page.split("<tr")[1:] if row.startswith(" class=")]
    assert f">{azimuth:.0f}</td>" in marked
