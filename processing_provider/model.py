"""The models that the provider ships, in the language of QGIS; their ids are the same in all languages."""

# ruff: noqa: D102, N802 - QGIS defines and names the methods.

import re
from html import escape, unescape
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelParameter,
    QgsProcessingParameterDefinition,
    QgsXmlUtils,
)
from qgis.PyQt.QtXml import QDomDocument

from .help import help_page
from .language import translated
from .manual import page_url
from .parameters.definitions import list_of_files
from .skipped_outputs import with_skipped

SHOWN = re.compile(r'( name="(?:ALG_DESC|component_description|description|model_group)" value=")([^"]*)')
"""What people read of a model file, besides its name, which is its id too."""


class Model(QgsProcessingModelAlgorithm):
    """A model of the provider.

    Parameters
    ----------
    path : Path
        The .model3 file.
    """

    def __init__(self, path: Path) -> None:
        super().__init__()
        self._path = path
        document = QDomDocument()
        document.setContent(SHOWN.sub(_translated, path.read_text(encoding="utf-8")))
        self.loadVariant(QgsXmlUtils.readVariant(document.documentElement()))
        for name in [item.parameterName() for item in self.orderedParameters()]:
            self._add_again(name)

    def displayName(self) -> str:
        return translated(self.name())

    def shortHelpString(self) -> str:
        inputs = [item for item in self.parameterDefinitions() if not item.isDestination()]
        outputs = self.destinationParameterDefinitions()
        sections = {"Parameters": map(_entry, inputs), "Outputs": map(_entry, outputs)}
        return help_page(self.helpContent()["ALG_DESC"], sections)

    def helpUrl(self) -> str:
        return page_url("models")

    def createInstance(self) -> "Model":
        return Model(self._path)

    def preprocessParameters(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return with_skipped(self, parameters)

    def asPythonCommand(self, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
        # The history would lose it, because QGIS takes a model without a file for one that was not saved.
        return str(QgsProcessingAlgorithm.asPythonCommand(self, parameters, context))

    def _add_again(self, name: str) -> None:
        """Move an input behind the others, so that all are in order; lists of files become those of ours."""
        shown = QgsProcessingModelParameter(self.parameterComponents()[name])
        definition = list_of_files(self.parameterDefinition(name))
        definition.setHelp(translated(self.helpContent().get(name, "")))
        self.removeModelParameter(name)
        self.addModelParameter(definition, shown)


def _entry(definition: QgsProcessingParameterDefinition) -> tuple[str, str]:
    return definition.description(), definition.help()


def _translated(found: "re.Match[str]") -> str:
    return found[1] + escape(translated(unescape(found[2])))
