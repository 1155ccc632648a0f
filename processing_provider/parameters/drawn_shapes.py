"""Parameters that are lines and polygons of a layer, which choose something."""

# ruff: noqa: D102 - an override is described at the method that it overrides.

from dataclasses import dataclass
from math import isfinite
from typing import Any, Optional

from qgis.core import (
    QgsFeatureRequest,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingParameterFeatureSource,
)

from ...algorithms.errors import InputError
from .outlines import file_of, straight
from .parameter import Parameter, marked


@dataclass(frozen=True)
class Drawn:
    """Lines and polygons of a layer.

    Attributes
    ----------
    shapes : tuple of shapely geometry
    path : str or None
        The file of the layer; None without a file.
    """

    shapes: tuple[Any, ...] = ()
    path: Optional[str] = None


@dataclass(frozen=True)
class DrawnShapes(Parameter):
    """Optional lines and polygons: a layer, or only its selected features."""

    def _definition(self) -> QgsProcessingParameterFeatureSource:
        kinds = [QgsProcessing.SourceType.TypeVectorLine, QgsProcessing.SourceType.TypeVectorPolygon]
        return marked(QgsProcessingParameterFeatureSource(self.name, self.description, kinds, optional=True))

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Drawn:
        """Return the shapes as those of shapely."""
        if not parameters.get(self.name):
            return Drawn()
        source = algorithm.parameterAsSource(parameters, self.name, context)
        if source is None:
            raise InputError(f"{self.name} {parameters[self.name]} cannot be read; choose another layer.")
        from shapely import wkb
        from shapely.errors import ShapelyError

        # The check of QGIS ends the process if a coordinate is not a number.
        features = source.getFeatures(
            QgsFeatureRequest(), QgsProcessingFeatureSource.Flag.FlagSkipGeometryValidityChecks
        )
        try:
            shapes = [wkb.loads(shape) for feature in features if (shape := straight(feature))]
        except ShapelyError as error:
            raise InputError(
                f"{self.name} has a shape that cannot be read ({error}); correct or remove it."
            ) from error
        shapes = [shape for shape in shapes if not shape.is_empty]
        if not all(isfinite(shape.length) for shape in shapes):
            raise InputError(
                f"{self.name} has a shape whose coordinates are not numbers; correct or remove it."
            )
        if not shapes:
            raise InputError(f"{self.name} has no lines or polygons; draw one, or leave it empty.")
        given = parameters[self.name]
        if isinstance(given, QgsProcessingFeatureSourceDefinition):
            given = given.source
        layer = algorithm.parameterAsVectorLayer({self.name: given}, self.name, context)
        return Drawn(tuple(shapes), file_of(layer) if layer else None)

    def sources(self, value: Drawn) -> list[str]:
        return [value.path] if value.path else []
