"""The models that the provider ships, in the language of QGIS; their ids are the same in all languages."""

# ruff: noqa: D102, N802 - QGIS defines and names the methods.

import re
from html import escape, unescape
from pathlib import Path

from qgis.core import QgsProcessingModelAlgorithm, QgsXmlUtils
from qgis.PyQt.QtXml import QDomDocument

from .language import translated

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

    def displayName(self) -> str:
        return translated(self.name())

    def createInstance(self) -> "Model":
        return Model(self._path)


def _translated(found: "re.Match[str]") -> str:
    return found[1] + escape(translated(unescape(found[2])))
