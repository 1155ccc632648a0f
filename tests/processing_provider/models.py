"""Models of Processing, as the model designer makes them."""


def files(name):
    """Return an input of a model that takes several files."""
    from qgis.core import QgsProcessing, QgsProcessingParameterMultipleLayers

    return QgsProcessingParameterMultipleLayers(name, name, QgsProcessing.SourceType.TypeFile)


def build_model(inputs, steps, result):
    """Return a model that chains algorithms of the plugin.

    Parameters
    ----------
    inputs : list of QgsProcessingParameterDefinition
    steps : dict of str to dict
        What the parameters of each algorithm get: the name of an input, an algorithm and one of its
        outputs, or a number.
    result : tuple of str
        The algorithm and its output that is the only one of the model.
    """
    from qgis.core import (
        QgsProcessingModelAlgorithm,
        QgsProcessingModelChildAlgorithm,
        QgsProcessingModelOutput,
        QgsProcessingModelParameter,
    )

    model = QgsProcessingModelAlgorithm("chain", "chain")
    for item in inputs:
        model.addModelParameter(item, QgsProcessingModelParameter(item.name()))
    output = QgsProcessingModelOutput("result", "result")
    output.setChildId(result[0])
    output.setChildOutputName(result[1])
    for name, given in steps.items():
        child = QgsProcessingModelChildAlgorithm(f"ichnograph:{name}")
        child.setChildId(name)
        for parameter, value in given.items():
            child.addParameterSources(parameter, [_source(value)])
        child.setModelOutputs({"result": output} if name == result[0] else {})
        model.addChildAlgorithm(child)
    return model


def _source(value):
    from qgis.core import QgsProcessingModelChildParameterSource as Source

    if isinstance(value, str):
        return Source.fromModelParameter(value)
    return Source.fromChildOutput(*value) if isinstance(value, tuple) else Source.fromStaticValue(value)


def destination(model):
    """Return the name of the model's one output: 3.22 and 3.40 build it differently."""
    (definition,) = model.destinationParameterDefinitions()
    return definition.name()
