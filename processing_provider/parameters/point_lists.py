"""Parameters that are lists of points: text files, layer files, and layers of the project."""

# ruff: noqa: D102 - what overrides a method or property is described where that is.

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, TypeVar, Union

from qgis.core import (
    NULL,
    QgsFeature,
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingUtils,
    QgsProperty,
    QgsProviderRegistry,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QFile

from ...algorithms.errors import InputError
from ...algorithms.shapefile import refuse_damaged
from .definitions import FileListDefinition, PointListDefinition
from .files import CLOUD_FILTER, in_folder, split_paths
from .parameter import Parameter

if TYPE_CHECKING:
    from ...algorithms.registration.lists.point_list import PointList

Item = Union[QgsMapLayer, str]
"""A layer, or a path to a file."""

Definition = TypeVar("Definition", PointListDefinition, FileListDefinition)

Coordinates = tuple[float, ...]
"""Two or three coordinates."""

POINTS = QgsProcessing.SourceType.TypeVectorPoint

LIST_FILTER = "Lists of points (*.txt *.csv *.xyz *.asc *.pts *.gpkg *.shp *.geojson)"

TARGET_FILTER = f"{LIST_FILTER};;{CLOUD_FILTER}"


@dataclass(frozen=True)
class PointListFile(Parameter):
    """One list of points.

    Its definition asks for a vector layer, because then the dialog offers the layers of the project and a
    file chooser, which accepts text files too. Without a list, it is None if it is optional.

    Attributes
    ----------
    optional : bool
    planned : bool
        Whether points may be planned rather than surveyed, and so at whole metres.
    """

    optional: bool = False
    planned: bool = False

    def _definition(self) -> PointListDefinition:
        definition = PointListDefinition(self.name, self.description, LIST_FILTER)
        return optional(definition) if self.optional else definition

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> "Optional[PointList]":
        items = _items(parameters.get(self.name), context)
        if not items and self.optional:
            return None
        if not items:
            raise InputError(f"{self.name} is empty; choose a text file or a layer of points.")
        if len(items) > 1:
            raise InputError(f"{self.name} takes one list of points, not {len(items)}; choose one.")
        return _read(items[0], self.planned)

    def sources(self, value: "Optional[PointList]") -> list[str]:
        return [str(value.path)] if value and value.path else []


@dataclass(frozen=True)
class TargetFiles:
    """Lists of targets, and scans in which targets are still to be found.

    Attributes
    ----------
    lists : list of PointList
    clouds : list of str
        Paths of scans without a list of their name.
    scans : list of str
        Paths of all scans that were given.
    """

    lists: "list[PointList]"
    clouds: list[str]
    scans: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class TargetListFiles(Parameter):
    """One list of targets for each scan, or the scan itself, each with a name of its own; maybe none."""

    def _definition(self) -> FileListDefinition:
        return optional(FileListDefinition(self.name, self.description, POINTS, TARGET_FILTER))

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> TargetFiles:
        from ...algorithms.registration.lists.point_list import is_cloud
        from ...algorithms.registration.lists.scan_names import has_list, lists_beside

        items: list[Item] = []
        for item in _items(parameters.get(self.name), context):
            found = in_folder(item) if isinstance(item, str) else [item]
            items += found if found == [item] else [*lists_beside(found), *found]
        clouds = [item for item in items if isinstance(item, str) and is_cloud(item)]
        lists = [_read(item) for item in items if item not in clouds]
        names = [points.name for points in lists]
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None:
            raise InputError(f"{self.name} has two lists called {twice}; remove or rename one of them.")
        return TargetFiles(lists, [path for path in clouds if not has_list(names, Path(path))], clouds)

    def sources(self, value: TargetFiles) -> list[str]:
        return [*(str(points.path) for points in value.lists if points.path), *value.clouds]


def optional(definition: Definition) -> Definition:
    """Return a definition that may be left empty."""
    definition.setFlags(definition.flags() | QgsProcessingParameterDefinition.Flag.FlagOptional)
    return definition


def _items(given: Any, context: QgsProcessingContext) -> list[Item]:
    """Return layers and paths from any spelling of dialogs, scripts, models and shells."""
    if isinstance(given, QgsProperty):
        given, _ = given.value(context.expressionContext())
    if isinstance(given, QgsMapLayer):
        return [given]
    if isinstance(given, (list, tuple)):
        return [item for part in given for item in _items(part, context)]
    return [_layer_or_path(part, context) for part in split_paths(str(given))] if given else []


def _layer_or_path(text: str, context: QgsProcessingContext) -> Item:
    loading = False
    layer = None if QFile.exists(text) else QgsProcessingUtils.mapLayerFromString(text, context, loading)
    return layer or text


def _read(item: Item, planned: bool = False) -> "PointList":
    from ...algorithms.registration.lists.point_list import points_of_features, read_point_list
    from ...algorithms.registration.lists.settings import ListSettings

    settings = ListSettings(coarsest_step_m=math.inf) if planned else ListSettings()
    if isinstance(item, str):
        file, _, layer = item.partition("|layername=")
        return read_point_list(file, layer or None, settings)
    if not isinstance(item, QgsVectorLayer) or item.geometryType() != QgsWkbTypes.GeometryType.PointGeometry:
        raise InputError(f"{item.name()} is not a layer of points; choose another.")
    if not item.isValid():
        raise InputError(
            f"The file of the layer {item.name()} is missing; repair the layer or choose another."
        )
    path, name = _origin(item)
    source, wkt = f"the layer {item.name()}", item.crs().toWkt()
    return points_of_features(name, source, _features(item), wkt, path, settings)


def _origin(layer: QgsVectorLayer) -> tuple[Optional[Path], str]:
    """Return the file of a layer, None without a file, and the name of its list."""
    from ...algorithms.registration.lists.point_layer import list_name

    provider = layer.providerType()
    parts = QgsProviderRegistry.instance().decodeUri(provider, layer.source())
    path = Path(parts["path"]) if parts.get("path") else None
    if path is None or not path.is_file():
        return None, layer.name()
    refuse_damaged(path)
    return path, list_name(path, parts.get("layerName")) if provider == "ogr" else path.stem


def _features(layer: QgsVectorLayer) -> Iterator[tuple[Optional[Coordinates], dict[str, Any]]]:
    """Yield coordinates and attributes of the features that the layer shows, edits included."""
    fields = layer.fields().names()
    for feature in layer.getFeatures():
        values = [None if value == NULL else value for value in feature.attributes()]
        yield _coordinates(feature), dict(zip(fields, values))


def _coordinates(feature: QgsFeature) -> Optional[Coordinates]:
    geometry = feature.geometry().constGet()
    if geometry is not None and QgsWkbTypes.isMultiType(geometry.wkbType()) and geometry.numGeometries() == 1:
        geometry = geometry.geometryN(0)
    if geometry is None or QgsWkbTypes.flatType(geometry.wkbType()) != QgsWkbTypes.Type.Point:
        return None
    heights = (geometry.z(),) if geometry.is3D() else ()
    return (geometry.x(), geometry.y(), *heights)
