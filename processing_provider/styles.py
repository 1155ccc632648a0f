"""The styles of the outputs: beside the file for whoever opens it, and on the layer that QGIS loads."""

from pathlib import Path
from string import Template

from qgis.core import (
    QgsLayerTree,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsRasterLayer,
)
from qgis.PyQt.QtXml import QDomDocument

STYLES = Path(__file__).parent / "styles"

MARK = "<!-- made by Ichnograph -->"
"""In every style that is written here; QGIS leaves it out when a user saves a style."""

STRETCH = 2.0
"""Standard deviations of a band on either side of its mean that the grey values span."""


def style_of(name: str, file: Path, values: dict) -> str:
    """Return the style `name` as QML, for a layer that was written to `file`.

    What the style leaves open, as $name, comes from `values` or, for a raster, from the file.
    """
    style = (STYLES / f"{name}.qml").read_text(encoding="utf-8")
    return Template(style).substitute(values if "$minimum" not in style else _stretch(file))


def _stretch(file: Path) -> dict:
    """Return between which values the grey values of a raster span."""
    options = QgsRasterLayer.LayerOptions()
    options.loadDefaultStyle = False
    layer = QgsRasterLayer(str(file), "", "gdal", options)
    band = layer.dataProvider().bandStatistics(1)
    return {
        "minimum": max(band.minimumValue, band.mean - STRETCH * band.stdDev),
        "maximum": min(band.maximumValue, band.mean + STRETCH * band.stdDev),
    }


def show_when_loaded(styles: dict, context: QgsProcessingContext) -> None:
    """Let QGIS style the layers that it will load when the algorithm is done, the last one on top.

    Parameters
    ----------
    styles : dict of Path to str
        Styles as QML.
    context : QgsProcessingContext
        Knows which layers will be loaded.
    """
    loaded = {}
    for path, style in styles.items():
        if context.willLoadLayerOnCompletion(str(path)):
            details = context.layerToLoadOnCompletionDetails(str(path))
            loaded[str(path)] = None
            details.setPostProcessor(Presenter(str(path), style, loaded))


class Presenter(QgsProcessingLayerPostProcessorInterface):
    """Styles a layer that Processing has loaded, and puts it in its place in the layer tree.

    Parameters
    ----------
    path, style : str
        The file, and its style as QML.
    loaded : dict of str to str
        The files of the run, bottom to top, and the ids of their layers; shared by its presenters.
    """

    # QGIS keeps no reference that Python knows of.
    waiting = []  # noqa: RUF012

    def __init__(self, path: str, style: str, loaded: dict) -> None:
        super().__init__()
        self.path, self.style, self.loaded = path, style, loaded
        self.waiting.append(self)

    def postProcessLayer(self, layer, context, feedback) -> None:  # noqa: N802 - QGIS's name
        """Show the layer; QGIS calls this in the main thread."""
        document = QDomDocument()
        document.setContent(self.style)
        layer.importNamedStyle(document)
        layer.triggerRepaint()
        self.loaded[self.path] = layer.id()
        _stack(context.project().layerTreeRoot(), [layer_id for layer_id in self.loaded.values() if layer_id])


def _stack(tree: QgsLayerTree, layer_ids: list) -> None:
    """Reorder layers that stand in one group of the layer tree, the last one on top."""
    nodes = [node for node in map(tree.findLayer, reversed(layer_ids)) if node]
    groups = [node.parent() for node in nodes]
    if not nodes or groups.count(groups[0]) < len(groups):
        return
    siblings = groups[0].children()
    places = [siblings.index(node) for node in nodes]
    if places != sorted(places):
        groups[0].insertChildNodes(min(places), [node.clone() for node in nodes])
        for node in nodes:
            groups[0].removeChildNode(node)
