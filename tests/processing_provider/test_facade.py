"""Facades, run as scripts and models run them."""

import csv
import time

import fiona
import laspy
import numpy as np
import pytest
import rasterio
from ichnograph.algorithms.vector import write_vector
from ichnograph.tests.algorithms.facade.buildings.sites import block, upright
from ichnograph.tests.algorithms.facade.development.towers import ground, round_wall
from ichnograph.tests.scenes.facades import FACADES
from ichnograph.tests.scenes.facades.__main__ import write_laz, write_truth
from shapely.geometry import LineString, box

PLACE = (12.0, (412345.6, 5812345.7, 71.3))
FILES = {
    "ELEVATION": "elevation.shp",
    "DETAILS": "details.gpkg",
    "ORTHOIMAGE": "orthoimage.tif",
    "SCHEDULE": "schedule.csv",
    "DRAWING": "drawing.dxf",
}


@pytest.fixture(scope="module")
def scene():
    return FACADES["storehouse"](0).moved(*PLACE)


@pytest.fixture(scope="module")
def facade(scene, tmp_path_factory):
    """Write a scan of a storehouse, in UTM coordinates."""
    path = tmp_path_factory.mktemp("clouds") / "storehouse.laz"
    write_laz(path, scene.scan(0.025), "EPSG:25833")
    return str(path)


@pytest.fixture(scope="module")
def written(run, facade, tmp_path_factory):
    """Run facadedetails with all outputs."""
    folder = tmp_path_factory.mktemp("out")
    paths = {name: str(folder / file) for name, file in FILES.items()}
    if not _has_ezdxf():
        del paths["DRAWING"]
    return run("facadedetails", INPUT=facade, **paths)


def _has_ezdxf():
    try:
        import ezdxf  # noqa: F401
    except ImportError:
        return False
    return True


def rows(path):
    with fiona.open(path) as layer:
        return [dict(item["properties"]) for item in layer]


def schedule(path):
    with open(path, newline="") as stream:  # noqa: PTH123
        return list(csv.DictReader(stream))


def test_every_output_has_the_same_details(written, scene):
    ids = {row["id"]: row["area"] for row in rows(written["ELEVATION"]) if row["id"]}

    assert written["DETAIL_COUNT"] == len(scene.details) == len(ids)
    in_space = {row["id"]: row["area"] for row in rows(written["DETAILS"]) if row["id"]}
    assert in_space == pytest.approx(ids, abs=1e-5)
    assert {int(row["id"]): float(row["area"]) for row in schedule(written["SCHEDULE"])} == pytest.approx(
        ids, abs=1e-5
    )


def test_the_schedule_has_what_was_built(written, scene):
    kinds = sorted(row["kind"] for row in schedule(written["SCHEDULE"]))
    assert kinds == sorted(detail.kind for detail in scene.details)
    assert written["WALL_AREA"] == pytest.approx(scene.wall.area, rel=0.02)


def test_the_layers_open_in_qgis_upright_and_in_the_site(written):
    from qgis.core import QgsCoordinateReferenceSystem, QgsVectorLayer

    elevation = QgsVectorLayer(written["ELEVATION"], "elevation")
    details = QgsVectorLayer(written["DETAILS"], "details")
    box = elevation.extent()

    assert elevation.isValid() and details.isValid()
    assert (round(box.width(), 1), round(box.height(), 1)) == (7.5, 5.2)
    assert not elevation.crs().isGeographic()
    assert details.crs() == QgsCoordinateReferenceSystem("EPSG:25833")
    assert details.renderer().classAttribute() == elevation.renderer().classAttribute() == "kind"


def test_the_orthoimage_covers_the_elevation(written):
    with rasterio.open(written["ORTHOIMAGE"]) as raster:
        assert raster.count == 4
        left, bottom, right, top = raster.bounds
        assert (raster.read(4) > 0).mean() > 0.7
    assert right - left == pytest.approx(7.5, abs=0.2) and top - bottom == pytest.approx(5.2, abs=0.2)


def test_the_same_input_gives_the_same_bytes(run, facade, written, tmp_path):
    again = run("facadedetails", INPUT=facade, **{name: str(tmp_path / file) for name, file in FILES.items()})
    for name in FILES:
        first, second = (open(result[name], "rb").read() for result in (written, again))  # noqa: PTH123, SIM115
        assert first == second, name


