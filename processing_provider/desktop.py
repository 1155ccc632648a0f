"""Where QGIS runs: before a person, or headless."""

from qgis.core import QgsApplication

DESKTOP = "desktop"


def on_desktop() -> bool:
    """Whether a person sees the window of QGIS; qgis_process and scripts show texts as they are."""
    return bool(QgsApplication.platform() == DESKTOP)
