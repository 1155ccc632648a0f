"""The layer of targets."""

import fiona
import pytest
from ichnograph.algorithms.targets.output.layer import write_targets
from ichnograph.algorithms.targets.results import Kind
from ichnograph.tests.algorithms.targets.made_targets import search, station, target


@pytest.mark.parametrize("name", ["targets.gpkg", "targets.shp"])
def test_every_target_is_a_point_with_its_measures(tmp_path, name):
    found = search(station("hall", target((1.0, 2.0, 3.0)), target(kind=Kind.SPHERE, doubt="few points")))
    write_targets(found, tmp_path / name)

    with fiona.open(tmp_path / name) as layer:
        first, second = (dict(item["properties"]) for item in layer)
        assert layer[0 if name.endswith("shp") else 1]["geometry"]["coordinates"] == (101.0, 202.0, 13.0)
    assert (first["scan"], first["name"], first["kind"]) == ("hall", "1", "black and white")
    assert (first["sx"], first["sz"]) == (0.001, 0.003)
    assert (first["incidence"], first["doubtful"], first["doubt"]) == (12.0, 0, None)
    assert (second["name"], second["incidence"]) == (None, None)
    assert (second["doubtful"], second["doubt"]) == (1, "few points")
