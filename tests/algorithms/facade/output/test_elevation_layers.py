"""The layers of an elevation, and the way back from u, v to the site."""

from dataclasses import replace

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.facade.development.curves import Circle
from ichnograph.algorithms.facade.elevation import COLOURED, Frame, LeftOut
from ichnograph.algorithms.facade.output.elevation_layers import (
    FIELDS,
    LEFT_OUT_FIELDS,
    write_details,
    write_elevation,
    write_left_out,
)
from ichnograph.tests.algorithms.facade.samples import site_of, small_elevation
from rasterio.crs import CRS
from shapely.geometry import box, shape

TOLERANCE = 1e-5
"""A hundredth of a millimetre (m)."""


def features(path):
    with fiona.open(str(path)) as layer:
        return [(shape(item["geometry"]), dict(item["properties"])) for item in layer], layer.crs_wkt


@pytest.mark.parametrize("name", ["elevation.shp", "elevation.gpkg"])
def test_the_elevation_has_wall_unseen_area_and_details_in_metres(tmp_path, name):
    write_elevation(tmp_path / name, small_elevation())
    rows, _ = features(tmp_path / name)

    assert [row["kind"] for _, row in rows] == ["wall", "unseen", "opening"]
    assert [row["id"] for _, row in rows] == [None, None, 1]
    assert [round(polygon.area, 6) for polygon, _ in rows] == [10.5, 0.5, 1.5]
    detail = rows[2][1]
    assert (detail["width"], detail["height"], detail["sill"], detail["area"]) == (1.0, 1.5, 1.0, 1.5)
    assert (detail["red"], detail["green"], detail["blue"]) == (10, 21, 30)


def test_what_was_not_seen_has_no_deviation(tmp_path):
    write_elevation(tmp_path / "elevation.shp", small_elevation())
    detail = features(tmp_path / "elevation.shp")[0][2][1]

    assert detail["std_right"] is None and detail["w_std"] is None
    assert detail["h_std"] == pytest.approx(np.hypot(0.002, 0.003), abs=1e-5)
    assert set(FIELDS) == set(detail)


def test_the_elevation_has_a_local_system_and_the_details_that_of_the_site(tmp_path):
    write_elevation(tmp_path / "elevation.shp", small_elevation())
    write_details(tmp_path / "details.shp", small_elevation(), CRS.from_epsg(25833))

    assert features(tmp_path / "elevation.shp")[1].startswith("LOCAL_CS")
    assert CRS.from_wkt(features(tmp_path / "details.shp")[1]) == CRS.from_epsg(25833)


@pytest.mark.parametrize("name", ["elevation.shp", "elevation.gpkg"])
def test_u_and_v_go_back_to_the_site_within_a_hundredth_of_a_millimetre(tmp_path, name):
    elevation = small_elevation()
    write_elevation(tmp_path / name, elevation)
    write_details(tmp_path / f"details{name[9:]}", elevation, None)
    flat, _ = features(tmp_path / name)
    space, _ = features(tmp_path / f"details{name[9:]}")

    for (polygon, row), (lifted, same) in zip(flat, space):
        outer = getattr(polygon, "geoms", [polygon])[0].exterior
        raised = getattr(lifted, "geoms", [lifted])[0].exterior
        # A shapefile turns rings to its own direction.
        found = np.array(sorted(map(tuple, site_of(row, np.array(outer.coords)[:-1]))))
        np.testing.assert_allclose(found, sorted(raised.coords[:-1]), atol=TOLERANCE, rtol=0)
        assert row["id"] == same["id"] and row["area"] == same["area"]


def test_the_same_elevation_gives_the_same_bytes(tmp_path):
    for name in "ab":
        write_elevation(tmp_path / f"{name}.shp", small_elevation())
    assert (tmp_path / "a.shp").read_bytes() == (tmp_path / "b.shp").read_bytes()


def test_what_is_left_out_has_reason_and_area(tmp_path):
    stain = LeftOut(box(2, 1, 3, 2), COLOURED, "no straight sides", 1.0)
    write_left_out(tmp_path / "left_out.gpkg", replace(small_elevation(), left_out=(stain,)))
    (((polygon, row),), _) = features(tmp_path / "left_out.gpkg")

    assert set(row) == set(LEFT_OUT_FIELDS)
    assert (row["kind"], row["reason"], row["area"]) == (COLOURED, "no straight sides", 1.0)
    assert polygon.bounds == (2, 1, 3, 2)


def test_details_of_a_round_tower_lie_on_its_wall_and_their_radius_is_a_field(tmp_path):
    frame = Frame(np.array([3.0, 4.0, 0.0]), 180.0, 0.0)
    tower = Circle(np.array([3.0, 6.0]), 2.0, 180.0)
    write_details(tmp_path / "details.gpkg", replace(small_elevation(frame), curve=tower), None)
    rows, _ = features(tmp_path / "details.gpkg")
    corners = np.array(
        [corner for polygon, _ in rows for part in polygon.geoms for corner in part.exterior.coords]
    )

    np.testing.assert_allclose(np.hypot(*(corners[:, :2] - (3, 6)).T), 2.0, atol=TOLERANCE)
    assert {row["radius"] for _, row in rows} == {2.0}
    assert len(corners) > 4 * len(rows) + 40
