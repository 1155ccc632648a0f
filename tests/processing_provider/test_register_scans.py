"""`registerscans` as QGIS runs it: lists in, transformations, layers and a report out."""

import json
from contextlib import suppress
from pathlib import Path

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.registration.output.layers import CONTROL_FIELDS, RESIDUAL_FIELDS
from ichnograph.tests.scenes.stations.caster import Scanner
from ichnograph.tests.scenes.stations.layout import target_station
from ichnograph.tests.scenes.targets import target_scene
from rasterio.crs import CRS
from scipy.spatial.transform import Rotation

FILES = {
    "TRANSFORMS": "transforms.json",
    "RESIDUALS": "residuals.gpkg",
    "CONTROL_OUT": "points.shp",
    "REPORT": "report.html",
}


def write(path, points, names=False):
    labels = points.names if names else [""] * len(points.names)
    lines = (f"{name} {x:.4f} {y:.4f} {z:.4f}".strip() for name, (x, y, z) in zip(labels, points.xyz))
    path.write_text("\n".join(lines) + "\n")
    return str(path)


@pytest.fixture(scope="session")
def scene():
    return target_scene(control=40, picked=9, common=7, seed=5)


@pytest.fixture
def lists(scene, tmp_path):
    """Write a control list, a scan that fits, and one of another place."""
    folder = tmp_path / "lists"
    folder.mkdir()
    places = np.random.default_rng(0).uniform(-10, 10, (6, 3))
    np.savetxt(folder / "elsewhere.txt", places, fmt="%.4f")
    return {
        "CONTROL": write(folder / "control.txt", scene.control, names=True),
        "TARGETS": [write(folder / "hall.txt", scene.targets), str(folder / "elsewhere.txt")],
    }


@pytest.fixture
def outputs(tmp_path):
    return {name: str(tmp_path / file) for name, file in FILES.items()}


@pytest.fixture
def refuse(run):
    from qgis.core import QgsProcessingException

    def refuse(**parameters):
        with pytest.raises(QgsProcessingException) as caught:
            run("registerscans", **parameters)
        return str(caught.value).split("Unable to execute algorithm\n")[-1]

    return refuse


def test_a_scan_finds_its_place_and_another_does_not_stop_it(run, lists, outputs, scene):
    result = run("registerscans", **lists, CRS="EPSG:25833", **outputs)

    assert {name: result[name] for name in outputs} == outputs
    assert result["SCANS_REGISTERED"] == 1
    assert 0.3 < result["SIGMA0"] < 2
    assert 0 < result["MAX_RESIDUAL"] < 0.012
    hall, elsewhere = json.loads(Path(outputs["TRANSFORMS"]).read_text(encoding="utf-8"))["scans"]
    assert (hall["name"], hall["status"]) == ("hall", "registered")
    place = np.array(hall["matrix"]) @ (*scene.targets.xyz[0], 1)
    np.testing.assert_allclose(place, scene.matrix @ (*scene.targets.xyz[0], 1), atol=0.02)
    names = {str(row): scene.truth[name] for row, name in enumerate(scene.targets.names, start=1)}
    assert all(names[item["target"]] == item["control"] for item in hall["correspondences"])
    assert elsewhere["matrix"] is None
    assert elsewhere["reason"]


def test_layers_have_their_fields_and_the_reference_system(run, lists, outputs):
    run("registerscans", **lists, CRS="EPSG:25833", **outputs)

    for name, fields in (("RESIDUALS", RESIDUAL_FIELDS), ("CONTROL_OUT", CONTROL_FIELDS)):
        with fiona.open(outputs[name]) as layer:
            assert list(layer.schema["properties"]) == list(fields)
            assert CRS.from_wkt(layer.crs_wkt).to_epsg() == 25833
            assert len(next(iter(layer))["geometry"]["coordinates"]) == 3


