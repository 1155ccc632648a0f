"""Write the models that the provider ships, as the model designer stores them.

make models, or: python3 -m ichnograph.scripts.models
"""

import os
from pathlib import Path
from typing import Any, Union

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
# The order of what Qt writes, which is random otherwise.
os.environ["QT_HASH_SEED"] = "0"

import ichnograph
from ichnograph.processing_provider.parameters.files import CLOUD_FILTER
from ichnograph.processing_provider.parameters.point_lists import TARGET_FILTER
from qgis.core import (
    QgsApplication,
    QgsProcessing,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
)
from qgis.PyQt.QtCore import QPointF

MODELS = Path(__file__).parents[1] / "processing_provider" / "models"
GROUP = "Models"

Value = Union[str, list[str], tuple[str, str], float, int]
"""The name of an input, or of several, a step and one of its outputs, or a number."""


def main() -> None:
    """Write all models."""
    application = QgsApplication([], False)
    application.initQgis()
    plugin = ichnograph.classFactory(None)
    plugin.initProcessing()
    for model in (_site_plan(), _facade(), _storeys()):
        assert model.validate()[0], model.validate()
        model.toFile(str(MODELS / f"{model.name().lower().replace(' ', '_')}.model3"))
    plugin.unload()


def _site_plan() -> QgsProcessingModelAlgorithm:
    return _model(
        "Control points and scans to site plan",
        "Targets are found in the scans, or read from lists. Scans are registered by them, transformed to "
        "the control points, and drawn as a site plan.",
        [
            _helped(
                QgsProcessingParameterFile("CONTROL", "Control points"),
                "Surveyed points in metres: a text file with x y z or name x y z.",
            ),
            _helped(
                _files("SCANS", "Scans; a scan has the name of its list", CLOUD_FILTER),
                "One point cloud for each scan, in the scanner's own frame.",
            ),
            _helped(
                _files(
                    "TARGETS",
                    "Targets, one list for each scan; found in scans without a list",
                    TARGET_FILTER,
                    optional=True,
                ),
                "Targets picked in the scans: text files with the names of the scans. In a scan without a "
                "list, black and white targets and spheres are found.",
            ),
            _helped(
                QgsProcessingParameterCrs("SYSTEM", "Reference system of the control points", optional=True),
                "Such as EPSG:25833. Without it, the plan has no reference system.",
            ),
        ],
        {
            "registerscans": {"CONTROL": "CONTROL", "TARGETS": ["TARGETS", "SCANS"], "CRS": "SYSTEM"},
            "transformcloud": {"INPUT": "SCANS", "TRANSFORMS": ("registerscans", "TRANSFORMS")},
            "siteplan": {"INPUT": ("transformcloud", "CLOUDS")},
        },
        {
            "registerscans": {"REPORT": "Report of the registration"},
            "siteplan": {"WALLS": "Walls", "ROOMS": "Rooms", "REPORT": "Report of the site plan"},
        },
    )


def _facade() -> QgsProcessingModelAlgorithm:
    return _model(
        "Facade to drawing",
        "The details of a facade are measured, drawn, listed, and laid out on a sheet at 1:50.",
        [
            _helped(
                _files("SCANS", "Scans of the facade", CLOUD_FILTER),
                "One or more point clouds of one facade, with colours or intensities.",
            )
        ],
        {
            "facadedetails": {"INPUT": "SCANS"},
            "planlayout": {"WALLS": ("facadedetails", "ELEVATION"), "KIND": 1, "SCALE": 50, "SHEET": 0},
        },
        {
            "facadedetails": {
                "ELEVATION": "Elevation",
                "ORTHOIMAGE": "Orthoimage",
                "SCHEDULE": "Schedule",
                "DRAWING": "Drawing",
            },
            "planlayout": {"PDF": "Sheet as PDF"},
        },
    )


