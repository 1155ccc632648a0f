"""Parameters that are files, as dialogs, scripts, models and command lines name them."""

# ruff: noqa: D102 - an override is described at the method or property that it overrides.

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFile,
    QgsProcessingParameterRasterLayer,
    QgsProcessingUtils,
    QgsProperty,
)
from qgis.PyQt.QtCore import QFile

from ...algorithms.clouds.formats import FORMATS
from ...algorithms.errors import InputError
from .definitions import FileListDefinition
from .parameter import Parameter, marked

CLOUD_FILTER = f"Point clouds ({' '.join(f'*{item.extension}' for item in FORMATS)})"


@dataclass(frozen=True)
class CloudFiles(Parameter):
    """One or more point cloud files; none too if they are optional, as among the advanced parameters."""

    optional: bool = False

    def _definition(self) -> FileListDefinition:
        files = QgsProcessing.SourceType.TypeFile
        definition = FileListDefinition(self.name, self.description, files, CLOUD_FILTER)
        if self.optional:
            definition.setFlags(definition.flags() | QgsProcessingParameterDefinition.Flag.FlagOptional)
            return marked(definition)
        return definition

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> list[str]:
        given = _files(parameters.get(self.name), context)
        if not given and not self.optional:
            raise InputError(f"{self.name} is empty; choose at least one point cloud file.")
        return [path for item in given for path in in_folder(item)]

    def sources(self, value: Any) -> list[str]:
        return value


@dataclass(frozen=True)
class RasterFile(Parameter):
    """A raster, from a file or a loaded layer."""

    def _definition(self) -> QgsProcessingParameterRasterLayer:
        return QgsProcessingParameterRasterLayer(self.name, self.description)

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> str:
        given = parameters.get(self.name)
        if isinstance(given, QgsMapLayer):
            return given.source()
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if not text:
            raise InputError(f"{self.name} is empty; choose a raster.")
        return _source(text, context)

    def sources(self, value: Any) -> list[str]:
        return [value]


@dataclass(frozen=True)
class PlainFile(Parameter):
    """A file that is not a layer; a subclass sets its kind."""

    kind = ""

    def _definition(self) -> QgsProcessingParameterFile:
        files = f"{self.kind.upper()} files (*.{self.kind});;All files (*)"
        return QgsProcessingParameterFile(self.name, self.description, fileFilter=files)

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> str:
        path = algorithm.parameterAsFile(parameters, self.name, context).strip()
        if not path:
            raise InputError(f"{self.name} is empty; choose a {self.kind} file.")
        return path

    def sources(self, value: Any) -> list[str]:
        return [value]


@dataclass(frozen=True)
class JsonFile(PlainFile):
    """A JSON file."""

    kind = "json"


@dataclass(frozen=True)
class TableFile(PlainFile):
    """A table."""

    kind = "csv"


def _files(given: Any, context: QgsProcessingContext) -> list[str]:
    """Return the paths in any form that dialogs, scripts, models and command lines use."""
    if isinstance(given, QgsProperty):
        given, _ = given.value(context.expressionContext())
    if isinstance(given, QgsMapLayer):
        return [given.source()]
    if isinstance(given, (list, tuple)):
        return [path for item in given for path in _files(item, context)]
    return [_source(path, context) for path in split_paths(str(given))] if given else []


def in_folder(path: str) -> list[str]:
    """Return the clouds in a folder that another algorithm may have written, or the path itself."""
    if not Path(path).is_dir():
        return [path]
    from ...algorithms.clouds.cloud import clouds_in

    return [str(cloud) for cloud in clouds_in(Path(path))]


def split_paths(text: str) -> list[str]:
    """Return the paths in a text; semicolons or line ends separate several."""
    if QFile.exists(text):
        return [text]
    return [part.strip() for part in text.replace("\n", ";").split(";") if part.strip()]


def _source(text: str, context: QgsProcessingContext) -> str:
    """Return the path of a file that is named by its path, or by the id or name of a loaded layer."""
    loading = False
    layer = None if QFile.exists(text) else QgsProcessingUtils.mapLayerFromString(text, context, loading)
    return layer.source() if layer else text
