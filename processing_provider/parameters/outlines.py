"""Parameters that are layers of outlines: files, layers of the project, and outputs of a model."""

# ruff: noqa: D102 - an override is described at the method or property that it overrides.

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

from qgis.core import (
    QgsFeature,
    QgsGeometry,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterVectorLayer,
    QgsProject,
    QgsProviderRegistry,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ...algorithms.errors import InputError
from ...algorithms.shapefile import refuse_damaged
from .parameter import Parameter

if TYPE_CHECKING:
    from ...algorithms.evaluation.reference import Reference

POLYGONS = QgsProcessing.SourceType.TypeVectorPolygon
LINES = QgsProcessing.SourceType.TypeVectorLine


@dataclass(frozen=True)
class OutlineLayer(Parameter):
    """A layer of polygons; None if it is optional and not given."""

    optional: bool = False

    def _definition(self) -> QgsProcessingParameterVectorLayer:
        kinds = self._kinds()
        return QgsProcessingParameterVectorLayer(self.name, self.description, kinds, None, self.optional)

    def _kinds(self) -> list[QgsProcessing.SourceType]:
        return [POLYGONS]

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Any:
        if self.optional and not algorithm.parameterAsString(parameters, self.name, context).strip():
            return None
        layer = self._layer(algorithm, parameters, context)
        try:
            return self._read(layer, f"{self.name} {layer.name()}")
        finally:
            _close(layer)

    def _layer(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> QgsVectorLayer:
        layer = algorithm.parameterAsVectorLayer(parameters, self.name, context)
        if layer is None or not layer.isValid():
            text = algorithm.parameterAsString(parameters, self.name, context).strip()
            given = f"{self.name} {text} cannot be read" if text else f"{self.name} is empty"
            raise InputError(f"{given}; choose a layer of polygons.")
        refuse_damaged(Path(file_of(layer) or ""))
        return layer

    def _read(self, layer: QgsVectorLayer, source: str) -> Any:
        from ...algorithms.evaluation.outlines import outlines_of

        return outlines_of(source, _geometries(layer), layer.crs().toWkt(), file_of(layer))

    def sources(self, value: Any) -> list[str]:
        return [value.path] if value and value.path else []


@dataclass(frozen=True)
class ReferenceLayer(OutlineLayer):
    """A layer of polygons or lines, or a plan drawn by hand, which has both."""

    def _kinds(self) -> list[QgsProcessing.SourceType]:
        return [POLYGONS, LINES]

    def _read(self, layer: QgsVectorLayer, source: str) -> "Reference":
        from ...algorithms.evaluation.reference import Reference, drawn_reference

        if layer.fields().indexOf("kind") >= 0:
            whole = _whole(layer)
            try:
                features = [(straight(item), item.attributeMap()) for item in whole.getFeatures()]
                drawn = drawn_reference(source, features, _wkt(whole), file_of(layer))
            finally:
                if whole is not layer:
                    _close(whole)
            if drawn:
                return drawn
        return Reference(super()._read(layer, source), None)

    def sources(self, value: Any) -> list[str]:
        return super().sources(value.outlines)


def _whole(layer: QgsVectorLayer) -> QgsVectorLayer:
    """Return the layer of all kinds of geometry, which QGIS divides when it loads a file."""
    parts = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    if not parts.pop("geometryType", None):
        return layer
    source = QgsProviderRegistry.instance().encodeUri(layer.providerType(), parts)
    return QgsVectorLayer(source, layer.name(), layer.providerType())


def _close(layer: QgsVectorLayer) -> None:
    """Close the file of a layer that was loaded for this run.

    QGIS keeps it open until its event loop runs, which scripts do not have.
    """
    if QgsProject.instance().mapLayer(layer.id()) is None:
        layer.dataProvider().reloadData()


def _wkt(layer: QgsVectorLayer) -> str:
    """Return the coordinate reference system; empty for GeoJSON in metres, which QGIS takes for degrees."""
    is_json = layer.dataProvider().storageType() == "GeoJSON"
    return "" if is_json and layer.crs().isGeographic() else layer.crs().toWkt()


def file_of(layer: QgsVectorLayer) -> Optional[str]:
    """Return the file of a layer; None for layers without a file."""
    return QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source()).get("path") or None


def _geometries(layer: QgsVectorLayer) -> Iterator[Optional[bytes]]:
    """Yield the geometries of the features that pass the filter of the layer, with its edits, as WKB."""
    for feature in layer.getFeatures():
        yield straight(feature)


def straight(feature: QgsFeature) -> Optional[bytes]:
    """Return the geometry of a feature as WKB, with lines for arcs; None without one."""
    geometry = feature.geometry()
    if geometry.isNull():
        return None
    if QgsWkbTypes.isCurvedType(geometry.wkbType()):
        # Drawings have arcs, which shapely cannot read.
        geometry = QgsGeometry(geometry.constGet().segmentize())
    return geometry.asWkb().data()
