"""The plugin object of QGIS: it registers the Processing provider, and nothing else."""

from qgis.core import QgsApplication

from .processing_provider.provider import Provider


class Plugin:
    """Registers the provider when QGIS starts, on the desktop or headless.

    Parameters
    ----------
    iface : QgisInterface or None
        None without a desktop; not needed.
    """

    def __init__(self, iface) -> None:
        self.provider = None

    def initProcessing(self) -> None:  # noqa: N802 - QGIS's name
        """Register the provider; all that a headless QGIS calls."""
        self.provider = Provider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self) -> None:  # noqa: N802 - QGIS's name
        """Register the provider on the desktop."""
        self.initProcessing()

    def unload(self) -> None:
        """Take the provider out of the registry."""
        QgsApplication.processingRegistry().removeProvider(self.provider)
