"""The algorithms chained in a model, as the model designer stores them."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.tests.processing_provider.models import build_model, destination, files
from ichnograph.tests.processing_provider.room import CORNER


@pytest.fixture
def model(provider):
    def defaults(name):
        """Return all numbers: as the designer does, every default is stored."""
        parameters = provider.algorithm(name).parameterDefinitions()
        return {item.name(): item.defaultValue() for item in parameters if item.type() == "number"}

    return build_model(
        [files("CLOUDS")],
        {
            "thincloud": {**defaults("thincloud"), "INPUT": "CLOUDS", "SPACING": 0.04},
            "densityimage": {**defaults("densityimage"), "INPUT": ("thincloud", "OUTPUT")},
            "extractwalls": {
                **defaults("extractwalls"),
                "INPUT": ("densityimage", "DENSITY"),
                "MIN_HEIGHT": 0.5,
            },
        },
        ("extractwalls", "WALLS"),
    )


def test_a_chain_of_the_algorithms_runs_as_a_model(model, room, tmp_path):
    import fiona
    import processing

    valid, problems = model.validate()
    assert valid, problems
    walls = destination(model)
    result = processing.run(model, {"CLOUDS": [room], walls: str(tmp_path / "walls.shp")})

    assert result[walls] == str(tmp_path / "walls.shp")
    with fiona.open(result[walls]) as layer:
        assert len(layer) == 1


def test_a_model_that_was_stored_still_runs(model, room, tmp_path):
    import processing
    from qgis.core import QgsProcessingModelAlgorithm

    model.toFile(str(tmp_path / "chain.model3"))
    stored = QgsProcessingModelAlgorithm()
    assert stored.fromFile(str(tmp_path / "chain.model3"))

    walls = destination(stored)
    assert processing.run(stored, {"CLOUDS": room, walls: str(tmp_path / "walls.gpkg")})[walls]


@pytest.mark.parametrize("handed_on", ["CLOUDS", "OUTPUT_FOLDER"])
def test_scans_are_registered_transformed_and_drawn_in_one_model(provider, room, tmp_path, handed_on):
    import fiona
    import processing
    from qgis.core import QgsProcessingParameterFile

    model = build_model(
        [files("CLOUDS"), QgsProcessingParameterFile("CONTROL", "Control points"), files("TARGETS")],
        {
            "registerscans": {"CONTROL": "CONTROL", "TARGETS": "TARGETS"},
            "transformcloud": {"INPUT": "CLOUDS", "TRANSFORMS": ("registerscans", "TRANSFORMS")},
            "siteplan": {"INPUT": ("transformcloud", handed_on)},
        },
        ("siteplan", "WALLS"),
    )
    targets, control = field_lists(tmp_path, room)

    inputs = {"CLOUDS": [room], "CONTROL": str(control), "TARGETS": [str(targets)]}
    result = processing.run(model, {**inputs, destination(model): str(tmp_path / "walls.gpkg")})

    with fiona.open(result[destination(model)]) as layer:
        (wall,) = layer
        bounds = np.array(wall["geometry"]["coordinates"][0])
    # The room was moved by 1000 m to the east.
    assert np.abs(bounds.min(axis=0) - (CORNER[:2] + 1 + (1000, 0))).max() < 0.2


def field_lists(folder, room):
    """Write targets of the room, and where they were surveyed: 1000 m farther east."""
    places = np.array([[1, 1, 0.3], [7, 1.5, 2.2], [6, 5, 1.1], [1.5, 5, 1.9], [4, 1, 0.8]]) + CORNER
    targets, control = folder / f"{Path(room).stem}.txt", folder / "control.txt"
    np.savetxt(targets, places, "%.4f")
    np.savetxt(control, places + (1000, 0, 0), "%.4f")
    return targets, control
