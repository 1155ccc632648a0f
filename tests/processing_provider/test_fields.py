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


def test_the_element_of_the_style_names_index_field_and_alias():
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