def test_layers_opened_by_hand_are_styled(run, lists, outputs):
    from qgis.core import QgsVectorLayer

    run("registerscans", **lists, **outputs)
    residuals = QgsVectorLayer(outputs["RESIDUALS"], "residuals")
    used, rejected = residuals.renderer().rootRule().children()
    arrows = used.symbol().symbolLayer(0)
    assert (arrows.layerType(), arrows.xAttribute(), arrows.yAttribute()) == ("VectorField", "vx", "vy")
    lengths = [np.hypot(item["vx"], item["vy"]) for item in residuals.getFeatures() if item["used"]]
    extent = residuals.extent()
    drawn = arrows.scale() * max(lengths) / np.hypot(extent.width(), extent.height())
    assert 0.1 / 2.6 < drawn <= 0.1
    assert f"{arrows.scale():.0f} times" in used.label()
    assert rejected.symbol().color().name() == "#b3261e"
    assert residuals.labelsEnabled()
    points = QgsVectorLayer(outputs["CONTROL_OUT"], "points")
    assert [rule.label() for rule in points.renderer().rootRule().children()] == [
        "Surveyed",
        "Appended from scans",
    ]


def test_the_words_of_the_legend_are_not_pushed_out_by_long_arrows(run, lists, outputs):
    from qgis.core import QgsLayerTree, QgsLayerTreeModel, QgsVectorLayer

    run("registerscans", **lists, **outputs)
    layer, tree = QgsVectorLayer(outputs["RESIDUALS"], "residuals"), QgsLayerTree()
    node = tree.addLayer(layer)
    model = QgsLayerTreeModel(tree)
    entries = model.layerLegendNodes(node)

    assert entries[0].data(0).startswith("Residual, ")
    assert max(entry.minimumIconSize().width() for entry in entries) < 50


def test_the_report_is_a_page_for_the_results_viewer(provider, run, lists, outputs):
    definition = provider.algorithm("registerscans").outputDefinition("REPORT")
    run("registerscans", **lists, **outputs)

    assert definition.type() == "outputHtml"
    assert "1 of 2 scans is registered" in Path(outputs["REPORT"]).read_text(encoding="utf-8")


def test_the_log_has_a_line_for_every_scan(run, lists, outputs, feedback):
    run("registerscans", feedback, **lists, **outputs)

    assert any("Tolerance of distances: 14.8 mm." in line for line in feedback.infos)
    [line] = [line for line in feedback.infos if line.startswith("hall: ")]
    for part in ("7 of 9 targets matched", "sigma0 ", "longest residual ", "accidental matches expected"):
        assert part in line
    assert any(line.startswith("elsewhere is not registered (") for line in feedback.warnings)
    assert any("no coordinate reference system" in line for line in feedback.warnings)
    assert feedback.fractions == sorted(feedback.fractions)


def test_only_what_is_asked_for_is_written(run, lists, tmp_path):
    result = run("registerscans", **lists, TRANSFORMS=str(tmp_path / "t.json"))

    assert set(result) == {"TRANSFORMS", "SCANS_REGISTERED", "SIGMA0", "MAX_RESIDUAL"}
    assert {file.name for file in tmp_path.iterdir()} == {"lists", "t.json"}


def test_outputs_of_one_name_still_have_their_style(run, lists, tmp_path):
    paths = {"TRANSFORMS": "site.json", "RESIDUALS": "site.gpkg", "REPORT": "site.html"}
    run("registerscans", **lists, **{name: str(tmp_path / file) for name, file in paths.items()})

    assert (tmp_path / "site.qml").exists()


def test_the_dialog_offers_all_outputs(provider):
    from qgis.core import QgsProcessingParameterDefinition

    optional = QgsProcessingParameterDefinition.Flag.FlagOptional
    files = {name: provider.algorithm("registerscans").parameterDefinition(name) for name in FILES}

    assert all(file.createByDefault() for file in files.values())
    assert [name for name, file in files.items() if not file.flags() & optional] == ["TRANSFORMS"]


def test_temporary_outputs_are_files_of_their_kind(run, lists):
    result = run("registerscans", **lists, **dict.fromkeys(FILES, "TEMPORARY_OUTPUT"))

    endings = {"TRANSFORMS": ".json", "RESIDUALS": ".gpkg", "CONTROL_OUT": ".gpkg", "REPORT": ".html"}
    assert all(result[name].endswith(ending) for name, ending in endings.items())