def test_details_are_compared_with_a_tape(run, written, scene, tmp_path):
    write_truth(tmp_path / "truth.csv", scene)
    true = schedule(tmp_path / "truth.csv")
    with (tmp_path / "tape.csv").open("w") as stream:
        stream.write("id,width,height\n")
        for row in schedule(written["SCHEDULE"]):
            size = [float(row["width"]), float(row["height"])]
            same = [item for item in true if item["kind"] == row["kind"]]
            nearest = min(same, key=lambda item: np.abs(
                np.array([item["width"], item["height"]], float) - size).sum())  # fmt: skip
            stream.write(f"{row['id']},{nearest['width']},{nearest['height']}\n")
    result = run(
        "comparelengths", SCHEDULE=written["SCHEDULE"], REFERENCE=str(tmp_path / "tape.csv"),
        TABLE=str(tmp_path / "table.csv"), REPORT=str(tmp_path / "report.html"),
    )  # fmt: skip

    assert result["COUNT"] == 2 * len(scene.details)
    assert abs(result["MEAN_DIFFERENCE"]) < 0.006
    assert result["MAX_DIFFERENCE"] < 0.04
    assert "Automatic and manual lengths" in (tmp_path / "report.html").read_text()


def test_derived_values_are_in_the_log(run, facade, tmp_path, feedback):
    run("facadedetails", feedback, INPUT=facade, ELEVATION=str(tmp_path / "elevation.shp"))
    log = "\n".join([*feedback.infos, *feedback.steps])

    for word in ("alpha", "SEED_VARIANCE", "Intensities that differ", "mm apart"):
        assert word in log
    assert feedback.warnings == []


def test_a_scan_without_colour_says_so(run, facade, tmp_path, feedback):
    cloud = laspy.read(facade)
    bare = laspy.LasData(laspy.LasHeader(point_format=0, version="1.2"))
    bare.header.scales, bare.header.offsets = cloud.header.scales, cloud.header.offsets
    bare.x, bare.y, bare.z, bare.intensity = cloud.x, cloud.y, cloud.z, cloud.intensity
    bare.write(str(tmp_path / "bare.laz"))
    names = ("ELEVATION", "SCHEDULE", "ORTHOIMAGE")
    files = {name: str(tmp_path / FILES[name]) for name in names}
    result = run("facadedetails", feedback, INPUT=str(tmp_path / "bare.laz"), **files)

    assert any("no colour" in warning for warning in feedback.warnings)
    assert {row["kind"] for row in schedule(result["SCHEDULE"])} == {"opening", "recess", "projection"}
    with rasterio.open(result["ORTHOIMAGE"]) as raster:
        assert raster.descriptions == ("intensity", "alpha")


def test_a_drawing_without_its_package_is_refused_before_anything_is_computed(
    run, facade, tmp_path, monkeypatch, feedback
):
    import sys

    from qgis.core import QgsProcessingException

    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(QgsProcessingException, match=r"DRAWING. cannot be written.*ezdxf"):
        run(
            "facadedetails", feedback, INPUT=facade, ELEVATION=str(tmp_path / "elevation.shp"),
            DRAWING=str(tmp_path / "drawing.dxf"),
        )  # fmt: skip
    assert list(tmp_path.iterdir()) == []
    assert not any("Triangulating" in step for step in feedback.steps)


@pytest.fixture(scope="module")
def planes(run, facade, tmp_path_factory):
    folder = tmp_path_factory.mktemp("planes")
    return run(
        "facadeplanes", INPUT=facade, PLANES=str(folder / "planes.shp"), SEGMENTS=str(folder / "segments.laz")
    )


def test_planes_stand_in_the_site(planes, scene):
    found = rows(planes["PLANES"])

    assert planes["PLANE_COUNT"] == len(found) == 3
    assert [row["plane"] for row in found] == [1, 2, 3]
    main = found[0]
    assert main["azimuth"] == pytest.approx(scene.frame.azimuth, abs=0.01)
    assert main["tilt"] == pytest.approx(0, abs=0.02)
    place = scene.frame.world([[1.0, 1.0, 0.0]])[0]
    assert main["nx"] * place[0] + main["ny"] * place[1] + main["nz"] * place[2] + main[
        "distance"
    ] == pytest.approx(0, abs=0.003)


def test_the_outlines_of_planes_are_upright_polygons_in_space(planes):
    from shapely.geometry import shape

    with fiona.open(planes["PLANES"]) as layer:
        for item in layer:
            corners = np.array(
                getattr(shape(item["geometry"]), "geoms", [shape(item["geometry"])])[0].exterior.coords
            )
            row = item["properties"]
            off = corners @ (row["nx"], row["ny"], row["nz"]) + row["distance"]
            assert np.abs(off).max() < 0.0001


