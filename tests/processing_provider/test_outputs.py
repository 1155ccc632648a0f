"""What the algorithms write, run as scripts run them."""

import fiona
import laspy
import numpy as np
import pytest
import rasterio
from ichnograph.algorithms.site_plan.density.density_raster import BANDS
from ichnograph.algorithms.site_plan.output.layers import WALL_FIELDS
from ichnograph.tests.processing_provider.room import CORNER, room_points, write_las
from rasterio.crs import CRS

EPSG = 25833


@pytest.fixture(scope="module")
def density(run, room, tmp_path_factory):
    path = str(tmp_path_factory.mktemp("density") / "density.tif")
    return run("densityimage", INPUT=[room], DENSITY=path)


def test_thincloud_keeps_points_and_their_attributes(run, room, tmp_path):
    result = run("thincloud", INPUT=[room], SPACING=0.2, OUTPUT=str(tmp_path / "thin.las"))

    thinned = laspy.read(result["OUTPUT"])
    assert result["POINTS_IN"] == len(room_points())
    assert 0 < result["POINTS_OUT"] == len(thinned) < result["POINTS_IN"] / 4
    assert len(np.unique(thinned.intensity)) > 1
    assert thinned.header.global_encoding.wkt


def test_densityimage_writes_named_bands_with_a_reference_system(density, room):
    assert density["POINTS_IN"] == len(room_points())
    assert 0 < density["POINTS_KEPT"] < density["POINTS_IN"]
    with rasterio.open(density["DENSITY"]) as raster:
        assert raster.descriptions == BANDS
        assert raster.crs.to_epsg() == EPSG
        assert raster.nodata is not None
        assert raster.res == (0.1, 0.1)
        values = raster.read(1, masked=True)
    assert values.sum() == pytest.approx(density["POINTS_KEPT"], rel=1e-4)


def test_densityimage_takes_the_chosen_reference_system_if_the_cloud_has_none(run, tmp_path):
    write_las(tmp_path / "bare.las", room_points())
    result = run(
        "densityimage",
        INPUT=[str(tmp_path / "bare.las")],
        CRS="EPSG:25832",
        DENSITY=str(tmp_path / "density.tif"),
    )

    with rasterio.open(result["DENSITY"]) as raster:
        assert raster.crs.to_epsg() == 25832


@pytest.mark.parametrize("name", ["walls.shp", "walls.gpkg"])
def test_extractwalls_finds_the_walls_of_the_room(run, density, tmp_path, name):
    result = run(
        "extractwalls",
        INPUT=density["DENSITY"],
        PLAN=str(tmp_path / "plan.tif"),
        WALLS=str(tmp_path / name),
    )

    assert result["WALL_COUNT"] == 1
    assert result["WALL_LENGTH"] == pytest.approx(2 * (6 + 4), rel=0.05)
    assert_is_the_room(result["WALLS"], result["WALL_AREA"])
    with rasterio.open(result["PLAN"]) as raster:
        assert raster.crs.to_epsg() == EPSG
        plan = raster.read(1)
    assert set(np.unique(plan)) == {0, 1}
    assert plan.sum() * 0.1**2 == pytest.approx(result["WALL_AREA"], rel=1e-3)


def test_extractwalls_reads_a_loaded_layer(run, density, tmp_path):
    from qgis.core import QgsProject, QgsRasterLayer

    layer = QgsRasterLayer(density["DENSITY"], "my density")
    QgsProject.instance().addMapLayer(layer)
    outputs = {"PLAN": str(tmp_path / "plan.tif"), "WALLS": str(tmp_path / "walls.gpkg")}

    for given in (layer, layer.id(), "my density"):
        assert run("extractwalls", INPUT=given, **outputs)["WALL_COUNT"] == 1


def test_siteplan_is_the_chain_of_the_others(run, room, density, tmp_path, feedback):
    paths = {"DENSITY": "density.tif", "PLAN": "plan.tif", "WALLS": "walls.shp"}
    paths = {name: str(tmp_path / file) for name, file in paths.items()}
    result = run("siteplan", feedback, INPUT=[room], **paths)

    assert {name: result[name] for name in paths} == paths
    assert {name: result[name] for name in ("POINTS_IN", "POINTS_KEPT")} == {
        name: density[name] for name in ("POINTS_IN", "POINTS_KEPT")
    }
    assert result["WALL_COUNT"] == 1
    assert_is_the_room(result["WALLS"], result["WALL_AREA"])
    with rasterio.open(result["DENSITY"]) as one, rasterio.open(density["DENSITY"]) as other:
        assert np.array_equal(one.read(), other.read())


@pytest.mark.parametrize(("heights", "low", "high"), [(0, 70.5, 71.0), (1, 0.5, 1.0)])
def test_densityimage_leaves_out_what_is_lower_or_higher(run, room, tmp_path, heights, low, high):
    path = str(tmp_path / "density.tif")
    run("densityimage", INPUT=room, ZMIN=low, ZMAX=high, HEIGHTS=heights, DENSITY=path)

    with rasterio.open(path) as raster:
        base, top = (raster.read(BANDS.index(name) + 1, masked=True) for name in ("base", "top"))
    assert base.min() == pytest.approx(70.5, abs=0.05)
    assert top.max() == pytest.approx(71.0, abs=0.05)


