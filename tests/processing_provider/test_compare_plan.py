"""`compareplan`, run as scripts, models and the command line run it."""

import json
from pathlib import Path

import fiona
import pytest
from ichnograph.algorithms.vector import write_vector
from ichnograph.tests.processing_provider.models import build_model, destination, files
from rasterio.crs import CRS
from shapely.affinity import translate
from shapely.geometry import LineString, box, mapping, shape

OPEN_FILES = Path("/proc/self/fd")
X, Y = 412300.0, 5812300.0
WALLS = [box(X, Y, X + 8, Y + 0.5), box(X + 7.5, Y + 0.5, X + 8, Y + 6)]


@pytest.fixture
def write(tmp_path):
    def write(name, shapes, epsg=25833):
        path = tmp_path / name
        write_vector(
            path, shapes[0].geom_type, {"id": "int"}, [(s, {"id": 1}) for s in shapes], CRS.from_epsg(epsg)
        )
        return str(path)

    return write


@pytest.fixture
def layers(write):
    """Write a plan that is 2 cm off and lacks a wall, and its reference."""
    more = box(X, Y + 3, X + 4, Y + 3.5)
    return {
        "WALLS": write("plan.shp", [translate(wall, 0, 0.02) for wall in WALLS]),
        "REFERENCE": write("true.gpkg", [*WALLS, more]),
    }


def test_it_measures_a_plan_and_says_where_it_is_off(run, layers, tmp_path, feedback):
    errors, report = str(tmp_path / "errors.gpkg"), tmp_path / "report.html"
    result = run("compareplan", feedback, **layers, ERRORS=errors, REPORT=str(report))

    assert result["CORRECTNESS"] == 1
    assert result["ROOMS_FOUND"] is None
    assert result["COMPLETENESS"] == pytest.approx(28 / 37, abs=0.001)
    assert result["IOU"] == pytest.approx(6.75 / 8.75, abs=0.04)
    assert 0 < result["MEDIAN_OFFSET"] <= result["P95_OFFSET"] == pytest.approx(0.02, abs=1e-3)
    with fiona.open(errors) as layer:
        assert CRS.from_wkt(layer.crs_wkt) == CRS.from_epsg(25833)
        rows = [(item["properties"], shape(item["geometry"])) for item in layer]
    missing = [line for row, line in rows if row["state"] == "missing"]
    assert sum(line.length for line in missing) == pytest.approx(9, abs=0.01)
    assert {row["side"] for row, _ in rows if row["state"] == "agrees"} == {"plan", "reference"}
    assert "75.7% of the reference is in the plan" in report.read_text(encoding="utf-8")
    assert "Completeness 0.757, correctness 1.000." in feedback.infos
    assert feedback.warnings == []


def test_the_tolerance_is_the_users(run, layers, tmp_path):
    result = run("compareplan", **layers, TOLERANCE=0.01, ERRORS=str(tmp_path / "errors.shp"), REPORT=None)

    assert result["CORRECTNESS"] < 0.6
    assert "REPORT" not in result


def test_the_errors_have_their_style(run, layers, tmp_path):
    from qgis.core import QgsVectorLayer

    errors = str(tmp_path / "errors.gpkg")
    run("compareplan", **layers, TOLERANCE=0.04, ERRORS=errors, REPORT=None)
    layer = QgsVectorLayer(errors, "errors", "ogr")
    rules = layer.renderer().rootRule().children()

    assert [rule.label().split()[0] for rule in rules] == [
        "Reference,", "Plan", "Plan", "Plan", "Missing:", "Wrong:",
    ]  # fmt: skip
    assert rules[1].label() == "Plan within a quarter of the tolerance of 0.04 m"
    fitting = [sum(fits(layer, rule, feature) for rule in rules) for feature in layer.getFeatures()]
    assert set(fitting) == {1}


def fits(layer, rule, feature):
    from qgis.core import QgsExpression, QgsExpressionContext, QgsExpressionContextUtils

    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    return bool(QgsExpression(rule.filterExpression()).evaluate(context))


def test_layers_of_no_file_are_compared_with_their_arcs(run, tmp_path):
    from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

    def layer(wkt):
        made = QgsVectorLayer("CurvePolygon?crs=EPSG:25833", "drawn", "memory")
        feature = QgsFeature()
        feature.setGeometry(QgsGeometry.fromWkt(wkt))
        made.dataProvider().addFeature(feature)
        return made

    disc = layer("CurvePolygon (CircularString (0 0, 2 0, 0 0))")
    result = run("compareplan", WALLS=disc, REFERENCE=disc, ERRORS=str(tmp_path / "e.gpkg"), REPORT=None)
    assert (result["COMPLETENESS"], result["IOU"]) == pytest.approx((1, 1))


def test_faces_as_lines_have_no_intersection_over_union(run, layers, write, tmp_path):
    faces = write("faces.gpkg", [LineString(wall.exterior.coords) for wall in WALLS])
    result = run(
        "compareplan", WALLS=layers["WALLS"], REFERENCE=faces, ERRORS=str(tmp_path / "e.gpkg"), REPORT=None
    )
    assert result["IOU"] is None
    assert result["CORRECTNESS"] > 0.9


