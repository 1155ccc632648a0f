"""What `siteplan` makes beyond the walls: axes, rooms, the report, and walls that stand in the 3D view."""

from pathlib import Path

import fiona
import pytest
from ichnograph.tests.processing_provider.models import build_model, destination, files
from ichnograph.tests.processing_provider.room import covered_points, write_las
from rasterio.crs import CRS

FURTHER = {
    "AXES": "axes.gpkg",
    "ROOMS": "rooms.gpkg",
    "LIMITS": "limits.gpkg",
    "LEFT_OUT": "left_out.gpkg",
    "REPORT": "plan.html",
}


@pytest.fixture(scope="module")
def made(run, room, tmp_path_factory):
    folder = tmp_path_factory.mktemp("site")
    return run(
        "siteplan",
        INPUT=room,
        WALLS=str(folder / "walls.gpkg"),
        **{name: str(folder / file) for name, file in FURTHER.items()},
    )


@pytest.fixture(scope="module")
def covered(run, tmp_path_factory):
    """Make the plan of a room under a ceiling, whose eastern wall was seen up to 1.4 m; return it by cut."""
    folder = tmp_path_factory.mktemp("covered")
    write_las(folder / "room.laz", covered_points(open_from=1.4), CRS.from_epsg(25833))

    def plan(section):
        names = {"WALLS": "walls.gpkg", **FURTHER}
        return run(
            "siteplan",
            INPUT=str(folder / "room.laz"),
            SECTION=section,
            **{name: str(folder / f"{section}_{file}") for name, file in names.items()},
        )

    return {section: plan(section) for section in (1.1, 2.0)}


def rows_of(path):
    with fiona.open(path) as layer:
        assert layer.crs.to_epsg() == 25833
        return [feature["properties"] for feature in layer]


def test_the_room_is_found_between_its_faces(made):
    with fiona.open(made["ROOMS"]) as layer:
        (feature,) = layer
        assert layer.crs.to_epsg() == 25833
    row = feature["properties"]
    # The room is 6 by 4 m; outlines of pixels lie about half of one off.
    assert row["area"] == pytest.approx(24.0, abs=1.5)
    assert row["perimeter"] == pytest.approx(20.0, abs=0.8)
    assert (row["room_id"], row["openings"]) == (1, 0)
    assert row["z_floor"] == pytest.approx(70.0, abs=0.05)
    assert (made["ROOM_COUNT"], made["ROOM_AREA"]) == (1, pytest.approx(row["area"], abs=1e-3))


def test_the_axes_run_around_the_room(made):
    with fiona.open(made["AXES"]) as layer:
        rows = [feature["properties"] for feature in layer]
    assert len(rows) == 4
    assert sum(row["length"] for row in rows) == pytest.approx(20.0, abs=0.5)
    assert {row["wall_id"] for row in rows} == {1}


def test_without_a_ceiling_limits_and_what_was_left_out_are_empty_layers(made):
    assert rows_of(made["LIMITS"]) == []
    assert rows_of(made["LEFT_OUT"]) == []


def test_under_a_ceiling_walls_and_rooms_are_those_of_the_storey(covered):
    walls, (room,) = rows_of(covered[1.1]["WALLS"]), rows_of(covered[1.1]["ROOMS"])
    assert [(row["wall_id"], row["kind"], row["body"]) for row in walls] == [
        (number, "wall", 1) for number in (1, 2, 3, 4)
    ]
    assert {row["thickness"] for row in walls} == {None}
    assert room["area"] == pytest.approx(24.0, abs=0.1)
    assert (room["z_floor"], room["z_ceiling"]) == pytest.approx((70.0, 72.5), abs=0.01)
    assert (room["openings"], room["seen"]) == (None, pytest.approx(1.0, abs=0.02))


def test_what_stands_free_in_a_room_is_left_out_with_its_reason(covered):
    (row,) = rows_of(covered[1.1]["LEFT_OUT"])
    assert "furniture" in row["reason"]
    assert row["length"] == pytest.approx(0.8, abs=0.08)


def test_a_wall_that_ends_below_the_section_is_a_limit(covered):
    assert rows_of(covered[1.1]["LIMITS"]) == []
    limits = rows_of(covered[2.0]["LIMITS"])
    assert sum(row["length"] for row in limits) == pytest.approx(4.0, abs=0.1)
    assert covered[2.0]["WALL_COUNT"] == 3