def test_the_points_of_the_planes_keep_what_they_have(planes, facade):
    before, after = laspy.read(facade), laspy.read(planes["SEGMENTS"])
    counts = np.bincount(after["plane"])

    assert [row["points"] for row in rows(planes["PLANES"])] == counts[1:].tolist()
    for name in ("intensity", "red", "point_source_id", "X"):
        np.testing.assert_array_equal(before[name], after[name])


def test_no_point_is_farther_from_its_plane_than_the_distance(planes):
    after = laspy.read(planes["SEGMENTS"])
    xyz = np.column_stack([after.x, after.y, after.z])
    for row in rows(planes["PLANES"]):
        own = xyz[after["plane"] == row["plane"]] @ (row["nx"], row["ny"], row["nz"]) + row["distance"]
        assert np.abs(own).max() < 0.05 + 1e-4


@pytest.mark.parametrize("algorithm", ["facadeplanes", "facadedetails"])
def test_ground_alone_is_refused_in_one_sentence(run, tmp_path, algorithm):
    from qgis.core import QgsProcessingException

    ground = np.random.default_rng(0).uniform(0, 5, (5000, 3)) * (1, 1, 0.001)
    np.savetxt(tmp_path / "ground.xyz", ground, "%.4f")
    output = {"facadeplanes": "PLANES", "facadedetails": "ELEVATION"}[algorithm]
    with pytest.raises(QgsProcessingException, match="No upright plane"):
        run(algorithm, INPUT=str(tmp_path / "ground.xyz"), **{output: str(tmp_path / "out.shp")})
    assert [path.name for path in tmp_path.iterdir()] == ["ground.xyz"]


def test_defaults_of_parameters_are_those_of_the_settings():
    from ichnograph.algorithms.facade.planes.settings import PlaneSettings
    from ichnograph.algorithms.facade.settings import FacadeSettings
    from ichnograph.processing_provider.parameters.facade import MAX_PLANES, MIN_POINTS, SETTINGS

    # The first option of a choice is its default.
    shown = {name: getattr(parameter, "default", 0) for name, parameter in SETTINGS.items()}
    assert shown == {name: getattr(FacadeSettings(), name) for name in SETTINGS}
    assert MIN_POINTS.default == PlaneSettings().min_points
    assert MAX_PLANES.default == PlaneSettings().max_planes


ORIGIN = (412_000.0, 5_812_000.0, 70.0)


@pytest.fixture(scope="module")
def building(tmp_path_factory):
    """Write a block of 12 x 8 m with facades to a street in the south and a yard in the north."""
    xyz = block() + np.random.default_rng(0).normal(0, 0.002, (len(block()), 3)) + ORIGIN
    path = tmp_path_factory.mktemp("clouds") / "block.xyz"
    np.savetxt(path, xyz, "%.4f")
    return str(path)


def shapes(path, *wanted):
    write_vector(
        path, wanted[0].geom_type, {"name": "str:8"}, ((item, {"name": "a"}) for item in wanted), None
    )
    return str(path)


@pytest.fixture(scope="module")
def every(run, building, tmp_path_factory):
    folder = tmp_path_factory.mktemp("every")
    return run(
        "facadedetails", INPUT=building, ELEVATION=str(folder / "elevation.gpkg"), ALL=str(folder / "facades")
    ), folder  # fmt: skip


def test_every_facade_has_a_folder_of_its_own_and_all_have_one_schedule(every):
    result, folder = every
    names = {str(path.relative_to(folder / "facades")) for path in (folder / "facades").rglob("*.*")}

    for number in ("01", "02"):
        for name in ("elevation.gpkg", "elevation.qml", "details.gpkg", "left_out.gpkg", "orthoimage.tif"):
            assert f"facade_{number}/{name}" in names
    assert {*result["ALL_FILES"]} <= {str(folder / "facades" / name) for name in names}
    assert (folder / "facades" / "schedule.csv").read_text().startswith("facade,id,kind")
    assert not [name for name in names if ".ichnograph" in name]


def test_the_chosen_facade_of_the_folder_is_that_of_the_other_outputs(every):
    _, folder = every
    alone, (first, second) = rows(folder / "elevation.gpkg"), (
        rows(folder / "facades" / f"facade_0{number}" / "elevation.gpkg") for number in (1, 2)
    )  # fmt: skip

    assert alone == first
    assert (first[0]["azimuth"] - second[0]["azimuth"]) % 360 == pytest.approx(180, abs=0.1)


