"""What is written of an elevation, with the way back to the site."""

import csv

import fiona
import numpy as np
import pytest
import rasterio
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.facade.elevation import Frame, Points
from ichnograph.algorithms.facade.output.drawing import write_drawing
from ichnograph.algorithms.facade.output.elevation_layers import FIELDS, write_details, write_elevation
from ichnograph.algorithms.facade.output.orthoimage import automatic_pixel_size, write_orthoimage
from ichnograph.algorithms.facade.output.schedule import write_schedule
from ichnograph.tests.algorithms.facade.samples import lattice, small_elevation
from rasterio.crs import CRS
from shapely.geometry import shape

TENTH = 1e-5
"""A hundredth of a millimetre (m)."""


def site_of(row, uv):
    """Return x, y, z of places in u, v by the formula of the manual."""
    a, t = np.radians(float(row["azimuth"])), np.radians(float(row["tilt"]))
    u, v = np.asarray(uv, float).T
    return np.column_stack([
        float(row["x0"]) - u * np.cos(a) - v * np.sin(a) * np.sin(t),
        float(row["y0"]) + u * np.sin(a) - v * np.cos(a) * np.sin(t),
        float(row["z0"]) + v * np.cos(t),
    ])  # fmt: skip


def features(path):
    with fiona.open(str(path)) as layer:
        return [(shape(item["geometry"]), dict(item["properties"])) for item in layer], layer.crs_wkt


@pytest.mark.parametrize("name", ["elevation.shp", "elevation.gpkg"])
def test_the_elevation_has_wall_unseen_place_and_details_in_metres(tmp_path, name):
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
    assert detail["h_std"] == pytest.approx(np.hypot(0.002, 0.003), abs=1e-5) or detail["h_std"] is None
    assert set(FIELDS) == set(detail)


def test_the_elevation_is_nowhere_on_earth_and_the_details_in_the_site(tmp_path):
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
        np.testing.assert_allclose(found, sorted(raised.coords[:-1]), atol=TENTH, rtol=0)
        assert row["id"] == same["id"] and row["area"] == same["area"]


