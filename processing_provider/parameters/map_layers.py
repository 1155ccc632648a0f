"""Parameters that are layers as the map shows them, with their styles."""

# ruff: noqa: D102 - an override is described at the method that it overrides.

from dataclasses import dataclass
from typing import Any, Optional

from qgis.core import (
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterVectorLayer,
)

from ...algorithms.errors import InputError
from .parameter import Parameter


@dataclass(frozen=True)
class ShownLayer(Parameter):
    """A vector layer of one kind of geometry."""

    kind: QgsProcessing.SourceType
    optional: bool = False

    def _definition(self) -> QgsProcessingParameterVectorLayer:
        return QgsProcessingParameterVectorLayer(
            self.name, self.description, [self.kind], optional=self.optional
        )

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[QgsMapLayer]:
        layer = algorithm.parameterAsVectorLayer(parameters, self.name, context)
        return self._checked(layer, algorithm.parameterAsString(parameters, self.name, context))

    def sources(self, value: Optional[QgsMapLayer]) -> list[str]:
        return [value.source().partition("|")[0]] if value else []

    def _checked(self, layer: Optional[QgsMapLayer], text: str) -> Optional[QgsMapLayer]:
        if layer is not None and layer.isValid():
            return layer
        if text.strip():
            raise InputError(f"{self.name} {text} cannot be read; choose another layer.")
        if not self.optional:
            raise InputError(f"{self.name} is empty; choose a layer.")
        return None


@dataclass(frozen=True)
class ShownRaster(ShownLayer):
    """A raster layer."""

    def _definition(self) -> QgsProcessingParameterRasterLayer:
        return QgsProcessingParameterRasterLayer(self.name, self.description, optional=self.optional)

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[QgsMapLayer]:
        layer = algorithm.parameterAsRasterLayer(parameters, self.name, context)
        return self._checked(layer, algorithm.parameterAsString(parameters, self.name, context))
