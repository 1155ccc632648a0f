"""Definitions of files that are not layers, which QGIS would lose in history, batches and repeated runs.

QGIS 3.22 opens every item of a list as a layer, and drops what it cannot open, such as a LAZ file or a list
of points. These definitions take files and layers as they are given; the parameters read and check them.
"""

# ruff: noqa: D102, N802 - QGIS defines and names the methods.

from typing import Any, Optional, Union

from qgis.core import (
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterVectorLayer,
    QgsProperty,
)

from ..language import translated

ALL_FILES = "All files (*)"

WIDGETS = f"{__name__.rpartition('.')[0]}.widgets"
"""The module of the widgets, which QGIS imports on the desktop only."""


class _FilesDefinition:
    """What a parameter of files has in common: filters in its chooser, and values that history keeps."""

    filters: str

    def createFileFilter(self) -> str:
        return f"{translated(self.filters)};;{translated(ALL_FILES)}"

    def checkValueIsAcceptable(self, value: Any, context: Optional[QgsProcessingContext] = None) -> bool:
        optional = QgsProcessingParameterDefinition.Flag.FlagOptional
        return bool(value) or bool(self.flags() & optional)  # type: ignore[attr-defined]

    def valueAsPythonString(self, value: Any, context: QgsProcessingContext) -> str:
        return _literal(value)

    # QGIS asks these for the history since 3.24, and would open every file as a layer of each kind.

    def valueAsJsonObject(self, value: Any, context: QgsProcessingContext) -> Any:
        return _plain(value)

    def valueAsString(self, value: Any, context: QgsProcessingContext) -> tuple[str, bool]:
        plain = _plain(value)
        return (";".join(plain) if isinstance(plain, list) else plain or ""), True

    def valueAsStringList(self, value: Any, context: QgsProcessingContext) -> tuple[list[str], bool]:
        plain = _plain(value)
        return (plain if isinstance(plain, list) else [plain or ""]), True


class FileListDefinition(_FilesDefinition, QgsProcessingParameterMultipleLayers):
    """Files, and layers of the project if `kind` is not the one of files.

    Parameters
    ----------
    name, description : str
    kind : QgsProcessing.SourceType
    filters : str
        What the file chooser offers, as `LAZ files (*.laz);;LAS files (*.las)`.
    """

    def __init__(self, name: str, description: str, kind: QgsProcessing.SourceType, filters: str) -> None:
        super().__init__(name, description, kind)
        self.filters = filters
        self.setMetadata({"widget_wrapper": {"class": f"{WIDGETS}.FileListWrapper"}})

    def clone(self) -> QgsProcessingParameterDefinition:
        return _copy_of(self, FileListDefinition(self.name(), "", self.layerType(), self.filters))


class PointListDefinition(_FilesDefinition, QgsProcessingParameterVectorLayer):
    """A layer of points, or a text file."""

    def __init__(self, name: str, description: str, filters: str) -> None:
        super().__init__(name, description, [QgsProcessing.SourceType.TypeVectorPoint])
        self.filters = filters
        self.setMetadata({"widget_wrapper": {"class": f"{WIDGETS}.PointListWrapper"}})

    def clone(self) -> QgsProcessingParameterDefinition:
        return _copy_of(self, PointListDefinition(self.name(), "", self.filters))


def list_of_files(stored: QgsProcessingParameterDefinition) -> QgsProcessingParameterDefinition:
    """Return a copy of an input of a model; if its metadata have filters, it is a `FileListDefinition`."""
    filters = stored.metadata().get("filters")
    if not filters:
        return stored.clone()
    return _copy_of(stored, FileListDefinition(stored.name(), "", stored.layerType(), filters))


def _copy_of(
    definition: QgsProcessingParameterDefinition, copy: QgsProcessingParameterDefinition
) -> QgsProcessingParameterDefinition:
    copy.setDescription(definition.description())
    copy.setHelp(definition.help())
    copy.setFlags(definition.flags())
    copy.setDefaultValue(definition.defaultValue())
    return copy


def _literal(value: Any) -> str:
    """Return a value as Python code: layers by their source, expressions by their text."""
    return repr(_plain(value))


def _plain(value: Any) -> Union[str, list[Any], None]:
    if isinstance(value, QgsMapLayer):
        return value.source()
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, QgsProperty):
        return value.asExpression()
    return None if value is None else str(value)
