"""The plugin object of QGIS: it registers the Processing provider and, on the desktop, a menu."""

from typing import Optional

from qgis.core import QgsApplication
from qgis.gui import QgisInterface

from .processing_provider.menu import Menu
from .processing_provider.provider import Provider


class Plugin:
    """Registers the provider when QGIS starts, on the desktop or headless.

    Parameters
    ----------
    iface : QgisInterface or None
        None without a desktop.
    """

    def __init__(self, iface: Optional[QgisInterface]) -> None:
        self.provider: Optional[Provider] = None
        self._menu = Menu(iface) if iface else None

    def initProcessing(self) -> None:  # noqa: N802 - QGIS's name
        """Register the provider; a headless QGIS calls only this."""
        self.provider = Provider()
        QgsApplication.processingRegistry().addProvider(self.provider)
        # Its models find the algorithms that they consist of only now.
        self.provider.refreshAlgorithms()

    def initGui(self) -> None:  # noqa: N802 - QGIS's name
        """Register the provider, and add the menu, on the desktop."""
        self.initProcessing()
        if self._menu:
            self._menu.show()

    def unload(self) -> None:
        """Remove the provider from the registry, and the menu."""
        QgsApplication.processingRegistry().removeProvider(self.provider)
        if self._menu:
            self._menu.remove()
