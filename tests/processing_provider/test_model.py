"""The algorithms chained in a model, as the model designer stores them."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.tests.processing_provider.room import CORNER


@pytest.fixture
def model(provider):
    from qgis.core import (
        QgsProcessing,
        QgsProcessingModelAlgorithm,
        QgsProcessingModelChildAlgorithm,
        QgsProcessingModelChildParameterSource,
        QgsProcessingModelOutput,
        QgsProcessingModelParameter,
        QgsProcessingParameterMultipleLayers,
    )

    source = QgsProcessingModelChildParameterSource
    model = QgsProcessingModelAlgorithm("chain", "chain")
    clouds = QgsProcessingParameterMultipleLayers("CLOUDS", "Clouds", QgsProcessing.SourceType.TypeFile)
    model.addModelParameter(clouds, QgsProcessingModelParameter("CLOUDS"))

    def add(name, given, **settings):
        child = QgsProcessingModelChildAlgorithm(f"ichnograph:{name}")
        child.setChildId(name)
        child.addParameterSources("INPUT", [given])
        # As the designer does, every default is stored.
        numbers = [
            item for item in provider.algorithm(name).parameterDefinitions() if item.type() == "number"
        ]
        for item in numbers:
            value = settings.get(item.name(), item.defaultValue())
            child.addParameterSources(item.name(), [source.fromStaticValue(value)])
        return child

    walls = QgsProcessingModelOutput("walls", "walls")
    walls.setChildOutputName("WALLS")
    walls.setChildId("extractwalls")
    last = add("extractwalls", source.fromChildOutput("densityimage", "DENSITY"), MIN_HEIGHT=0.5)
    last.setModelOutputs({"walls": walls})
    model.addChildAlgorithm(add("thincloud", source.fromModelParameter("CLOUDS"), SPACING=0.04))
    model.addChildAlgorithm(add("densityimage", source.fromChildOutput("thincloud", "OUTPUT")))
    model.addChildAlgorithm(last)
    return model


def destination(model):
    """Return the name of the model's one output: 3.22 and 3.40 build it differently."""
    (definition,) = model.destinationParameterDefinitions()
    return definition.name()


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
    from qgis.core import (
        QgsProcessing,
        QgsProcessingModelAlgorithm,
        QgsProcessingModelChildAlgorithm,
        QgsProcessingModelChildParameterSource,
        QgsProcessingModelOutput,
        QgsProcessingModelParameter,
        QgsProcessingParameterFile,
        QgsProcessingParameterMultipleLayers,
    )

    source = QgsProcessingModelChildParameterSource
    model = QgsProcessingModelAlgorithm("field to plan", "field to plan")
    files = QgsProcessing.SourceType.TypeFile
    for parameter in (
        QgsProcessingParameterMultipleLayers("CLOUDS", "Clouds", files),
        QgsProcessingParameterFile("CONTROL", "Control points"),
        QgsProcessingParameterMultipleLayers("TARGETS", "Targets", files),
    ):
        model.addModelParameter(parameter, QgsProcessingModelParameter(parameter.name()))

    def add(name, outputs=None, **sources):
        child = QgsProcessingModelChildAlgorithm(f"ichnograph:{name}")
        child.setChildId(name)
        for parameter, given in sources.items():
            child.addParameterSources(parameter, [given])
        child.setModelOutputs(outputs or {})
        model.addChildAlgorithm(child)

    given = source.fromModelParameter
    add("registerscans", CONTROL=given("CONTROL"), TARGETS=given("TARGETS"))
    transforms = source.fromChildOutput("registerscans", "TRANSFORMS")
    add("transformcloud", INPUT=given("CLOUDS"), TRANSFORMS=transforms)
    walls = QgsProcessingModelOutput("walls", "walls")
    walls.setChildOutputName("WALLS")
    walls.setChildId("siteplan")
    add("siteplan", {"walls": walls}, INPUT=source.fromChildOutput("transformcloud", handed_on))
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