def test_the_storey_is_in_the_log(run, tmp_path, feedback):
    write_las(tmp_path / "room.laz", covered_points(), CRS.from_epsg(25833))
    run("siteplan", feedback, INPUT=str(tmp_path / "room.laz"), WALLS=str(tmp_path / "walls.gpkg"))
    (line,) = [info for info in feedback.infos if info.startswith("Storey:")]
    assert "floor at 70.00 m" in line


def test_warnings_reach_the_log_even_if_no_wall_is_found(run, room, tmp_path, feedback):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="No wall found"):
        run("siteplan", feedback, INPUT=room, SPACING=0.12, MIN_AREA=999, WALLS=str(tmp_path / "walls.gpkg"))
    assert [
        warning
        for warning in feedback.warnings
        if warning.startswith("Point spacing (SPACING) 0.12 m is wider")
    ]


def test_the_report_lists_the_parameters_of_the_run(made):
    page = Path(made["REPORT"]).read_text(encoding="utf-8")
    assert "Site plan" in page
    assert "DOOR_WIDTH" in page


def test_the_defaults_of_the_parameters_are_those_of_the_core(plugin):
    from ichnograph.algorithms.site_plan.settings import SitePlanSettings
    from ichnograph.processing_provider.algorithms.site_plan import SitePlanAlgorithm, settings_of

    defaults = {item.name: getattr(item, "default", None) for item in SitePlanAlgorithm.inputs}
    given = {**defaults, "HEIGHTS": 0, "AXES": None, "ROOMS": None, "DRAWING": None}
    assert settings_of(given) == SitePlanSettings()
    assert settings_of({**given, "SECTION": 0.9}).storeys.cut.section_m == 0.9


def test_scripts_get_what_they_ask_for_and_a_dialog_offers_rooms_and_report(provider, run, room, tmp_path):
    result = run("siteplan", INPUT=room, WALLS=str(tmp_path / "walls.gpkg"))

    assert not {*FURTHER, "ROOM_COUNT", "ROOM_AREA"} & {*result}
    definitions = {item.name(): item for item in provider.algorithm("siteplan").parameterDefinitions()}
    offered = {name for name in (*FURTHER, "PLAN", "DENSITY") if definitions[name].createByDefault()}
    assert offered == {"DENSITY", "ROOMS", "REPORT"}


def test_rooms_can_be_the_result_of_a_model(provider, room, tmp_path):
    import processing

    model = build_model([files("CLOUDS")], {"siteplan": {"INPUT": "CLOUDS"}}, ("siteplan", "ROOMS"))
    path = str(tmp_path / "rooms.gpkg")
    processing.run(model, {"CLOUDS": [room], destination(model): path})
    with fiona.open(path) as layer:
        assert len(layer) == 1


def test_walls_rise_from_base_to_top_in_the_3d_view(made):
    pytest.importorskip("qgis._3d", reason="QGIS was built without its 3D view")
    from qgis._3d import Qgs3D
    from qgis.core import QgsVectorLayer
    from qgis.PyQt.QtXml import QDomDocument

    Qgs3D.initialize()
    layer = QgsVectorLayer(made["WALLS"], "walls")
    assert layer.renderer3D().type() == "vector"
    document = QDomDocument()
    layer.exportNamedStyle(document)
    properties = document.documentElement().firstChildElement("renderer-3d").toElement()
    options = properties.elementsByTagName("Option")
    expressions = [
        options.at(i).toElement().attribute("value")
        for i in range(options.count())
        if options.at(i).toElement().attribute("name") == "expression"
    ]
    lowest = min(feature["z_base"] for feature in layer.getFeatures())
    assert sorted(expressions) == [f'"z_base" - coalesce(@ground, {lowest})', '"z_top" - "z_base"']


def test_rooms_and_axes_are_labelled_with_area_and_thickness(made):
    from qgis.core import QgsVectorLayer

    for name, field in {"ROOMS": "area", "AXES": "thickness"}.items():
        layer = QgsVectorLayer(made[name], name)
        assert layer.labelsEnabled()
        assert field in layer.labeling().settings().fieldName
