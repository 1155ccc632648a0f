"""The menu Plugins > Ichnograph: the algorithms that most people start with, and the manual."""

from functools import partial
from typing import Any, Callable

from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QDesktopServices, QIcon
from qgis.PyQt.QtWidgets import QAction

from .algorithm import ICONS
from .language import translated
from .manual import page_url

TITLE = "Ichnograph"

DIALOGS = {
    "registerscans": "Register scans to control points…",
    "siteplan": "Site plan from laser scans…",
    "facadedetails": "Details of a facade…",
    "exampledata": "Example data…",
}
"""The algorithms whose dialogs the menu opens."""


class Menu:
    """Shows the menu until the plugin is unloaded.

    Parameters
    ----------
    iface : QgisInterface
    """

    def __init__(self, iface: QgisInterface) -> None:
        self._iface = iface
        self._actions: list[QAction] = []

    def show(self) -> None:
        """Add the entries."""
        for key, text in DIALOGS.items():
            self._add(text, key, partial(_open_dialog, key))
        self._add("Manual", "ichnograph", _open_manual)

    def remove(self) -> None:
        """Remove the entries."""
        for action in self._actions:
            self._iface.removePluginMenu(TITLE, action)
        self._actions.clear()

    def _add(self, text: str, icon: str, opened: Callable[..., None]) -> None:
        action = QAction(QIcon(str(ICONS / f"{icon}.svg")), translated(text), self._iface.mainWindow())
        action.triggered.connect(opened)
        self._iface.addPluginToMenu(TITLE, action)
        self._actions.append(action)


def _open_dialog(key: str, *_: Any) -> None:
    # Processing is a plugin of QGIS, and may be loaded after this one.
    import processing

    processing.execAlgorithmDialog(f"ichnograph:{key}")


def _open_manual(*_: Any) -> None:
    QDesktopServices.openUrl(QUrl(page_url("index")))
