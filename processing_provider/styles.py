"""The styles of the outputs: saved beside the file, and set on the layer that QGIS loads."""

import re
from functools import partial
from html import escape, unescape
from pathlib import Path
from string import Template
from typing import Any, Callable, ClassVar, Optional

from qgis.core import (
    QgsLayerTree,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtXml import QDomDocument
from qgis.utils import iface

from .fields import aliases_of, digits_of
from .language import translated

STYLES = Path(__file__).parent / "styles"

MARK = "<!-- made by Ichnograph -->"
"""Marks the styles that are written here; it is gone once a user saves the style in QGIS."""

LABEL = re.compile(r'(?<= label=")[^"]*')
"""What a legend shows."""

MARGIN = 1.1
"""The canvas opens on this many times the extent of the layer that it opens on."""

STRETCH = 2.0
"""The grey values span this many standard deviations of the band on either side of its mean."""


def style_of(name: str, file: Path, values: dict[str, Any]) -> str:
    """Return the style `name` as QML for the layer in `file`.

    Variables of the style, like $name, get their values from `values` or from the file.
    """
    style = (STYLES / f"{name}.qml").read_text(encoding="utf-8")
    measured = next((measure(file) for variable, measure in MEASURES.items() if variable in style), {})
    text = Template(style).substitute({**values, **measured})
    text = LABEL.sub(lambda found: escape(translated(unescape(found[0]))), text)
    fields = _fields(file)
    return text.replace("</qgis>", f"{digits_of(fields)}{aliases_of(fields)}</qgis>")


def _fields(file: Path) -> list[str]:
    """Return the names of the fields of a vector layer; a raster has none."""
    if file.suffix in (".tif", ".tiff"):
        return []
    return list(_features(file).fields().names())


def _features(file: Path) -> QgsVectorLayer:
    options = QgsVectorLayer.LayerOptions()
    options.loadDefaultStyle = False
    return QgsVectorLayer(str(file), "", "ogr", options)


def _ground(file: Path) -> dict[str, float]:
    """Return the lowest base of walls, from which they rise on a terrain whose heights are not theirs."""
    layer = _features(file)
    lowest = layer.minimumValue(layer.fields().lookupField("z_base"))
    return {"ground": lowest if isinstance(lowest, float) else 0.0}


def _stretch(file: Path) -> dict[str, float]:
    """Return the lowest and the highest value of a raster that its grey values span."""
    options = QgsRasterLayer.LayerOptions()
    options.loadDefaultStyle = False
    layer = QgsRasterLayer(str(file), "", "gdal", options)
    band = layer.dataProvider().bandStatistics(1)
    return {
        "minimum": max(band.minimumValue, band.mean - STRETCH * band.stdDev),
        "maximum": min(band.maximumValue, band.mean + STRETCH * band.stdDev),
    }


MEASURES: dict[str, Callable[[Path], dict[str, float]]] = {"$minimum": _stretch, "$ground": _ground}
"""A variable of a style, and what finds its value, and those of its companions, in the file."""


def show_when_loaded(
    styles: dict[Path, Optional[str]], focus: list[str], context: QgsProcessingContext
) -> None:
    """Let QGIS style the layers that it loads after the run, and put the last one on top.

    Parameters
    ----------
    styles : dict of Path to str
        Styles of the layers as QML, or None.
    focus : list of str
        The files that the canvas of an empty project opens on.
    context : QgsProcessingContext
        Lists the layers that will be loaded.
    """
    loaded: dict[str, Optional[str]] = {}
    for level, (path, style) in enumerate(styles.items()):
        if context.willLoadLayerOnCompletion(str(path)):
            details = context.layerToLoadOnCompletionDetails(str(path))
            # From QGIS 3.32 on, layers are sorted by this key after they were styled.
            details.layerSortKey = level
            loaded[str(path)] = None
            details.setPostProcessor(Presenter(str(path), style, loaded, str(path) in focus))


class Presenter(QgsProcessingLayerPostProcessorInterface):
    """Styles a layer that Processing has loaded, and moves it in the layer tree.

    Parameters
    ----------
    path : str
        The file.
    style : str or None
        As QML; without one the layer is shown as QGIS shows it.
    loaded : dict of str to str
        The files of the run, bottom to top, and the ids of their layers; shared by all presenters of the run.
    focus : bool
        Whether the canvas opens on it.
    """

    # QGIS keeps a reference that Python does not see; without this one, presenters would be deleted.
    waiting: ClassVar[list["Presenter"]] = []

    def __init__(
        self, path: str, style: Optional[str], loaded: dict[str, Optional[str]], focus: bool
    ) -> None:
        super().__init__()
        self.path, self.style, self.loaded, self.focus = path, style, loaded, focus
        self.waiting.append(self)

    def postProcessLayer(  # noqa: N802 - QGIS's name
        self, layer: QgsMapLayer, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> None:
        """Style and move the layer; QGIS calls this in the main thread."""
        if self.style:
            document = QDomDocument()
            document.setContent(self.style)
            layer.importNamedStyle(document)
            layer.triggerRepaint()
        self.loaded[self.path] = layer.id()
        ours = [layer_id for layer_id in self.loaded.values() if layer_id]
        _stack(context.project().layerTreeRoot(), ours)
        if self.focus and iface and len(context.project().mapLayers()) <= len(self.loaded):
            # QGIS zooms to all layers once the first ones are in the canvas, which is after this.
            QTimer.singleShot(0, partial(_open_on, layer.id(), context.project()))


def _open_on(layer_id: str, project: QgsProject) -> None:
    """Zoom the canvas to a layer, unless it was removed."""
    canvas, layer = iface.mapCanvas(), project.mapLayer(layer_id)
    if not layer:
        return
    extent = canvas.mapSettings().layerExtentToOutputExtent(layer, layer.extent())
    extent.scale(MARGIN)
    canvas.setExtent(extent)
    canvas.refresh()


def _stack(tree: QgsLayerTree, layer_ids: list[str]) -> None:
    """Put the last layer on top if all are in one group of the layer tree."""
    nodes = [node for node in map(tree.findLayer, reversed(layer_ids)) if node]
    groups = [node.parent() for node in nodes]
    if not nodes or groups.count(groups[0]) < len(groups):
        return
    siblings = groups[0].children()
    positions = [siblings.index(node) for node in nodes]
    if positions != sorted(positions):
        groups[0].insertChildNodes(min(positions), [node.clone() for node in nodes])
        for node in nodes:
            groups[0].removeChildNode(node)
