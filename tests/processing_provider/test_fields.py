"""Aliases with units, in every layer."""

import re

import pytest
from ichnograph.algorithms.evaluation import plan_layer
from ichnograph.algorithms.facade.output import elevation_layers, plane_layers
from ichnograph.algorithms.registration.output import layers as registration
from ichnograph.algorithms.site_plan.output import layers as site_plan
from ichnograph.algorithms.targets.output import layer as targets
from ichnograph.processing_provider.fields import ALIASES, aliases_of

MODULES = (plan_layer, elevation_layers, plane_layers, registration, site_plan, targets)


@pytest.mark.parametrize("module", MODULES)
def test_every_field_has_an_alias(module):
    tables = [value for name, value in vars(module).items() if name.endswith("FIELDS")]
    assert tables
    assert {field for table in tables for field in table} <= {*ALIASES}


def test_lengths_and_areas_state_their_units():
    assert ALIASES["length"].endswith("(m)") and ALIASES["area"].endswith("(m²)")


def test_the_element_of_the_style_names_index_field_and_alias(plugin):
    text = aliases_of(["fid", "area"])
    assert re.fullmatch(r'<aliases><alias index="1" field="area" name="Area \(m²\)"/></aliases>', text)


def test_a_layer_shows_aliases_and_rounded_millimetres(run, room, tmp_path):
    from qgis.core import QgsVectorLayer

    path = run("siteplan", INPUT=room, WALLS=str(tmp_path / "walls.gpkg"))["WALLS"]
    layer = QgsVectorLayer(path, "walls", "ogr")

    fields = layer.fields()
    assert fields.field("length").alias() == "Length (m)"
    (wall,) = layer.getFeatures()
    assert wall["length"] == round(wall["length"], 3)


def test_exact_values_are_shown_rounded(plugin, tmp_path):
    from ichnograph.algorithms.vector import write_vector
    from ichnograph.processing_provider.styles import style_of
    from qgis.core import QgsApplication, QgsVectorLayer
    from qgis.PyQt.QtXml import QDomDocument
    from shapely.geometry import box

    path = tmp_path / "elevation.gpkg"
    row = {"id": 1, "z0": 71.2507929125699}
    write_vector(path, "Polygon", {"id": "int", "z0": "float"}, [(box(0, 0, 1, 1), row)], None)
    layer, style = QgsVectorLayer(str(path), "", "ogr"), QDomDocument()
    style.setContent(style_of("elevation", path, {}))
    layer.importNamedStyle(style)

    column = layer.fields().lookupField("z0")
    widget = layer.editorWidgetSetup(column)
    formatter = QgsApplication.fieldFormatterRegistry().fieldFormatter(widget.type())
    (feature,) = layer.getFeatures()
    assert formatter.representValue(layer, column, widget.config(), None, feature["z0"]) == "71.251"
    assert feature["z0"] == row["z0"]
