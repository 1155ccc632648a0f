"""The layers of axes and rooms, and the floors of rooms."""

import fiona
import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.site_plan.axes.axes import find_axes
from ichnograph.algorithms.site_plan.output.room_layers import (
    AXIS_FIELDS,
    ROOM_FIELDS,
    write_axes,
    write_rooms,
)
from ichnograph.algorithms.site_plan.rooms.rooms import find_rooms, with_floors
from rasterio.crs import CRS
from shapely.geometry import Point, box, shape

UTM = CRS.from_epsg(25833)
HOUSE = box(412_300, 5_812_300, 412_306.6, 5_812_304.6).difference(
    box(412_300.3, 5_812_300.3, 412_306.3, 5_812_304.3)
)
TOWER = Point(412_320, 5_812_300).buffer(3.0, 64).difference(Point(412_320, 5_812_300).buffer(2.5, 64))


@pytest.mark.parametrize("name", ["axes.shp", "axes.gpkg"])
def test_axes_are_lines_with_azimuth_or_radius_and_null_for_the_other(tmp_path, name):
    write_axes(tmp_path / name, find_axes([(7, HOUSE), (9, TOWER)]), UTM)
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
    rooms = find_rooms([HOUSE, TOWER])
    ground = np.full((60, 80), 71.3)
    covered = Affine(0.1, 0, 412_299.0, 0, -0.1, 5_812_305.0)
    write_rooms(tmp_path / name, with_floors(rooms, ground, covered), UTM)
    with fiona.open(tmp_path / name) as layer:
        assert list(layer.schema["properties"]) == list(ROOM_FIELDS)
        house, tower = (feature["properties"] for feature in layer)
        outline = shape(layer[1 if name.endswith("gpkg") else 0]["geometry"])
    assert (house["area"], house["perimeter"], house["openings"]) == (24.0, 20.0, 0)
    assert house["z_floor"] == pytest.approx(71.3, abs=0.001)
    assert tower["z_floor"] is None
    assert outline.area == pytest.approx(24.0, abs=1e-3)


def test_without_rooms_the_layer_is_empty(tmp_path):
    write_rooms(tmp_path / "rooms.shp", with_floors((), np.zeros((2, 2)), Affine.identity()), UTM)
    with fiona.open(tmp_path / "rooms.shp") as layer:
        assert len(layer) == 0