def _storeys() -> QgsProcessingModelAlgorithm:
    number = QgsProcessingParameterNumber.Type.Double
    heights = {
        "SLAB_1": "Height within the slab below the lower storey (m)",
        "SLAB_2": "Height within the slab between the storeys (m)",
        "SLAB_3": "Height within the slab above the upper storey (m)",
    }
    numbers = [
        _helped(
            QgsProcessingParameterNumber(name, label, number),
            "In the coordinates of the scans: between the ceiling below the slab and the floor above it.",
        )
        for name, label in heights.items()
    ]
    return _model(
        "Storeys one by one",
        "Two storeys of a building are drawn from the same scans, each between the slabs around it.",
        [
            _helped(
                _files("SCANS", "Scans", CLOUD_FILTER),
                "One or more point clouds of one building, in one reference system.",
            ),
            *numbers,
        ],
        {
            "siteplan:lower": {"INPUT": "SCANS", "ZMIN": "SLAB_1", "ZMAX": "SLAB_2"},
            "siteplan:upper": {"INPUT": "SCANS", "ZMIN": "SLAB_2", "ZMAX": "SLAB_3"},
        },
        {
            "siteplan:lower": {"WALLS": "Walls of the lower storey", "ROOMS": "Rooms of the lower storey"},
            "siteplan:upper": {"WALLS": "Walls of the upper storey", "ROOMS": "Rooms of the upper storey"},
        },
    )


def _model(
    title: str,
    about: str,
    inputs: list[QgsProcessingParameterDefinition],
    steps: dict[str, dict[str, Value]],
    outputs: dict[str, dict[str, str]],
) -> QgsProcessingModelAlgorithm:
    """Return a model of `steps`, which are algorithms with a name after a colon if one is used twice."""
    model = QgsProcessingModelAlgorithm(title, GROUP)
    # QGIS reads the helps of inputs from here, and not from their definitions.
    model.setHelpContent({"ALG_DESC": about, **{item.name(): item.help() for item in inputs}})
    names = {item.name() for item in inputs}
    model.setParameterOrder([item.name() for item in inputs])
    for row, item in enumerate(inputs):
        shown = QgsProcessingModelParameter(item.name())
        shown.setPosition(QPointF(150, 80 + 100 * row))
        model.addModelParameter(item, shown)
    for column, (step, values) in enumerate(steps.items()):
        model.addChildAlgorithm(_step(column, step, values, outputs.get(step, {}), names))
    return model


def _step(
    column: int, step: str, values: dict[str, Value], outputs: dict[str, str], names: set[str]
) -> QgsProcessingModelChildAlgorithm:
    key = step.partition(":")[0]
    child = QgsProcessingModelChildAlgorithm(f"ichnograph:{key}")
    child.setChildId(step)
    child.setDescription(child.algorithm().displayName())
    child.setPosition(QPointF(450 + 300 * column, 120 + 60 * column))
    for definition in child.algorithm().parameterDefinitions():
        value = values.get(definition.name(), definition.defaultValue())
        if not definition.isDestination() and value is not None:
            several = value if isinstance(value, list) else [value]
            child.addParameterSources(definition.name(), [_source(item, names) for item in several])
    made = {}
    for row, (name, label) in enumerate(outputs.items()):
        output = QgsProcessingModelOutput(label, label)
        output.setChildId(step)
        output.setChildOutputName(name)
        output.setPosition(child.position() + QPointF(0, 100 + 50 * row))
        made[label] = output
    child.setModelOutputs(made)
    return child


def _source(value: Any, names: set[str]) -> QgsProcessingModelChildParameterSource:
    kinds = QgsProcessingModelChildParameterSource
    if isinstance(value, tuple):
        return kinds.fromChildOutput(*value)
    return kinds.fromModelParameter(value) if value in names else kinds.fromStaticValue(value)


def _files(
    name: str, label: str, filters: str, optional: bool = False
) -> QgsProcessingParameterMultipleLayers:
    files = QgsProcessing.SourceType.TypeFile
    definition = QgsProcessingParameterMultipleLayers(name, label, files, optional=optional)
    # QGIS stores these, and no class of ours.
    definition.setMetadata({"filters": filters})
    return definition


def _helped(definition: QgsProcessingParameterDefinition, text: str) -> QgsProcessingParameterDefinition:
    definition.setHelp(text)
    return definition


if __name__ == "__main__":
    main()
