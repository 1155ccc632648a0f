"""Widgets of lists of files, and of one list of points; QGIS loads them on the desktop only."""

# ruff: noqa: D102, N802 - QGIS defines and names the methods.

from pathlib import Path
from typing import Any, Callable, ClassVar, Optional

from processing.gui.wrappers import WidgetWrapper
from qgis.core import (
    QgsMapLayerProxyModel,
    QgsProcessingParameterDefinition,
    QgsProject,
    QgsSettings,
)
from qgis.gui import (
    QgsGui,
    QgsMapLayerComboBox,
    QgsProcessingMultipleInputDialog,
)
from qgis.PyQt.QtWidgets import QFileDialog, QHBoxLayout, QLineEdit, QToolButton, QWidget

from ..language import translated

LAST_FOLDER = "/Processing/LastInputPath"
"""Where QGIS keeps the folder of the last input."""


class FileList:
    """How many files are chosen, and a button that opens the list of QGIS."""

    def __init__(self, definition: QgsProcessingParameterDefinition, changed: Callable[[], None]) -> None:
        self._definition, self._changed = definition, changed
        self._chosen: list[str] = []
        self._text = QLineEdit()
        self._text.setReadOnly(True)
        self._text.setPlaceholderText(translated("No files chosen"))

    def widget(self) -> QWidget:
        return _with_button(self._text, self._choose)

    def value(self) -> Optional[list[str]]:
        return list(self._chosen) or None

    def set_value(self, value: Any) -> None:
        listed = value if isinstance(value, (list, tuple)) else [value] if value else []
        self._chosen = [item if isinstance(item, str) else item.source() for item in listed]
        names = [Path(item.partition("|")[0]).name for item in self._chosen]
        count = "1 file" if len(names) == 1 else f"{len(names)} files"
        self._text.setText(f"{translated(count)}: {', '.join(names)}" if names else "")
        self._text.setToolTip("\n".join(self._chosen))
        self._changed()

    def _choose(self) -> None:
        parent = self._text.window()
        dialog = QgsProcessingMultipleInputDialog(self._definition, self._chosen, [], None, parent)
        dialog.setProject(QgsProject.instance())
        if dialog.exec():
            self.set_value(dialog.selectedOptions())


class PointList:
    """The layers of points of the project, and a button that chooses a file."""

    def __init__(self, definition: QgsProcessingParameterDefinition, changed: Callable[[], None]) -> None:
        self._definition, self._changed = definition, changed
        self._layers = QgsMapLayerComboBox()
        self._layers.setFilters(QgsMapLayerProxyModel.Filter.PointLayer)
        self._layers.setAllowEmptyLayer(True)
        self._layers.currentIndexChanged.connect(changed)

    def widget(self) -> QWidget:
        return _with_button(self._layers, self._choose)

    def value(self) -> Optional[str]:
        layer = self._layers.currentLayer()
        return layer.id() if layer else self._layers.currentText() or None

    def set_value(self, value: Any) -> None:
        layer = QgsProject.instance().mapLayer(value) if isinstance(value, str) else value
        text = "" if layer or not value else str(value)
        self._layers.setAdditionalItems([text] if text else [])
        self._layers.setLayer(layer)
        if text:
            self._layers.setCurrentIndex(self._layers.findText(text))

    def _choose(self) -> None:
        settings, filters = QgsSettings(), self._definition.createFileFilter()
        folder, title = settings.value(LAST_FOLDER, ""), self._definition.description()
        path, _ = QFileDialog.getOpenFileName(self._layers.window(), title, folder, filters)
        if path:
            settings.setValue(LAST_FOLDER, str(Path(path).parent))
            self.set_value(path)


class FileListWrapper(WidgetWrapper):
    """Shows a `FileList` in dialogs and batches; in the model designer, what QGIS shows there."""

    kind: ClassVar[type] = FileList

    def __new__(cls, definition: QgsProcessingParameterDefinition, dialog: QWidget, *cell: int) -> Any:
        if hasattr(dialog, "childId"):
            return _of_model_designer(definition, dialog)
        return super().__new__(cls)

    def createWidget(self) -> QWidget:
        self._field = self.kind(self.parameterDefinition(), lambda: self.widgetValueHasChanged.emit(self))
        return self._field.widget()

    def setValue(self, value: Any) -> None:
        self._field.set_value(value)

    def value(self) -> Any:
        return self._field.value()


class PointListWrapper(FileListWrapper):
    """Shows a `PointList` likewise."""

    kind: ClassVar[type] = PointList


def _of_model_designer(definition: QgsProcessingParameterDefinition, dialog: QWidget) -> Any:
    wrapper = QgsGui.processingGuiRegistry().createModelerParameterWidget(
        dialog.model, dialog.childId, definition, dialog.context
    )
    wrapper.setDialog(dialog)
    return wrapper


def _with_button(field: QWidget, choose: Callable[[], None]) -> QWidget:
    """Return a widget of a field and a button at its right."""
    widget, button = QWidget(), QToolButton()
    button.setText("…")
    button.clicked.connect(lambda: choose())
    layout = QHBoxLayout(widget)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(field, 1)
    layout.addWidget(button)
    return widget
