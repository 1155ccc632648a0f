"""Outputs that are switched off in a dialog, which the history of QGIS would not know."""

from collections.abc import Mapping
from typing import Any

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterDefinition


def with_skipped(algorithm: QgsProcessingAlgorithm, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the values of a dialog, and None for each output that is switched off.

    The dialog leaves these out, and so does the history; a run that is repeated would make them, because they
    are made by default.
    """
    optional = QgsProcessingParameterDefinition.Flag.FlagOptional
    outputs = algorithm.destinationParameterDefinitions()
    return {**{output.name(): None for output in outputs if output.flags() & optional}, **values}
