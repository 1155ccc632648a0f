"""Parameters that are layers of outlines: files, layers of the project, and outputs of a model."""

# ruff: noqa: D102 - an override is described at the method or property that it overrides.

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

from qgis.core import (
    QgsFeature,
    QgsGeometry,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterVectorLayer,
    QgsProviderRegistry,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ...algorithms.errors import InputError
from .parameter import Parameter

if TYPE_CHECKING:
    from ...algorithms.evaluation.outlines import Outlines

POLYGONS = QgsProcessing.SourceType.TypeVectorPolygon
LINES = QgsProcessing.SourceType.TypeVectorLine


@dataclass(frozen=True)
class OutlineLayer(Parameter):
    """A layer of polygons, or with `lines` one of polygons or lines."""

    lines: bool = False

    def _definition(self) -> QgsProcessingParameterVectorLayer:
        kinds = [POLYGONS, LINES] if self.lines else [POLYGONS]
        return QgsProcessingParameterVectorLayer(self.name, self.description, kinds)

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> "Outlines":
        from ...algorithms.evaluation.outlines import outlines_of

        layer = algorithm.parameterAsVectorLayer(parameters, self.name, context)
        if layer is None or not layer.isValid():
            text = algorithm.parameterAsString(parameters, self.name, context).strip()
            given = f"{self.name} {text} cannot be read" if text else f"{self.name} is empty"
            raise InputError(f"{given}; choose a layer of polygons.")
        return outlines_of(
            f"{self.name} {layer.name()}", _geometries(layer), layer.crs().toWkt(), _file(layer)
        )

    def sources(self, value: Any) -> list[str]:
        return [value.path] if value.path else []


def _file(layer: QgsVectorLayer) -> Optional[str]:
    """Return the file of a layer; None for layers without a file."""
    return QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source()).get("path") or None


def _geometries(layer: QgsVectorLayer) -> Iterator[Optional[bytes]]:
    """Yield the geometries of the features that pass the filter of the layer, with its edits, as WKB."""
    for feature in layer.getFeatures():
        yield _straight(feature)


def _straight(feature: QgsFeature) -> Optional[bytes]:
    geometry = feature.geometry()
    if geometry.isNull():
        return None
    if QgsWkbTypes.isCurvedType(geometry.wkbType()):
        # Drawings have arcs, which shapely cannot read.
        geometry = QgsGeometry(geometry.constGet().segmentize())
    return geometry.asWkb().data()
