"""The layers of a site plan: their fields, and what is null."""

from dataclasses import replace

import fiona
import numpy as np
import pytest
import rasterio
from ichnograph.algorithms.site_plan.axes.axes import find_axes
from ichnograph.algorithms.site_plan.output.layers import (
    AXIS_FIELDS,
    LEFT_OUT_FIELDS,
    ROOM_FIELDS,
    WALL_FIELDS,
    write_axes,
    write_left_out,
    write_limits,
    write_plan,
    write_rooms,
    write_walls,
)
from ichnograph.algorithms.site_plan.rooms.rooms import find_rooms
from ichnograph.algorithms.site_plan.storeys.evidence.levels import Storey
from ichnograph.algorithms.site_plan.storeys.storey_plan import StoreyPlan
from ichnograph.algorithms.site_plan.storeys.walls.left_out import LeftOut
from ichnograph.tests.algorithms.site_plan.house import UTM, plan_of_house
from shapely.geometry import LineString, Point, Polygon, box, shape

HOUSE = box(412_300, 5_812_300, 412_306.6, 5_812_304.6).difference(
    box(412_300.3, 5_812_300.3, 412_306.3, 5_812_304.3)
)
TOWER = Point(412_320, 5_812_300).buffer(3.0, 64).difference(Point(412_320, 5_812_300).buffer(2.5, 64))


def test_wall_pixels_are_ones_where_the_plan_has_them(tmp_path):
    plan = plan_of_house()
    write_plan(tmp_path / "plan.tif", plan)
    with rasterio.open(tmp_path / "plan.tif") as raster:
        assert (raster.transform, raster.crs) == (plan.transform, UTM)
        np.testing.assert_array_equal(raster.read(1), plan.image.walls)


@pytest.mark.parametrize("name", ["walls.shp", "walls.gpkg"])
def test_walls_are_polygons_with_null_for_what_is_unknown(tmp_path, name):
    plan = plan_of_house()
    write_walls(tmp_path / name, plan)
    write_walls(tmp_path / f"pixels_{name}", replace(plan, walls=plan.pixel_walls))
    with fiona.open(tmp_path / name) as layer, fiona.open(tmp_path / f"pixels_{name}") as pixels:
        assert list(layer.schema["properties"]) == list(WALL_FIELDS)
        assert layer.crs.to_epsg() == 25833
        rows = [feature["properties"] for feature in layer]
        before = [feature["properties"] for feature in pixels]
    assert [row["wall_id"] for row in rows] == [wall.wall_id for wall in plan.walls]
    assert rows[0]["thickness"] == pytest.approx(plan.walls[0].thickness, abs=1e-3)
    assert before[0]["thickness"] is None and before[0]["coverage"] is None


@pytest.mark.parametrize("name", ["axes.shp", "axes.gpkg"])
def test_axes_are_lines_with_azimuth_or_radius_and_null_for_the_other(tmp_path, name):
    write_axes(tmp_path / name, replace(plan_of_house(), axes=find_axes([(7, HOUSE), (9, TOWER)])))
    with fiona.open(tmp_path / name) as layer:
        assert list(layer.schema["properties"]) == list(AXIS_FIELDS)
        rows = [feature["properties"] for feature in layer]
    assert [row["wall_id"] for row in rows] == [7, 7, 7, 7, 9]
    assert [row["axis_id"] for row in rows] == [1, 2, 3, 4, 5]
    assert [row["radius"] is None for row in rows] == [True, True, True, True, False]
    assert [row["azimuth"] is None for row in rows] == [False, False, False, False, True]
    assert rows[4]["radius"] == pytest.approx(2.75, abs=0.01)
    assert rows[0]["thickness"] == pytest.approx(0.3, abs=0.001)


@pytest.mark.parametrize("name", ["rooms.shp", "rooms.gpkg"])
def test_rooms_are_polygons_with_their_floor_or_null(tmp_path, name):
    house, tower = find_rooms([HOUSE, TOWER])
    rooms = (replace(house, z_floor=71.3), tower)
    write_rooms(tmp_path / name, replace(plan_of_house(), rooms=rooms))
    with fiona.open(tmp_path / name) as layer:
        assert list(layer.schema["properties"]) == list(ROOM_FIELDS)
        house, tower = (feature["properties"] for feature in layer)
        outline = shape(layer[1 if name.endswith("gpkg") else 0]["geometry"])
    assert (house["area"], house["perimeter"], house["openings"]) == (24.0, 20.0, 0)
    assert house["z_floor"] == pytest.approx(71.3, abs=0.001)
    assert tower["z_floor"] is None
    assert outline.area == pytest.approx(24.0, abs=1e-3)


@pytest.mark.parametrize("rooms", [(), None])
def test_without_rooms_the_layer_is_empty(tmp_path, rooms):
    write_rooms(tmp_path / "rooms.shp", replace(plan_of_house(), rooms=rooms))
    with fiona.open(tmp_path / "rooms.shp") as layer:
        assert len(layer) == 0


def with_storey(limits, left_out):
    storey = StoreyPlan(
        (), (), tuple(limits), tuple(left_out), (), Polygon(), Storey(70.0, 72.5), 0.02, 0.002
    )
    return replace(plan_of_house(), storey=storey)


@pytest.mark.parametrize("ending", ["shp", "gpkg"])
def test_limits_and_what_was_left_out_are_lines(tmp_path, ending):
    limit = LineString([(412_300, 5_812_300), (412_303, 5_812_304)])
    board = LineString([(412_301, 5_812_301), (412_302, 5_812_301)])
    plan = with_storey([limit], [LeftOut(board, "stands free in a room", 2.0)])
    write_limits(tmp_path / f"limits.{ending}", plan)
    write_left_out(tmp_path / f"left_out.{ending}", plan)
    with fiona.open(tmp_path / f"limits.{ending}") as layer:
        (feature,) = layer
        assert layer.crs.to_epsg() == 25833
        assert feature["properties"]["length"] == pytest.approx(5.0)
        assert shape(feature["geometry"]).equals(limit)
    with fiona.open(tmp_path / f"left_out.{ending}") as layer:
        (feature,) = layer
        assert list(layer.schema["properties"]) == list(LEFT_OUT_FIELDS)
        assert dict(feature["properties"]) == {
            "reason": "stands free in a room",
            "length": 1.0,
            "area": 2.0,
        }
        assert shape(feature["geometry"]).equals(board)


def test_every_reason_fits_into_its_field(tmp_path):
    long = "x" * 80
    write_left_out(tmp_path / "out.shp", with_storey([], [LeftOut(LineString([(0, 0), (1, 0)]), long, 2.0)]))
    with fiona.open(tmp_path / "out.shp") as layer:
        assert [feature["properties"]["reason"] for feature in layer] == [long]


@pytest.mark.parametrize("write", [write_limits, write_left_out])
def test_without_a_storey_the_layer_is_empty(tmp_path, write):
    write(tmp_path / "empty.gpkg", plan_of_house())
    with fiona.open(tmp_path / "empty.gpkg") as layer:
        assert len(layer) == 0
        assert layer.schema["geometry"] == "LineString"