def test_siteplan_puts_the_outlines_on_the_faces(run, room, tmp_path, feedback):
    path = run("siteplan", feedback, INPUT=[room], WALLS=str(tmp_path / "walls.gpkg"))["WALLS"]

    (wall,) = read(path)
    low, high = CORNER[:2] + 1, CORNER[:2] + (7, 5)
    outer, inner = (np.array(ring) for ring in wall["geometry"]["coordinates"])
    # The faces have no thickness: the outline goes from the seen side to just behind.
    assert np.abs(outer.min(axis=0) - low).max() < 0.02 and np.abs(outer.max(axis=0) - high).max() < 0.02
    assert np.abs(inner.min(axis=0) - low).max() < 0.02 and np.abs(inner.max(axis=0) - high).max() < 0.02
    fields = wall["properties"]
    assert fields["thickness"] is None and fields["radius"] is None
    assert 0.4 < fields["coverage"] <= 1
    assert 0 <= fields["rms"] < 0.001
    assert any("of their length has points on it" in info for info in feedback.infos)


def test_siteplan_without_refine_gives_the_outlines_of_extractwalls(run, room, density, tmp_path):
    outputs = {"PLAN": str(tmp_path / "plan.tif"), "WALLS": str(tmp_path / "plain.gpkg")}
    plain = run("extractwalls", INPUT=density["DENSITY"], **outputs)
    chain = run("siteplan", INPUT=[room], REFINE=False, WALLS=str(tmp_path / "chain.gpkg"))

    (one,), (other,) = read(plain["WALLS"]), read(chain["WALLS"])
    assert one["geometry"]["coordinates"] == other["geometry"]["coordinates"]
    assert dict(one["properties"]) == dict(other["properties"])
    assert {name: plain[name] for name in ("WALL_AREA", "WALL_LENGTH")} == {
        name: chain[name] for name in ("WALL_AREA", "WALL_LENGTH")
    }


def test_siteplan_reports_progress_and_derived_values(run, room, tmp_path, feedback):
    run("siteplan", feedback, INPUT=[room], WALLS=str(tmp_path / "walls.shp"))

    text = "\n".join(feedback.infos)
    for part in ("Points: ", "Thresholds: 10 from ", "0.1 m²", "gap to close: 0.8 m", "Walls: 1"):
        assert part in text
    assert feedback.fractions == sorted(feedback.fractions)
    assert feedback.fractions[-1] > 90
    assert len(feedback.steps) == len(set(feedback.steps)) > 3


def test_siteplan_writes_only_what_is_asked_for(run, room, tmp_path):
    result = run("siteplan", INPUT=[room], DENSITY=None, PLAN=None, WALLS=str(tmp_path / "walls.gpkg"))

    assert "DENSITY" not in result
    assert {file.name for file in tmp_path.iterdir()} == {"walls.gpkg", "walls.qml"}


def test_temporary_outputs_are_files_too(run, room):
    result = run("siteplan", INPUT=[room], DENSITY="TEMPORARY_OUTPUT", WALLS="TEMPORARY_OUTPUT")

    assert result["DENSITY"].endswith(".tif")
    assert result["WALLS"].endswith(".gpkg")
    assert_is_the_room(result["WALLS"], result["WALL_AREA"])


def test_a_parameter_that_does_not_exist_is_reported(run, room, tmp_path, feedback):
    run("thincloud", feedback, INPUT=[room], SPACNIG=0.2, OUTPUT=str(tmp_path / "thin.laz"))

    assert "Thin laser scans (thincloud) has no parameter SPACNIG; it is ignored." in feedback.warnings


def read(path):
    with fiona.open(path) as layer:
        return list(layer)


def assert_is_the_room(path, area):
    with fiona.open(path) as layer:
        assert CRS.from_wkt(layer.crs_wkt).to_epsg() == EPSG
        assert list(layer.schema["properties"]) == list(WALL_FIELDS)
        walls = list(layer)
    assert len(walls) == 1
    fields = walls[0]["properties"]
    assert fields["z_base"] == pytest.approx(CORNER[2], abs=0.1)
    assert fields["z_top"] == pytest.approx(CORNER[2] + 2.5, abs=0.1)
    assert fields["thickness"] is None
    outer, inner = (np.array(ring) for ring in walls[0]["geometry"]["coordinates"])
    low, high = CORNER[:2] + 1, CORNER[:2] + (7, 5)
    assert np.abs(outer.min(axis=0) - low).max() <= 0.2 and np.abs(outer.max(axis=0) - high).max() <= 0.2
    assert np.abs(inner.min(axis=0) - low).max() <= 0.2 and np.abs(inner.max(axis=0) - high).max() <= 0.2
    assert 0 < area < 20 * 0.4
