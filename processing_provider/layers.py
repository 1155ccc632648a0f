"""Layers as a project shows them: without a system that is not tied to the earth, and never out of date."""

from collections.abc import Iterable

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsDataProvider,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingUtils,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QCoreApplication, QThread


def reopen_layers(paths: Iterable[str], context: QgsProcessingContext) -> None:
    """Show what was written: reopen the layers of the project, and prepare those that QGIS will load.

    Parameters
    ----------
    paths : iterable of str
        The files of layers that a run has written.
    context : QgsProcessingContext
        Of the run.
    """
    # A model runs its steps in the background, where layers of the project must not be touched.
    if QThread.currentThread() != QCoreApplication.instance().thread():
        return
    for path in paths:
        shown = _layers_of(path, context.project())
        for layer in shown:
            _reopen(layer)
        if not context.willLoadLayerOnCompletion(path):
            continue
        details = context.layerToLoadOnCompletionDetails(path)
        if shown:
            # It keeps the style and the position that the user gave it.
            details.setPostProcessor(None)
        else:
            layer = _open(path, details.name)
            if not is_on_earth(layer):
                forget_system(layer)
                # QGIS takes a layer from here before it opens the file, which names a local system.
                context.temporaryLayerStore().addMapLayer(layer)


def is_on_earth(layer: QgsMapLayer) -> bool:
    """Whether a layer has a system that can be transformed into others; local ones cannot."""
    return bool(layer.crs().isValid() and layer.crs().toProj())


def forget_system(layer: QgsMapLayer) -> None:
    """Let a layer be shown as it is, in whatever system the project has."""
    layer.setCrs(QgsCoordinateReferenceSystem())


def _layers_of(path: str, project: QgsProject) -> list[QgsMapLayer]:
    wanted = QgsProcessingUtils.normalizeLayerSource(path)
    layers = project.mapLayers().values() if project else []
    return [
        layer
        for layer in layers
        if QgsProcessingUtils.normalizeLayerSource(layer.source().partition("|")[0]) == wanted
    ]


def _reopen(layer: QgsMapLayer) -> None:
    local = not layer.crs().isValid()
    options = QgsDataProvider.ProviderOptions()
    layer.setDataSource(layer.source(), layer.name(), layer.providerType(), options)
    if local:
        forget_system(layer)
    if isinstance(layer, QgsVectorLayer):
        layer.updateExtents()
    layer.triggerRepaint()


def _open(path: str, name: str) -> QgsMapLayer:
    if path.endswith((".tif", ".tiff")):
        return QgsRasterLayer(path, name)
    return QgsVectorLayer(path, name, "ogr")
