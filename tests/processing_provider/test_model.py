"""The algorithms chained in a model, as the model designer stores them."""

import pytest


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