@given(
    azimuth=st.floats(0, 360),
    tilt=st.floats(-40, 40),
    uvw=st.tuples(*[st.floats(-50, 50)] * 3),
)
def test_a_frame_turns_back_and_forth(azimuth, tilt, uvw):
    frame = Frame(np.array([412345.678, 5812345.789, 71.234]), azimuth, tilt)
    place = frame.world(np.array([uvw]))

    np.testing.assert_allclose(frame.axes @ frame.axes.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(frame.local(place - frame.origin, frame.origin)[0], uvw, atol=1e-8)
    np.testing.assert_allclose(
        site_of({"x0": frame.origin[0], "y0": frame.origin[1], "z0": frame.origin[2],
                 "azimuth": azimuth, "tilt": tilt}, [uvw[:2]])[0],
        frame.world(np.array([(*uvw[:2], 0.0)]))[0], atol=1e-8,
    )  # fmt: skip


def test_u_is_right_v_is_up_and_w_towards_the_viewer():
    from_south = Frame(np.zeros(3), 180.0, 0.0)
    np.testing.assert_allclose(from_south.axes, [[1, 0, 0], [0, 0, 1], [0, -1, 0]], atol=1e-12)


def test_the_schedule_has_a_row_for_each_detail(tmp_path):
    write_schedule(tmp_path / "schedule.csv", small_elevation())
    with (tmp_path / "schedule.csv").open(newline="") as stream:
        (row,) = csv.DictReader(stream)

    assert (row["id"], row["kind"], row["width"], row["height"]) == ("1", "opening", "1.0", "1.5")
    assert row["width_std"] != "" or row["height_std"] != ""
    middle = site_of(row, [(float(row["u"]), float(row["v"]))])
    np.testing.assert_allclose(middle, small_elevation().frame.world([[1.5, 1.75, 0]]), atol=TENTH, rtol=0)


def test_the_drawing_is_true_to_scale_with_a_layer_for_each_kind(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    write_drawing(tmp_path / "drawing.dxf", small_elevation())
    document = ezdxf.readfile(tmp_path / "drawing.dxf")
    outlines = {
        line.dxf.layer: np.array(line.get_points("xy")) for line in document.modelspace().query("LWPOLYLINE")
    }

    assert not document.audit().errors
    assert document.header["$INSUNITS"] == 6
    assert set(outlines) == {"WALL", "UNSEEN", "OPENING", "RAW"}
    np.testing.assert_allclose(np.ptp(outlines["OPENING"], axis=0), (1.0, 1.5))
    (text,) = document.modelspace().query("TEXT")
    assert (text.dxf.text, text.dxf.layer) == ("1", "TEXT")


def test_the_drawing_knows_its_place_in_the_site(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    write_drawing(tmp_path / "drawing.dxf", small_elevation())
    frame, place = small_elevation().frame, ezdxf.readfile(tmp_path / "drawing.dxf").ucs.get("FACADE")

    np.testing.assert_allclose(place.dxf.origin.xyz, frame.origin, atol=TENTH, rtol=0)
    np.testing.assert_allclose(place.dxf.xaxis.xyz, frame.axes[0], atol=1e-9)
    np.testing.assert_allclose(place.dxf.yaxis.xyz, frame.axes[1], atol=1e-9)


@pytest.mark.parametrize("write", [write_elevation, write_schedule, write_drawing])
def test_the_same_elevation_gives_the_same_bytes(tmp_path, write):
    if write is write_drawing:
        pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    suffix = {write_elevation: "shp", write_schedule: "csv", write_drawing: "dxf"}[write]
    for name in "ab":
        write(tmp_path / f"{name}.{suffix}", small_elevation())
    assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()


@pytest.mark.parametrize(("spacing", "size"), [
    (0.0023, 0.005), (0.005, 0.005), (0.0051, 0.01), (0.012, 0.02), (0.02, 0.02), (0.3, 0.5),
])  # fmt: skip
def test_the_pixel_size_is_not_less_than_the_spacing(spacing, size):
    assert automatic_pixel_size(spacing) == pytest.approx(size)


def painted(colour=True, step=0.01):
    """Points of the small wall, red to the left and blue to the right, in its own frame."""
    uv = lattice(0, 0, 4, 3, step)
    uv = uv[~((uv > (1, 1)) & (uv < (2, 2.5))).all(axis=1)]
    frame = small_elevation().frame
    xyz = frame.world(np.column_stack([uv, np.zeros(len(uv))])) - frame.origin
    rgb = np.where(uv[:, :1] < 2.5, (200.0, 10.0, 10.0), (10.0, 10.0, 200.0)).astype(np.float32)
    intensity = np.where(uv[:, 0] < 2.5, 1000, 5000).astype(np.float32)
    return Points(xyz, frame.origin, rgb if colour else None, intensity, np.zeros(len(uv), np.int32))


def elevation_of(points):
    from dataclasses import replace

    return replace(small_elevation(), rows=np.arange(len(points.xyz)))


def image(path):
    with rasterio.open(path) as raster:
        return raster.read(), raster.transform, raster.descriptions, raster.tags()


def test_the_orthoimage_lies_where_the_elevation_lies(tmp_path):
    points = painted()
    write_orthoimage(tmp_path / "o.tif", points, elevation_of(points), 0.02, fill=False)
    bands, transform, names, tags = image(tmp_path / "o.tif")

    assert names == ("red", "green", "blue", "alpha")
    assert (transform.c, transform.f, transform.a, transform.e) == pytest.approx((0, 3, 0.02, -0.02))
    left, right = bands[:3, 10, 50], bands[:3, 10, 150]
    assert tuple(left) == (200, 10, 10) and tuple(right) == (10, 10, 200)
    assert float(tags["azimuth"]) == pytest.approx(213.4)


def test_holes_of_the_orthoimage_are_filled_only_where_asked(tmp_path):
    points = painted()
    for fill in (False, True):
        write_orthoimage(tmp_path / f"{fill}.tif", points, elevation_of(points), 0.02, fill)
    hole = (slice(40, 90), slice(60, 90))

    assert (image(tmp_path / "False.tif")[0][3][hole] == 0).all()
    assert (image(tmp_path / "True.tif")[0][3][hole] == 255).all()


def test_without_colour_the_orthoimage_is_grey(tmp_path):
    points = painted(colour=False)
    write_orthoimage(tmp_path / "o.tif", points, elevation_of(points), 0.02, fill=False)
    bands, _, names, _ = image(tmp_path / "o.tif")

    assert names == ("intensity", "alpha")
    assert bands[0, 10, 50] < bands[0, 10, 150]