def test_if_no_scan_is_registered_the_error_gives_all_reasons_and_nothing_is_written(
    refuse, lists, outputs, tmp_path
):
    (tmp_path / "lists" / "poor.txt").write_text("0 0 0\n5 0 1\n")
    lists["TARGETS"] = [lists["TARGETS"][1], str(tmp_path / "lists" / "poor.txt")]
    sentence = refuse(**lists, **outputs)

    assert sentence.startswith("No scan could be registered. ")
    assert "elsewhere" in sentence and "poor has 2 targets" in sentence
    assert {file.name for file in tmp_path.iterdir()} == {"lists"}


@pytest.mark.parametrize(
    ("parameters", "sentence"),
    [
        ({"MODEL": 5}, "(MODEL) must be 0 (Rigid, 6 parameters) or 1 "),
        ({"MATCHING": "shape"}, "(MATCHING) must be 0 (By distances) or 1 (By names), not shape."),
        ({"SIGMA": 0}, "(SIGMA) must be a number"),
        ({"CONTROL_SIGMA": -1}, "(CONTROL_SIGMA) must be a number"),
        ({"TOLERANCE": 0}, "(TOLERANCE) must be a number"),
        ({"CRS": "EPSG:4326"}, "The coordinates of Coordinate reference system (CRS) are in degrees"),
        ({"TARGETS": ""}, "(TARGETS) is empty"),
    ],
)
def test_a_value_that_makes_no_sense_is_refused(refuse, lists, outputs, parameters, sentence):
    assert sentence in refuse(**{**lists, **outputs, **parameters})


@pytest.mark.parametrize("given", [1, "1"])
def test_names_identify_points_if_the_user_chooses_them(run, scene, lists, outputs, tmp_path, given):
    named = [scene.truth[name] or f"new{row}" for row, name in enumerate(scene.targets.names)]
    rows = (f"{name} {x:.4f} {y:.4f} {z:.4f}" for name, (x, y, z) in zip(named, scene.targets.xyz))
    (tmp_path / "lists" / "hall.txt").write_text("\n".join(rows))
    result = run("registerscans", **{**lists, "TARGETS": lists["TARGETS"][:1]}, MATCHING=given, **outputs)

    assert result["SCANS_REGISTERED"] == 1


@pytest.mark.parametrize("name", ["CONTROL", "TARGETS"])
def test_a_list_is_never_overwritten(refuse, lists, outputs, tmp_path, name):
    layer = tmp_path / "lists" / "points.gpkg"
    schema = {"geometry": "3D Point", "properties": {"name": "str"}}
    with fiona.open(layer, "w", driver="GPKG", schema=schema, crs="EPSG:25833") as file:
        for row in range(5):
            point = {"type": "Point", "coordinates": (row, row**2, 0.5 * row)}
            file.write({"geometry": point, "properties": {"name": str(row)}})
    before = layer.read_bytes()
    sentence = refuse(**{**lists, **outputs, name: str(layer), "RESIDUALS": str(layer)})

    assert sentence == f"Residuals (RESIDUALS) {layer} is an input as well; choose another name."
    assert layer.read_bytes() == before


@pytest.fixture(scope="module")
def stations():
    """Two stations with five targets each, and where the targets truly are in the control frame."""
    places = [("black and white", 0.15, distance, 20.0) for distance in (3.0, 7.0, 4.0, 8.0)]
    scans, control = {}, []
    for number, name in enumerate(("hall", "stairs")):
        station = target_station(
            Scanner(step=0.0008), [*places, ("sphere", 0.145, 5.0 + number, 0.0)], seed=5 + number
        )
        turn = Rotation.from_euler("z", 50 + 90 * number, degrees=True).as_matrix()
        centres = np.array([target.centre for target in station.targets])
        control.append(centres @ turn.T + [100.0 + 20 * number, 200.0, 30.0])
        scans[name] = station
    return scans, np.concatenate(control)


@pytest.fixture
def raw(stations, tmp_path):
    """Write the scans as text, and the control points to the micrometre."""
    scans, control = stations
    for name, station in scans.items():
        columns = np.column_stack([station.xyz, station.intensity])
        np.savetxt(
            tmp_path / f"{name}.xyz", columns, "%.5f %.5f %.5f %d", header="x y z intensity", comments=""
        )
    np.savetxt(tmp_path / "control.csv", control, "%.6f", delimiter=",")
    return {
        "CONTROL": str(tmp_path / "control.csv"),
        "TARGETS": [str(tmp_path / f"{name}.xyz") for name in scans],
        "CRS": "EPSG:25833",
        "TRANSFORMS": str(tmp_path / "transforms.json"),
    }


