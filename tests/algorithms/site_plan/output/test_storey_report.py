"""The part of the report about the storey."""

from dataclasses import replace

import pytest
from ichnograph.algorithms.site_plan.output.plan_report import write_report
from ichnograph.algorithms.site_plan.output.storey_report import LEFT_OUT, LIMIT, decided_by, shown
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.storeys.evidence.levels import Storey
from ichnograph.algorithms.site_plan.storeys.rooms.room_cells import Room
from ichnograph.algorithms.site_plan.storeys.storey_plan import StoreyPlan
from ichnograph.algorithms.site_plan.storeys.walls.left_out import CLOSE, LOW, LeftOut
from ichnograph.algorithms.site_plan.storeys.walls.walls import Wall
from ichnograph.tests.algorithms.site_plan.output.test_plan_report import plain
from shapely.geometry import LineString, box

HOUSE = box(412_302, 5_812_690, 412_306, 5_812_693)


def line(x, length):
    return LineString([(412_303, 5_812_691 + x), (412_303 + length, 5_812_691 + x)])


@pytest.fixture
def storey():
    wall = Wall(box(412_302, 5_812_689.8, 412_306, 5_812_690), "wall", 1, None, 70.0, 72.6, 0.9)
    left_out = LeftOut(line(0, 1), LOW, 1.2), LeftOut(line(1, 2), LOW, 2.4), LeftOut(line(0.5, 2), CLOSE, 5.0)
    room = Room(HOUSE, 70.0, 72.6, 0.98)
    heights = Storey(70.0, 72.6)
    return StoreyPlan((wall,), (room,), (line(0.2, 3),), left_out, (), HOUSE, heights, 0.02, 0.002)


def test_heights_points_and_limits_are_listed(storey):
    rows = dict(shown(storey).rows)
    assert (rows["floor"], rows["ceiling"]) == ("70.00 m", "72.60 m")
    assert (rows["distance of points"], rows["noise of upright surfaces"]) == ("2.0 cm", "2 mm")
    assert (rows["outlines of rooms"], rows["of them limits, without a wall"]) == ("14.0 m", "3.0 m")
    assert rows["pieces of the kind wall"] == "1"


def test_what_was_left_out_is_added_up_by_reason_the_largest_first(storey):
    assert shown(storey).left_out == [(CLOSE, "1", "2.0", "5.0"), (LOW, "2", "3.0", "3.6")]


def test_the_map_draws_limits_and_what_was_left_out(storey):
    assert LIMIT in shown(storey).map
    assert LEFT_OUT in shown(storey).map
    bare = shown(replace(storey, limits=(), left_out=())).map
    assert LIMIT not in bare
    assert LEFT_OUT not in bare


def test_the_page_says_what_decided(plan, storey):
    assert "No room under a ceiling was seen" in decided_by(plan)
    assert "REFINE is no" in decided_by(replace(plan, settings=SitePlanSettings(refine=False)))
    assert "STOREY is no" in decided_by(replace(plan, settings=SitePlanSettings(storey=False)))
    assert "Under the ceiling" in decided_by(replace(plan, storey=storey))


def test_the_page_shows_the_storey(plan, storey, tmp_path):
    write_report(tmp_path / "with.html", replace(plan, storey=storey, warnings=("Look at LEFT_OUT.",)))
    write_report(tmp_path / "without.html", plan)
    page, without = (
        plain((tmp_path / name).read_text(encoding="utf-8")) for name in ("with.html", "without.html")
    )
    assert "ceiling 72.60 m" in page
    assert "Look at LEFT_OUT." in page
    assert CLOSE in page
    assert "left out, because it" not in without