def test_a_line_along_a_facade_chooses_it_and_limits_the_folder_to_it(run, building, tmp_path, feedback):
    yard = shapes(tmp_path / "line.gpkg", LineString([(412_001, 5_812_009), (412_011, 5_812_009)]))
    (tmp_path / "facades" / "facade_01").mkdir(parents=True)
    result = run(
        "facadedetails", feedback, INPUT=building, FACADE_ALONG=yard,
        ELEVATION=str(tmp_path / "elevation.gpkg"), ALL=str(tmp_path / "facades"),
    )  # fmt: skip

    assert np.cos(np.radians(rows(result["ELEVATION"])[0]["azimuth"])) == pytest.approx(1, abs=1e-3)
    names = [path.name for path in sorted((tmp_path / "facades").iterdir())]
    assert names == ["facade_01", "facade_02", "schedule.csv"]
    assert not list((tmp_path / "facades" / "facade_01").iterdir())
    assert any("still holds facade_01 of an earlier run" in warning for warning in feedback.warnings)


def test_a_layer_without_shapes_along_a_facade_is_refused_and_nothing_is_written(run, building, tmp_path):
    from qgis.core import QgsProcessingException

    far = shapes(tmp_path / "far.gpkg", box(0, 0, 10, 10))
    with pytest.raises(QgsProcessingException, match="without a facade within 2 m"):
        run(
            "facadedetails", INPUT=building, FACADE_ALONG=far, ELEVATION=str(tmp_path / "elevation.gpkg"),
            ALL=str(tmp_path / "facades"),
        )  # fmt: skip
    assert [path.name for path in tmp_path.iterdir()] == ["far.gpkg"]


@pytest.mark.alone
def test_a_cancel_while_the_folder_is_drawn_leaves_nothing_behind(run, building, tmp_path, feedback):
    from qgis.core import QgsProcessingException

    push = feedback.setProgressText

    def cancel_at_the_second(text):
        push(text)
        if text.startswith("Facade 2"):
            feedback.cancel()

    feedback.setProgressText = cancel_at_the_second
    start = time.monotonic()
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run(
            "facadedetails", feedback, INPUT=building, ELEVATION=str(tmp_path / "elevation.gpkg"),
            ALL=str(tmp_path / "facades"),
        )  # fmt: skip
    assert time.monotonic() - start < 60
    assert list(tmp_path.iterdir()) == []


def test_what_is_left_out_is_a_layer_and_a_line_of_the_log(run, tmp_path, feedback):
    wall, cloud = upright((0, 0), (6, 0), 0, 4), str(tmp_path / "wall.xyz")
    u, v = wall[:, 0] - 3, wall[:, 2] - 2
    stained = np.hypot(u, v) + 0.3 * np.sin(5 * np.arctan2(v, u)) < 1
    colour = np.where(stained[:, None], (90, 80, 70), (210, 200, 180))
    np.savetxt(cloud, np.column_stack([wall, colour]), "%.3f", header="x y z r g b", comments="")
    result = run(
        "facadedetails", feedback, INPUT=cloud, ELEVATION=str(tmp_path / "elevation.gpkg"),
        LEFT_OUT=str(tmp_path / "left_out.gpkg"),
    )  # fmt: skip

    (stain,) = rows(result["LEFT_OUT"])
    assert (stain["kind"], "stain" in stain["reason"]) == ("coloured detail", True)
    assert any(info.startswith("Left out: 1 of kind coloured detail") for info in feedback.infos)


def test_a_round_tower_is_rolled_out_and_its_radius_is_in_the_log_and_the_fields(run, tmp_path, feedback):
    tower = np.concatenate([round_wall((3, 4), 3.0, 100, 260), ground(-3, -6, 9, 0.9)]) + ORIGIN
    np.savetxt(tmp_path / "tower.xyz", tower, "%.4f")
    result = run(
        "facadedetails", feedback, INPUT=str(tmp_path / "tower.xyz"), UNROLL=2,
        ELEVATION=str(tmp_path / "elevation.gpkg"), DETAILS=str(tmp_path / "details.gpkg"),
    )  # fmt: skip

    (wall, *_) = rows(result["ELEVATION"])
    assert wall["radius"] == pytest.approx(3.0, abs=0.01)
    assert wall["width"] == pytest.approx(3.0 * np.radians(160), rel=0.01)
    assert any("radius of 3.0" in text or "radius of 2.99" in text for text in feedback.steps)


def test_a_flat_facade_is_not_rolled_out(run, building, tmp_path):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="No round wall"):
        run("facadedetails", INPUT=building, UNROLL=2, ELEVATION=str(tmp_path / "elevation.gpkg"))
    assert list(tmp_path.iterdir()) == []