def test_scans_are_registered_by_the_targets_found_in_them(run, raw, stations, tmp_path, feedback):
    result = run("registerscans", feedback, **raw)

    assert result["SCANS_REGISTERED"] == 2
    assert result["MAX_RESIDUAL"] < 0.001
    assert "Searching 2 scans for targets, because they have no lists." in feedback.infos
    assert "hall: 5 targets, 0 doubtful." in feedback.infos
    found = json.loads(Path(raw["TRANSFORMS"]).read_text(encoding="utf-8"))["scans"]
    for scan, station, true in zip(found, stations[0].values(), np.split(stations[1], 2)):
        matrix = np.array(scan["matrix"])
        centres = np.array([target.centre for target in station.targets])
        assert centres @ matrix[:3, :3].T + matrix[:3, 3] == pytest.approx(true, abs=5e-4)


def test_found_targets_count_by_their_own_standard_deviations(run, raw, tmp_path):
    """Lists that findtargets writes give what the scans give, whatever SIGMA is; bare coordinates do not."""
    lists = run("findtargets", INPUT=raw["TARGETS"], OUTPUT_FOLDER=str(tmp_path / "lists"))["LISTS"]
    bare = [str(tmp_path / f"{Path(path).stem}.csv") for path in lists]
    for path, coordinates in zip(lists, bare):
        np.savetxt(coordinates, np.loadtxt(path, skiprows=1)[:, :3], fmt="%.5f")
    raw["CONTROL_SIGMA"] = 0.001

    def sigma0(targets, sigma):
        return run("registerscans", **{**raw, "TARGETS": targets, "SIGMA": sigma})["SIGMA0"]

    assert sigma0(lists, 0.003) == pytest.approx(sigma0(raw["TARGETS"], 0.003), rel=0.02)
    assert sigma0(lists, 0.006) == pytest.approx(sigma0(lists, 0.003))
    assert sigma0(bare, 0.006) == pytest.approx(sigma0(bare, 0.003) / 2, rel=0.1)


def test_a_scan_whose_list_is_given_too_is_not_searched(run, raw, tmp_path, feedback):
    lists = run("findtargets", INPUT=raw["TARGETS"], OUTPUT_FOLDER=str(tmp_path / "lists"))["LISTS"]
    run("registerscans", feedback, **{**raw, "TARGETS": [*lists, *raw["TARGETS"]]})

    assert not any("Searching" in line for line in feedback.infos)


def test_found_targets_cannot_be_matched_by_names(refuse, raw):
    assert "have no names; set Matching (MATCHING) to distances" in refuse(**raw, MATCHING=1)


def test_scans_without_targets_are_refused_with_the_tests_that_failed(refuse, raw, tmp_path):
    azimuth, elevation = np.meshgrid(np.arange(0, 0.3, 0.0015), np.arange(-0.1, 0.1, 0.0015))
    wall = 5 / np.cos(azimuth)
    xyz = np.stack([0 * wall + 5, 5 * np.tan(azimuth), wall * np.tan(elevation)], axis=-1).reshape(-1, 3)
    np.savetxt(tmp_path / "bare.xyz", np.column_stack([xyz, np.full(len(xyz), 900)]), "%.4f %.4f %.4f %d")

    assert "No target was found" in refuse(**{**raw, "TARGETS": [str(tmp_path / "bare.xyz")]})


def test_control_points_with_northing_before_easting_are_said(run, scene, outputs, tmp_path, feedback):
    from qgis.core import QgsProcessingException

    national = scene.control.xyz - scene.control.xyz.mean(axis=0) + (412345.0, 5812345.0, 70.0)
    rows = (f"{name} {y:.4f} {x:.4f} {z:.4f}\n" for name, (x, y, z) in zip(scene.control.names, national))
    control = tmp_path / "control.txt"
    control.write_text("".join(rows))
    targets = write(tmp_path / "hall.txt", scene.targets)
    with suppress(QgsProcessingException):
        run("registerscans", feedback, CONTROL=str(control), TARGETS=[targets], CRS="EPSG:25833", **outputs)

    assert any(line.startswith(f"x and y of {control} seem to be swapped") for line in feedback.warnings)