def drawn_plan(path):
    """Write a plan drawn by hand as GeoJSON in metres: two faces, a room, and a region with the first."""
    drawn = [
        (LineString([(X, Y), (X + 8, Y)]), "wall"),
        (LineString([(X, Y + 20), (X + 8, Y + 20)]), "wall"),
        (box(X, Y + 0.5, X + 7.5, Y + 6), "room"),
        (box(X - 1, Y - 1, X + 7, Y + 7), "judged"),
    ]
    features = [
        {"type": "Feature", "properties": {"kind": kind}, "geometry": mapping(geometry)}
        for geometry, kind in drawn
    ]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}), encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("suffix", ["", "|geometrytype=LineString"], ids=["a file", "as QGIS loads it"])
def test_a_plan_drawn_by_hand_brings_its_rules(run, layers, write, tmp_path, feedback, suffix):
    from qgis.core import QgsVectorLayer

    path, report = drawn_plan(tmp_path / "drawn.geojson"), tmp_path / "report.html"
    reference = QgsVectorLayer(path + suffix, "drawn", "ogr") if suffix else path
    rooms = write("rooms.gpkg", [box(X, Y + 0.5, X + 7.5, Y + 6), box(X, Y + 3, X + 5, Y + 6)])
    result = run(
        "compareplan",
        feedback,
        WALLS=layers["WALLS"],
        REFERENCE=reference,
        ROOMS=rooms,
        TOLERANCE=0.05,
        ERRORS=str(tmp_path / "errors.gpkg"),
        REPORT=str(report),
    )
    assert result["COMPLETENESS"] == pytest.approx(1.0, abs=0.01)
    assert (result["ROOMS_FOUND"], result["ROOMS_MISSED"], result["ROOMS_INVENTED"]) == (1, 0, 1)
    assert "1 found, 0 missed, 1 invented" in report.read_text(encoding="utf-8")
    assert any("drawn by hand" in info for info in feedback.infos)
    (warning,) = feedback.warnings
    assert "no coordinate reference system" in warning


def test_a_plan_with_nothing_of_the_reference_has_no_offset_and_the_log_says_so(
    run, layers, write, tmp_path, feedback
):
    away = write("away.gpkg", [translate(wall, 500, 0) for wall in WALLS])
    result = run(
        "compareplan", feedback, WALLS=layers["WALLS"], REFERENCE=away, ERRORS=str(tmp_path / "e.gpkg")
    )
    assert (result["COMPLETENESS"], result["MEDIAN_OFFSET"], result["P95_OFFSET"]) == (0, None, None)
    (warning,) = feedback.warnings
    assert "nothing in common: they are 492.0 m apart" in warning


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"WALLS": "nowhere.shp"}, "WALLS. .*nowhere.shp cannot be read; choose a layer of polygons"),
        ({"TOLERANCE": 0}, "TOLERANCE"),
        ({"REFERENCE": "other zone"}, "is in EPSG:25833, but .* in EPSG:25832; reproject"),
        ({"ERRORS": "reference"}, "is an input as well"),
    ],
)
def test_what_cannot_be_compared_is_refused(run, layers, write, tmp_path, change, sentence):
    from qgis.core import QgsProcessingException

    change = dict(change)
    if change.get("REFERENCE"):
        change["REFERENCE"] = write("zone.gpkg", WALLS, 25832)
    if change.get("ERRORS"):
        change["ERRORS"] = layers["REFERENCE"]
    parameters = {**layers, "ERRORS": str(tmp_path / "errors.gpkg"), "REPORT": None, **change}
    with pytest.raises(QgsProcessingException, match=sentence):
        run("compareplan", **parameters)


def test_the_walls_may_be_an_output_of_the_same_model(plugin, room, write, tmp_path):
    import processing
    from qgis.core import QgsProcessingParameterVectorLayer

    model = build_model(
        [files("CLOUDS"), QgsProcessingParameterVectorLayer("TRUE", "True walls")],
        {
            "siteplan": {"INPUT": "CLOUDS"},
            "compareplan": {"WALLS": ("siteplan", "WALLS"), "REFERENCE": "TRUE"},
        },
        ("compareplan", "REPORT"),
    )
    true = write("true.gpkg", [box(X + 1, Y + 1, X + 7, Y + 5)])
    page = tmp_path / "report.html"
    processing.run(model, {"CLOUDS": [room], "TRUE": true, destination(model): str(page)})

    assert "of the reference is in the plan" in page.read_text(encoding="utf-8")


def test_a_layer_of_the_project_may_be_named(run, layers, tmp_path):
    from qgis.core import QgsProject, QgsVectorLayer

    layer = QgsVectorLayer(layers["REFERENCE"], "survey", "ogr")
    layer.setSubsetString("fid < 3")
    QgsProject.instance().addMapLayer(layer)
    for reference in (layer, layer.id(), "survey"):
        errors = str(tmp_path / "errors.gpkg")
        result = run("compareplan", WALLS=layers["WALLS"], REFERENCE=reference, ERRORS=errors, REPORT=None)
        assert result["COMPLETENESS"] == 1
    QgsProject.instance().clear()


@pytest.mark.skipif(not OPEN_FILES.is_dir(), reason="open files are counted as Linux shows them")
def test_files_are_closed_after_a_run_without_an_event_loop(run, layers, tmp_path):
    def open_files():
        run("compareplan", **layers, ERRORS=str(tmp_path / "errors.shp"), REPORT=None)
        return len(list(OPEN_FILES.iterdir()))

    open_files()
    assert open_files() == open_files()
