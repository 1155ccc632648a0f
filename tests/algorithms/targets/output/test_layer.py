"""The layer of targets."""

from dataclasses import replace

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.registration.lists.point_list import read_point_list
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


def test_the_registration_reads_the_covariances_of_the_layer(tmp_path):
    covariance = np.array([[4.0, 1.0, -2.0], [1.0, 1.0, 0.5], [-2.0, 0.5, 9.0]]) * 1e-6
    write_targets(
        search(station("hall", replace(target(), covariance=covariance))), tmp_path / "targets.gpkg"
    )

    points = read_point_list(tmp_path / "targets.gpkg")
    np.testing.assert_allclose(points.covariances, [covariance], rtol=1e-3, atol=1e-11)
